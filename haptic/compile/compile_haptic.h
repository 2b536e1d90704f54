// Scene -> HapticScene: the only haptic code that knows Scene. App or worker thread.
#pragma once

#include <memory>
#include <stop_token>

#include "haptic/compile/prepare_mesh.h"
#include "haptic/compile/round_edges.h"
#include "haptic/render/haptic_scene.h"
#include "worlds/scene/scene.h"

namespace handrail {

// Which values surfaces get that the file leaves open.
enum class MaterialSource {
    KeysOnly,  // only keys written in the world count (the `touch` contract)
    Library,   // a named or guessed material brings its library values (exploring)
};

struct CompileOptions {
    MaterialSource materials = MaterialSource::KeysOnly;
    // HapticScene::world of the scene that this one follows with something added or removed; 0: another world.
    std::uint32_t world = 0;
    // What is done to mesh triangles of one feature and material, of the scene and of each model.
    MeshOptions mesh = kExactMesh;
    bool shade_meshes = false;     // let facets be felt as the curve they stand for (mesh_shading.h)
    double edge_rounding_m = 0.0;  // of convex edges of solids, world metres (round_edges.h); 0: sharp, at no cost
    std::stop_token
        stop;  // asked from another thread: what is being made is not wanted any more, and null comes back soon
};
// As somebody who explores feels a world.
CompileOptions exploring(double edge_rounding_m, std::uint32_t world = 0);

struct CompileReport {
    MeshReport mesh;
    RoundingReport rounding;
};

// Placed models become bodies, in their order; beyond HapticScene::kMostBodies they are left out. Solids and movers
// become convex obstacles (boxes recognised as boxes), mesh triangles become sheets, liquids become volumes. The
// generation is a number that differs for every compiled scene of this process. What was done is added to the report
// where one is given.
std::shared_ptr<const HapticScene> compile_haptic(const Scene& scene, const CompileOptions& options,
                                                  CompileReport* report = nullptr);
// Everything sharp and exact; a library's materials bring shading too.
std::shared_ptr<const HapticScene> compile_haptic(const Scene& scene, MaterialSource materials);

}  // namespace handrail
