// Compiles a Scene to a DynamicsScene. That scene contains the fixed building, the placed models that Handrail moves,
// and the placed models that can move freely. App thread or background thread.
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
    double density_kg_per_m3 = 0.0;  // if > 0, the mass is computed from the volume and this density
};

struct DynamicsReport {
    struct Refused {
        std::size_t thing = 0;  // index of the refused thing in `free`
        render::BodyFault fault = render::BodyFault::None;
    };
    std::vector<Refused> refused;  // things that cannot be free bodies; they stay driven
    // For each placed model, its index in DynamicsScene::driven, or kNoBody if it is free or has no volume.
    std::vector<std::uint32_t> driven;
    std::vector<std::uint32_t> bodies;  // for each placed model its index in DynamicsScene::bodies, or kNoBody
    std::vector<double> mass_kg;        // for each body in DynamicsScene::bodies
};

// Compiles the dynamics scene. Solids, and movers that are not free, become fixed parts of the building and keep their
// round shapes. Mesh triangles become fixed sheets. A free thing needs solids, because a model made only of triangles
// has no volume. If no thing is free in the end, the function returns null, and no physics engine or thread is started.
// `origin_m` is HapticScene::origin_m.
std::shared_ptr<const render::DynamicsScene> compile_dynamics(const Scene& scene, std::span<const FreeThing> free,
                                                              const Vec3& origin_m, DynamicsReport* report = nullptr);

}  // namespace handrail::compile
