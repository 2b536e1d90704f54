// Stores the state of the walker: its position, direction and path. Plain state for the app thread only.
#pragma once

#include <memory>
#include <vector>

#include "app/core/world/walker.h"

namespace handrail::core {

struct WalkerState {
    std::unique_ptr<Walker> walker;  // null: no world has been entered
    double heading_rad = 0.0;        // present direction of the walker
    int times_put = 0;               // how often the walker was placed elsewhere instead of walking
    // Direction after the present turn. `heading_rad` approaches it at a limited rate, so that the turn does not throw
    // the hand.
    double heading_goal_rad = 0.0;
    FeatureId ground = kNoFeature;  // feature on which the walker stands
    bool cane_out = false;          // true: the walker probes the ground ahead with the virtual cane
    // The walker's path since it was last placed: points a quarter of a metre apart, the newest last.
    std::vector<Vec3> crumbs_m;

    const Vec3& feet_m() const { return walker->state().feet_m; }
    Vec3 ears_m() const {
        return (walker ? feet_m() : Vec3(0.0)) + Vec3(0.0, 0.0, walker ? walker->size().eye_height_m : 1.6);
    }
};

}  // namespace handrail::core
