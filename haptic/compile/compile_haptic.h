// Compiles a Scene to a HapticScene. No other haptic code knows Scene. App thread or background thread.
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

// The source of the material values that the world file does not set.
enum class MaterialSource {
    KeysOnly,  // no source: only the values in the world file are used, as `touch` requires
    Library,   // the library values of a named or guessed material; used for exploring
};

struct CompileOptions {
    MaterialSource materials = MaterialSource::KeysOnly;
    std::uint32_t world =
        // The number HapticScene::world. Pass that of the earlier scene if this scene is the same world with things
        // added or removed. 0: a new world.
        0;
    MeshOptions mesh =
        // How the mesh triangles of each feature and material are simplified, in the scene and in each model.
        kExactMesh;
    // Shade facets, so that the hand feels the curved surface that the facets approximate (mesh_shading.h).
    bool shade_meshes = false;
    // Radius of the convex edges of solids in world metres (round_edges.h); 0: sharp, at no cost.
    double edge_rounding_m = 0.0;
    // How solids with a radius of their own are rounded.
    OwnRounding own_rounding = {};
    // Another thread requests a stop if the scene is no longer needed. compile_haptic() then soon returns null.
    std::stop_token stop;
    // compile_haptic() calls it before it simplifies a dense mesh, which may take seconds.
    std::function<void(FeatureId feature, std::size_t triangles)> simplifies;
};
// Returns the options for exploring a world. `mesh_tolerance_m` is the greatest distance, in world metres, by which a
// simplified dense mesh may differ from the original; 0: no simplification.
CompileOptions exploring(double edge_rounding_m, std::uint32_t world = 0, double mesh_tolerance_m = 0.0);

// Meshes with at least this many triangles in one surface are dense. Fewer triangles cost little time in a tick, and a
// hand at a scale for details can feel each of them.
inline constexpr std::size_t kDenseFrom = 10'000;
// Returns true if the scene has a mesh that exploring() may simplify.
bool has_dense_mesh(const Scene& scene);

// A thing whose mesh was simplified, so that the hand feels fewer triangles than the world file contains.
struct CoarserMesh {
    FeatureId feature;
    std::size_t before = 0, after = 0;  // numbers of triangles, counting only the thing's dense surfaces
    double off_m = 0.0;                 // measured distance between the original and the simplified mesh, in the world

    bool operator==(const CoarserMesh&) const = default;
};

struct CompileReport {
    MeshReport mesh;
    RoundingReport rounding;
    std::vector<CoarserMesh> coarser;  // one entry for each thing
};

// Compiles a scene. Placed models become bodies in the same order; those beyond HapticScene::kMostBodies are left out.
// Solids and movers become convex obstacles (boxes are recognised as boxes), mesh triangles become sheets, liquids
// become volumes. The generation number is unique among the compiled scenes of this process. If `report` is given, the
// function adds its simplifications and roundings to the report.
std::shared_ptr<const render::HapticScene> compile_haptic(const Scene& scene, const CompileOptions& options,
                                                          CompileReport* report = nullptr);
// Compiles the scene with sharp edges and exact meshes. With MaterialSource::Library, meshes are also shaded.
std::shared_ptr<const render::HapticScene> compile_haptic(const Scene& scene, MaterialSource materials);

}  // namespace handrail::compile
