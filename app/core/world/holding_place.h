// Finds a place where a walker stays in the world instead of falling out of it. A pure function for the app thread. It
// traces up to about 700 columns, so use it only in rare cases.
#pragma once

#include <optional>
#include <span>

#include "app/core/world/walker.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

// a walker that is this far below the lowest part of the world has fallen out of the world
inline constexpr double kOutOfWorld_m = 20.0;

// Returns where the walker comes to rest. The places in `preferred` are tried in order. If none of them holds the
// walker, returns the nearest place to the first of them that holds the walker, on a grid over the world or on top of a
// thing. Returns no value if no ground of this world holds the walker.
std::optional<Vec3> place_that_holds(const Scene& scene, const WalkerWorld& world, const WalkerSize& size,
                                     std::span<const Vec3> preferred);

}  // namespace handrail::core
