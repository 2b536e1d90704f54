// Prepares a world for the hand at one scale: plans the simplifications, applies them, rounds edges and compiles the
// result. Pure functions, which any thread may call. They may take seconds, so the session runs them as a background
// task. Until the task is done, the hand feels the previous scene.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/core/hand/simplified_words.h"
#include "haptic/compile/compile_haptic.h"
#include "haptic/render/haptic_scene.h"

namespace handrail::core {

struct FeltOrder {
    std::shared_ptr<const Scene> scene;
    int edit = 0;  // number of changes to the world: it increases whenever something is added or removed
    std::optional<compile::SimplifyOptions> simplify;  // how to simplify; none: nothing is simplified
    OpenPortals portals;                               // the portals to which the openings in `simplify` belong
    double world_m_per_hand_m = 1.0, proxy_diameter_hand_m = 0.0, edge_rounding_hand_mm = 0.0;
    double mesh_tolerance_hand_mm = 0.0;  // tolerance for simplifying dense meshes; 0: dense meshes are not simplified
    std::uint32_t world = 0;              // value for HapticScene::world

    // Returns true if both orders lead to a world that feels the same.
    bool same_as(const FeltOrder& other) const;
};

struct FeltWorld {
    // If null, the scene stays the same, because plan and rounding are unchanged.
    std::shared_ptr<const render::HapticScene> haptic;
    compile::Simplification plan;
    OpenPortals portals;
    double rounding_m = 0.0, mesh_tolerance_m = 0.0;
    compile::OwnRounding own_rounding = {};
    std::vector<compile::CoarserMesh> coarser;
};

// Returns the radius for rounding edges. The radius never exceeds that of the proxy. round_edges.h explains the reason
// under "inner corners".
double felt_rounding_m(double edge_rounding_hand_mm, double world_m_per_hand_m, double proxy_radius_m);

// Returns how solids with a radius of their own are rounded. If the person wants sharp edges, or the scene has no such
// solids, the result is the default.
compile::OwnRounding felt_own_rounding(const Scene& scene, double edge_rounding_hand_mm, double world_m_per_hand_m,
                                       double proxy_radius_m);

// Makes the world for `order`. If plan, rounding and tolerance are the same as in `before`, compiles nothing. After a
// request to `stop`, the caller must ignore the result.
FeltWorld make_felt(const FeltOrder& order, const FeltWorld& before, const std::stop_token& stop);

}  // namespace handrail::core
