// Finds a place where a walker stays in the world instead of falling out of it. A pure function; app thread. It traces
// up to about 700 columns, so use it only for rare events.
#pragma once

#include <optional>
#include <span>

#include "app/core/world/walker.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

inline constexpr double kOutOfWorld_m = 20.0;  // a walker this far below the lowest place has fallen out of the world

// Where the walker comes to rest if placed at the first of `wishes` that holds it, in order of preference. If none
// does, the nearest place to the first wish that does, on the ground of a grid over the world or on top of a thing. No
// value: no ground of this world holds a walker.
std::optional<Vec3> place_that_holds(const Scene& scene, const WalkerWorld& world, const WalkerSize& size,
                                     std::span<const Vec3> wishes);

}  // namespace handrail::core
