// The world with its things at their present places, and the solids for walking rebuilt from that. Functions of plain
// state; app thread, except with_things(), which any thread may call.
#pragma once

#include <vector>

#include "app/core/world/walker_state.h"
#include "app/core/world/world_state.h"

namespace handrail::core {

// The present places of things, and the places at rest of door leaves.
struct ThingsNow {
    std::vector<Placement> things, at_rest;  // the latter by mover
    std::vector<int> thing_of_mover;
};
ThingsNow things_now(const WorldState& world);

Scene with_things(const Scene& scene, const ThingsNow& now);
inline Scene world_now(const WorldState& world) { return with_things(*world.scene, things_now(world)); }

// Rebuilds the solids after anything in the world has moved; the walker stays where it is.
void rebuild_solids(WorldState& world, WalkerState& body);

}  // namespace handrail::core
