// How near a walker is to a wall. It measures to the line of the wall, as a person with a cane knows it, whatever
// stands along that line. A pure function over an immutable world; app thread; some 40 rays.
#pragma once

#include "app/core/world/walker_world.h"

namespace handrail::core {

// From the walker's centre, level; 1e9: no wall within 2 m.
// A wall continues across what interrupts it: a window or its recess, a door, open or shut, or a board on it. The gap
// between two pieces may be at most kWallGoesOn_m.
// Furniture so near to a wall that nobody can walk between is part of it: following a bookshelf is like following the
// wall behind it.
// A pane or leaf with nothing behind it counts as 0.2 m back in its wall, the usual depth, unless a piece of wall next
// to it gives the true one.
inline constexpr double kWallGoesOn_m = 2.5;
double wall_beside_m(const WalkerWorld& world, const Vec3& feet_m);

}  // namespace handrail::core
