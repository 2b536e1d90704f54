// Scene -> HapticScene: the only haptic code that knows Scene. App or background thread.
#pragma once

#include <memory>
#include <stop_token>

#include "haptic/compile/prepare_mesh.h"
#include "haptic/compile/round_edges.h"
#include "haptic/render/haptic_scene.h"
#include "worlds/scene/scene.h"

namespace handrail {

// Where surfaces get the values that the file does not set.
enum class MaterialSource {
    KeysOnly,  // only keys written in the world count, as `touch` requires
    Library,   // a named or guessed material contributes its library values, for exploring
};

struct CompileOptions {
    MaterialSource materials = MaterialSource::KeysOnly;
    // HapticScene::world of the scene that this one replaces with something added or removed; 0: a new world.
    std::uint32_t world = 0;
    // Processing of mesh triangles of one feature and material, in the scene and in each model.
    MeshOptions mesh = kExactMesh;
    // Makes facets feel like the curved surface that they approximate (mesh_shading.h).
    bool shade_meshes = false;
    // Radius for convex edges of solids, world metres (round_edges.h); 0: sharp, at no cost.
    double edge_rounding_m = 0.0;
    std::stop_token
        // Requested from another thread to cancel; the result is then null and comes soon.
        stop;
};
// The options for a person who explores a world.
CompileOptions exploring(double edge_rounding_m, std::uint32_t world = 0);

struct CompileReport {
    MeshReport mesh;
    RoundingReport rounding;
};

// Placed models become bodies, in their order; those beyond HapticScene::kMostBodies are left out. Solids and movers
// become convex obstacles (boxes are recognised as boxes), mesh triangles become sheets, liquids become volumes. The
// generation is unique among the compiled scenes of this process. What was done is added to the report, if one is
// given.
std::shared_ptr<const HapticScene> compile_haptic(const Scene& scene, const CompileOptions& options,
                                                  CompileReport* report = nullptr);
// Compiles everything sharp and exact; with a library's materials also with shading.
std::shared_ptr<const HapticScene> compile_haptic(const Scene& scene, MaterialSource materials);

}  // namespace handrail
