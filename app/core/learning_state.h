// What AppCore remembers of learning a place and of a hunt. Plain data; app thread.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/core/hunt.h"
#include "app/core/learning.h"

namespace handrail {

struct LearningState {
    LearningNotes notes;
    double since_s = 0.0;
    std::optional<Place> place;  // the last one asked about
    // The hand's last contact.
    Vec3 hand_m{0.0};
    FeatureId hand_feature = kNoFeature;
    double corner_s = -1e9;
    // The mode that leads: walls, then lanes.
    bool on = false;
    Vec3 base_m{0.0};
    bool walls_done = false, lanes_begun = false;
    std::vector<FeatureId> done;
    std::size_t lanes_told = 0, seen_notes = 0;
    double looked_s = -1e9;
};

struct ClockHunt {
    HuntGround ground;
    std::unique_ptr<BodyWorld> open_world;  // without doors
    Vec3 clock_m{0.0};                      // where one stands at it
    double began_s = 0.0;
    int hints = 0;
};

}  // namespace handrail
