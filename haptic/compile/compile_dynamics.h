// Scene -> DynamicsScene: the still building, the placed models that are driven, and those that are free. App or
// background thread.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "haptic/render/dynamics_scene.h"
#include "worlds/scene/scene.h"

namespace handrail::compile {

// A placed model that can move freely.
struct FreeThing {
    std::size_t placed = 0;  // index in Scene::placed, and so in HapticScene::bodies
    render::BodyNature nature;
    double density_kg_per_m3 = 0.0;  // > 0: the mass is computed from the volume instead
};

struct DynamicsReport {
    struct Refused {
        std::size_t thing = 0;  // index among the requested things
        render::BodyFault fault = render::BodyFault::None;
    };
    std::vector<Refused> refused;  // these stay driven
    // For each placed model its index in DynamicsScene::driven; kNoBody: it is free, or has no volume.
    std::vector<std::uint32_t> driven;
    std::vector<std::uint32_t> bodies;  // for each placed model its index in DynamicsScene::bodies, or kNoBody
    std::vector<double> mass_kg;        // for each body
};

// Solids and movers that are still part of the building become fixed, with their round shapes; triangles become fixed
// sheets. A free thing needs solids, because a model of triangles alone has no volume. Returns null if nothing is free
// in the end; then there is no engine, no thread and no cost. origin_m: HapticScene::origin_m.
std::shared_ptr<const render::DynamicsScene> compile_dynamics(const Scene& scene, std::span<const FreeThing> free,
                                                              const Vec3& origin_m, DynamicsReport* report = nullptr);

}  // namespace handrail::compile
