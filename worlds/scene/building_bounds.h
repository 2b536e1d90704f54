// The size of the building, without the ground that readers lay round it and without outdoor parts of the file, such as
// paths and lawns. Pure; any thread. World metres.
#pragma once

#include "worlds/scene/scene.h"

namespace handrail {

// The bounds of the rooms that the file states and of the parts next to them. If the file states no rooms, the bounds
// of everything except the ground that readers laid. Empty if there is nothing.
Aabb building_bounds_m(const Scene& scene);

}  // namespace handrail
