// How large the building is: without the ground that readers lay round it, and without what files have outside of it,
// such as paths and lawns. Pure; any thread. World metres.
#pragma once

#include "worlds/scene/scene.h"

namespace handrail {

// Of rooms as the file states them and of what stands at them; of a file without stated rooms all but the ground that
// readers laid. Empty where there is nothing.
Aabb building_bounds_m(const Scene& scene);

}  // namespace handrail
