// What a hand feels of a world at a scale: planned, simplified, rounded and compiled. Pure functions; any thread.
// It may take seconds, so it is a background task; until it is there the hand feels what there was.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "app/core/hand/simplified_words.h"
#include "haptic/render/haptic_scene.h"

namespace handrail {

struct FeltOrder {
    std::shared_ptr<const Scene> scene;
    int edit = 0;                             // rises when something was added to the world or taken away
    std::optional<SimplifyOptions> simplify;  // none: nothing is too small
    OpenPortals portals;                      // that its openings are those of
    double world_m_per_hand_m = 1.0, ball_diameter_hand_m = 0.0, edge_rounding_hand_mm = 0.0;
    std::uint32_t world = 0;  // HapticScene::world

    // Would it be felt the same?
    bool same_as(const FeltOrder& other) const;
};

struct FeltWorld {
    std::shared_ptr<const HapticScene> haptic;  // null: as before, by the same plan
    Simplification plan;
    OpenPortals portals;
    double rounding_m = 0.0;
};

// Never more than the ball's radius: see round_edges.h about inner corners.
double felt_rounding_m(double edge_rounding_hand_mm, double world_m_per_hand_m, double ball_radius_m);

// Nothing is made anew where plan and rounding turn out to be those of `before`. `stop`: the result counts for nothing.
FeltWorld make_felt(const FeltOrder& order, const FeltWorld& before, const std::stop_token& stop);

}  // namespace handrail
