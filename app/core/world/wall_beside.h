// How near a body walks to a wall: to the line of it, as who follows a wall with a cane knows it, whatever stands in
// that line. A pure function over an immutable world; app thread; some 40 rays.
#pragma once

#include "app/core/world/body_world.h"

namespace handrail {

// From the body's middle, level; 1e9: no wall within 2 m. A wall goes on across what parts it: a window or its recess,
// a door, open or shut, a board that hangs on it; but no farther than kWallGoesOn_m from one piece of it to the next.
// What stands so near before a wall that nobody walks between them is a part of it: one goes along a bookshelf as along
// the wall behind. A pane or leaf with nothing behind it counts as so far back in its wall as is usual, 0.2 m, where no
// piece of wall beside it tells.
inline constexpr double kWallGoesOn_m = 2.5;
double wall_beside_m(const BodyWorld& world, const Vec3& feet_m);

}  // namespace handrail
