// Scene -> HapticScene: the only haptic code that knows Scene. App or background thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "haptic/compile/prepare_mesh.h"
#include "haptic/compile/round_edges.h"
#include "haptic/render/haptic_scene.h"
#include "worlds/scene/scene.h"

namespace handrail::compile {

// Where surfaces get the values that the file does not set.
enum class MaterialSource {
    KeysOnly,  // only keys written in the world count, as `touch` requires
    Library,   // a named or guessed material contributes its library values, for exploring
};

struct CompileOptions {
    MaterialSource materials = MaterialSource::KeysOnly;
    std::uint32_t world =
        0;  // HapticScene::world of the scene that this one follows with something added or removed; 0: another world
    MeshOptions mesh =
        kExactMesh;  // what is done to mesh triangles of one feature and material, of the scene and of each model
    bool shade_meshes = false;     // let facets be felt as the curve they stand for (mesh_shading.h)
    double edge_rounding_m = 0.0;  // of convex edges of solids, world metres (round_edges.h); 0: sharp, at no cost
    // Requested from another thread if the scene is not wanted any more: null is then returned soon.
    std::stop_token stop;
    // Called before a dense mesh is simplified, which may take seconds.
    std::function<void(FeatureId feature, std::size_t triangles)> simplifies;
};
// As somebody who explores feels a world. mesh_tolerance_m: how far dense meshes may be off in the world; 0: not at
// all.
CompileOptions exploring(double edge_rounding_m, std::uint32_t world = 0, double mesh_tolerance_m = 0.0);

// Meshes with at least this many triangles in one surface are dense. Fewer cost a tick of the hand little, and can be
// felt one by one at scales for details.
inline constexpr std::size_t kDenseFrom = 10'000;
// Is there a mesh that exploring() may simplify?
bool has_dense_mesh(const Scene& scene);

// A thing whose mesh the hand feels with fewer triangles than it has.
struct CoarserMesh {
    FeatureId feature;
    std::size_t before = 0, after = 0;  // triangles, of its dense surfaces alone
    double off_m = 0.0;                 // measured between both, in the world

    bool operator==(const CoarserMesh&) const = default;
};

struct CompileReport {
    MeshReport mesh;
    RoundingReport rounding;
    std::vector<CoarserMesh> coarser;  // each thing once
};

// Placed models become bodies, in their order; those beyond HapticScene::kMostBodies are left out. Solids and movers
// become convex obstacles (boxes are recognised as boxes), mesh triangles become sheets, liquids become volumes. The
// generation is unique among the compiled scenes of this process. What was done is added to the report, if one is
// given.
std::shared_ptr<const render::HapticScene> compile_haptic(const Scene& scene, const CompileOptions& options,
                                                          CompileReport* report = nullptr);
// Compiles everything sharp and exact; with a library's materials also with shading.
std::shared_ptr<const render::HapticScene> compile_haptic(const Scene& scene, MaterialSource materials);

}  // namespace handrail::compile
