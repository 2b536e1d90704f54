// Computes the world with its things at their present positions, and rebuilds the solids for walking from that world.
// Functions of plain state for the app thread. Any thread may call with_things().
#pragma once

#include <vector>

#include "app/core/world/walker_state.h"
#include "app/core/world/world_state.h"

namespace handrail::core {

// The present positions of all things, and the rest positions of the movers.
struct ThingsNow {
    std::vector<Placement> things, at_rest;  // `at_rest` is in the order of the movers
    std::vector<int> thing_of_mover;
};
ThingsNow things_now(const WorldState& world);

Scene with_things(const Scene& scene, const ThingsNow& now);
inline Scene world_now(const WorldState& world) { return with_things(*world.scene, things_now(world)); }

// Rebuilds the solids. Call it after anything in the world has moved. The walker stays where it is.
void rebuild_solids(WorldState& world, WalkerState& avatar);

}  // namespace handrail::core
