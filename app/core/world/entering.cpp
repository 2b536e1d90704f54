#include "app/core/world/entering.h"

#include <algorithm>
#include <span>

#include "haptic/compile/compile_dynamics.h"
#include "haptic/compile/compile_haptic.h"
#include "worlds/scene/models.h"

namespace handrail::core {
namespace {

// Marks the door nearest to the start as the base's door.
void mark_base_door(Scene& scene, const Vec3& feet_m) {
    Feature* nearest = nullptr;
    double nearest_m = 1.2;
    for (Feature& feature : scene.features) {
        feature.base = false;
        if (feature.kind != FeatureKind::Door || feature.bounds_m.empty()) continue;
        const double distance =
            glm::length(glm::clamp(feet_m, feature.bounds_m.min_m, feature.bounds_m.max_m) - feet_m);
        if (distance >= nearest_m) continue;
        nearest_m = distance;
        nearest = &feature;
    }
    if (nearest) nearest->base = true;
}

// Returns the scene of the movable bodies, or null if nothing is movable.
std::shared_ptr<const render::DynamicsScene> moves_freely(const Scene& scene, std::span<const int> thing_of_body) {
    std::vector<compile::FreeThing> free;
    for (std::size_t i = 0; i < thing_of_body.size(); ++i) {
        if (thing_of_body[i] < 0) continue;
        const FreeBody& body = scene.bodies[i];
        free.push_back({static_cast<std::size_t>(thing_of_body[i]), {}, 0.0});
        free.back().nature.mass_kg = body.mass_kg;
        free.back().nature.friction = body.friction;
        free.back().nature.friction_static = body.friction_static;
        free.back().nature.elasticity = body.elasticity;
        free.back().nature.rolling = body.rolling;
        if (body.string_n_per_m > 0.0) free.back().nature.string = {body.string_at_m, body.string_n_per_m};
    }
    if (free.empty()) return nullptr;
    return compile::compile_dynamics(scene, free, scene.bounds_m.empty() ? Vec3(0.0) : scene.bounds_m.centre_m());
}

}  // namespace

EnteringWorld make_ready_at(std::shared_ptr<const Scene> scene, const Vec3& feet_m, double heading_rad) {
    EnteringWorld world;
    std::vector<int> thing_of_body;
    Scene entered = with_bodies_apart(with_movers_apart(*scene, render::HapticScene::kMostBodies, world.thing_of_mover),
                                      render::HapticScene::kMostBodies, thing_of_body);
    mark_base_door(entered, feet_m);
    world.file = std::move(scene);
    world.scene = std::make_shared<const Scene>(std::move(entered));
    world.moves_freely = moves_freely(*world.scene, thing_of_body);
    world.feet_m = feet_m;
    world.heading_rad = heading_rad;
    world.body = std::make_unique<WalkerWorld>(world.scene);
    return world;
}

EnteringWorld make_ready(std::shared_ptr<const Scene> scene) {
    Vec3 feet{0.0};
    double heading = 0.0;
    const auto base = std::find_if(scene->starts.begin(), scene->starts.end(), [](const Start& s) { return s.base; });
    if (base != scene->starts.end()) {
        feet = base->feet_m;
        heading = base->heading_rad;
    } else if (!scene->starts.empty()) {
        feet = scene->starts.front().feet_m;
        heading = scene->starts.front().heading_rad;
    } else if (!scene->bounds_m.empty()) {
        // If the file has no start, the walker starts on the ground in front of the middle of the south side, facing
        // the building.
        const Vec3 centre = scene->bounds_m.centre_m();
        feet = Vec3(centre.x, scene->bounds_m.min_m.y - 1.0, scene->bounds_m.min_m.z);
    }
    return make_ready_at(std::move(scene), feet, heading);
}

EnteringWorld make_ready_to_touch(std::shared_ptr<const Scene> scene, const std::stop_token& stop) {
    EnteringWorld world = make_ready(std::move(scene));
    compile::CompileOptions options = compile::exploring(0.0);
    options.stop = stop;
    world.sharp = compile::compile_haptic(*world.scene, options);
    return world;
}

}  // namespace handrail::core
