// Connects the ends of stairs that a file states but on which nobody can walk, such as a spiral of sheets under a low
// edge, or a flight that was never drawn. A link moves walkers directly from the foot to the head, like a lift. Pure
// function; any thread may call it.
#pragma once

#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

// Adds a link of PassageKind::Climb for each stairs portal of the file, in file order. It does so only if people can
// stand at the foot and at the head, but cannot walk between them within kNextToStairs_m of the stairs. Costs nothing
// if the file states no stairs.
inline constexpr double kNextToStairs_m = 1.5;
void link_stated_stairs(const Scene& scene, WalkSpace& space);

}  // namespace handrail::navigation
