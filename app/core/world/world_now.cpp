#include "app/core/world/world_now.h"

#include "worlds/scene/models.h"

namespace handrail::core {

ThingsNow things_now(const WorldState& world) {
    ThingsNow now{world.things.all(), {}, world.thing_of_mover};
    for (std::uint32_t i = 0; i < world.movers.size(); ++i) now.at_rest.push_back(world.movers.at_rest(i));
    return now;
}

Scene with_things(const Scene& scene, const ThingsNow& now) {
    Scene world = scene;
    for (std::size_t i = 0; i < now.things.size(); ++i) move_placed(world, i, now.things[i]);
    // The bounds of a door also include its leaf at rest, so that an open door can still be found at its doorway.
    for (std::uint32_t i = 0; i < world.movers.size(); ++i) {
        Feature& feature = world.features[world.movers[i].feature.value];
        if (feature.kind == FeatureKind::Door && now.thing_of_mover[i] >= 0)
            feature.bounds_m.include(placed_bounds(
                world.placed[static_cast<std::size_t>(now.thing_of_mover[i])].model->bounds_m, now.at_rest[i]));
    }
    return world;
}

void rebuild_solids(WorldState& world, WalkerState& avatar) {
    const WalkerMotion stood = avatar.walker->state();
    // The walker keeps its size, because a larger walker might be inside a wall.
    const WalkerSize size = avatar.walker->size();
    avatar.walker.reset();
    world.solids = std::make_unique<WalkerWorld>(*world.solids, world.scene, world.things.all());
    avatar.walker = std::make_unique<Walker>(*world.solids, size);
    avatar.walker->resume(stood);
}

}  // namespace handrail::core
