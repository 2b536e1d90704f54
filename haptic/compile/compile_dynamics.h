// Scene -> DynamicsScene: the building as it stands, placed models that are driven, and those that are free. App or
// worker thread.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "haptic/render/dynamics_scene.h"
#include "worlds/scene/scene.h"

namespace handrail {

// A placed model that is free to move.
struct FreeThing {
    std::size_t placed = 0;  // place in Scene::placed, and so in HapticScene::bodies
    BodyNature nature;
    double density_kg_per_m3 = 0.0;  // > 0: the mass follows from the volume instead
};

struct DynamicsReport {
    struct Refused {
        std::size_t thing = 0;  // of the things asked for
        BodyFault fault = BodyFault::None;
    };
    std::vector<Refused> refused;  // these stay driven
    std::vector<std::uint32_t>
        driven;  // per placed model its place in DynamicsScene::driven; kNoBody: free, or nothing of it has volume
    std::vector<std::uint32_t> bodies;  // likewise in DynamicsScene::bodies
    std::vector<double> mass_kg;        // per body
};

// Solids and movers that are still part of the building are fixed, with their round shapes; so are triangles, as
// sheets. A free thing needs solids: a model of triangles alone has no volume. Null when nothing is free in the end:
// then there is no engine and no thread, and nothing costs anything. origin_m: HapticScene::origin_m.
std::shared_ptr<const DynamicsScene> compile_dynamics(const Scene& scene, std::span<const FreeThing> free,
                                                      const Vec3& origin_m, DynamicsReport* report = nullptr);

}  // namespace handrail
