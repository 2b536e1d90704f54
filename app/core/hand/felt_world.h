// Prepares a world for the hand at one scale: plans simplifications, applies them, rounds edges and compiles the
// result. Pure functions; any thread. It may take seconds, so it runs as a background task; until it is done, the hand
// feels the previous scene.
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
    int edit = 0;  // increases whenever something is added to the world or removed from it
    std::optional<compile::SimplifyOptions> simplify;  // none: nothing is simplified
    OpenPortals portals;                               // openings for `simplify` are those of these portals
    double world_m_per_hand_m = 1.0, ball_diameter_hand_m = 0.0, edge_rounding_hand_mm = 0.0;
    double mesh_tolerance_hand_mm = 0.0;  // of dense meshes; 0: they stay as they are
    std::uint32_t world = 0;              // HapticScene::world

    // True if the result would feel the same.
    bool same_as(const FeltOrder& other) const;
};

struct FeltWorld {
    std::shared_ptr<const render::HapticScene> haptic;  // null: unchanged, because plan and rounding are the same
    compile::Simplification plan;
    OpenPortals portals;
    double rounding_m = 0.0, mesh_tolerance_m = 0.0;
    std::vector<compile::CoarserMesh> coarser;
};

// Never more than the proxy's radius; round_edges.h explains why, under inner corners.
double felt_rounding_m(double edge_rounding_hand_mm, double world_m_per_hand_m, double ball_radius_m);

// Nothing is made again if plan, rounding and tolerance turn out to be those of `before`. `stop`: the result counts for
// nothing.
FeltWorld make_felt(const FeltOrder& order, const FeltWorld& before, const std::stop_token& stop);

}  // namespace handrail::core
