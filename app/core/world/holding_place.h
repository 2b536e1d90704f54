// Where a body that is set down stays in the world instead of falling out of it. A pure function; app thread. It traces
// up to about 700 columns, so it is for rare events only.
#pragma once

#include <optional>
#include <span>

#include "app/core/world/walker.h"
#include "worlds/scene/scene.h"

namespace handrail {

inline constexpr double kOutOfWorld_m = 20.0;  // a body that far below the lowest place has fallen out of the world

// Where the body comes to rest if it is set down at the first of `wishes` that holds it, the most wanted first. If none
// does, the place nearest to the first wish: on the ground of a grid over the world, or on top of one of its things.
// Nothing: no ground of this world holds a body.
std::optional<Vec3> place_that_holds(const Scene& scene, const BodyWorld& world, const BodySize& size,
                                     std::span<const Vec3> wishes);

}  // namespace handrail
