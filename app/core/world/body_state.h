// The person's body: where it is, which way it faces, how it came there. Plain state; app thread only.
#pragma once

#include <memory>
#include <vector>

#include "app/core/world/walker.h"

namespace handrail {

struct BodyState {
    std::unique_ptr<Walker> walker;  // null: in no world yet
    double heading_rad = 0.0;        // where it faces now
    int times_put = 0;               // how often it was put somewhere else instead of walking there
    // Where the last turn leads; reached at a bounded rate, so that the hand is not thrown.
    double heading_goal_rad = 0.0;
    FeatureId ground = kNoFeature;  // what it stands on
    std::vector<Vec3> crumbs_m;     // places a quarter of a metre apart, the newest last, since it was last set down

    const Vec3& feet_m() const { return walker->state().feet_m; }
    Vec3 ears_m() const {
        return (walker ? feet_m() : Vec3(0.0)) + Vec3(0.0, 0.0, walker ? walker->size().eye_height_m : 1.6);
    }
};

}  // namespace handrail
