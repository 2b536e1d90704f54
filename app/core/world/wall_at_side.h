// Measures how near a walker is to a wall. The distance is to the line of the wall, as a person with a cane would
// follow it, whatever stands along that line. A pure function over an immutable world, for the app thread. It costs
// some 40 rays.
#pragma once

#include "app/core/world/walker_world.h"

namespace handrail::core {

// Returns the horizontal distance from the walker's centre to a wall, or 1e9 if there is no wall within 2 m.
// - A wall continues across interruptions of at most kWallGoesOn_m: a window or its recess, an open or shut door, or
//   a board.
// - Furniture so near to a wall that nobody can walk between them is part of the wall. Following a bookshelf is like
//   following the wall behind it.
// - A pane or door leaf with nothing behind it is assumed to be 0.2 m back in its wall, which is the usual depth. If a
//   piece of wall next to it shows the true depth, that depth is used.
inline constexpr double kWallGoesOn_m = 2.5;
double wall_at_side_m(const WalkerWorld& world, const Vec3& feet_m);

}  // namespace handrail::core
