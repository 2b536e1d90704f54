// Handles stairs that a file states but on which nobody can walk: a spiral of sheets under a low edge, or a flight that
// was never drawn. Walkers take them in one go from foot to head, like a lift. Pure function; any thread.
#pragma once

#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

// Adds a link of PassageKind::Climb for each stairs portal of the file, in file order. There must be a place to stand
// at its foot and its head, but no walkable way between them within kBesideStairs_m of the stairs. Costs nothing if the
// file states no stairs.
inline constexpr double kBesideStairs_m = 1.5;
void link_stated_stairs(const Scene& scene, WalkSpace& space);

}  // namespace handrail::navigation
