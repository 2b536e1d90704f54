// Stairs that a file states and on which no body walks: a spiral of sheets under a low edge, a flight that was never
// drawn. One takes them in one go, from their foot to their head, as one takes a lift. Pure function; any thread.
#pragma once

#include "worlds/navigation/walk_space.h"

namespace handrail {

// Adds a link, PassageKind::Climb, for each of StatedBuilding::portals that is stairs, has a place to stand at its foot
// and at its head, and no way on foot from one to the other within kBesideStairs_m of it. In file order. Costs nothing
// where the file states no stairs.
inline constexpr double kBesideStairs_m = 1.5;
void link_stated_stairs(const Scene& scene, WalkSpace& space);

}  // namespace handrail
