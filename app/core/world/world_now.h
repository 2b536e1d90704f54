// The world with its things where they are by now, and what a body meets of it made anew. Functions of plain state; app
// thread, but with_things() on any.
#pragma once

#include <vector>

#include "app/core/world/body_state.h"
#include "app/core/world/world_state.h"

namespace handrail {

// Where the things of a world are now, and those that are doors' leaves at rest.
struct ThingsNow {
    std::vector<Placement> things, at_rest;  // the latter by mover
    std::vector<int> thing_of_mover;
};
ThingsNow things_now(const WorldState& world);

Scene with_things(const Scene& scene, const ThingsNow& now);
inline Scene world_now(const WorldState& world) { return with_things(*world.scene, things_now(world)); }

// After anything of the world has moved: what a body bumps into is where it is now; the body goes on where it stood.
void rebuild_solids(WorldState& world, BodyState& body);

}  // namespace handrail
