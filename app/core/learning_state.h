// What AppCore remembers of learning a place and of a hunt. Plain data; app thread.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/core/hunt.h"
#include "app/core/learning.h"

namespace handrail {

// Of one room, for as long as its world is not left.
struct RoomLearning {
    std::optional<Learnt> learnt;  // looked at when first asked about
    double spent_s = 0.0;
    // In the mode that leads.
    std::optional<Vec3> base_m;
    bool walls_done = false;
    std::vector<FeatureId> done;  // walls told of
    std::size_t lanes_told = 0;
};

struct LearningState {
    LearningNotes notes;
    std::map<std::uint32_t, RoomLearning> rooms;  // by their number in the room graph
    double last_s = 0.0, unplaced_s = 0.0;        // spent before it is known in which room
    // The hand's last contact.
    Vec3 hand_m{0.0};
    FeatureId hand_feature = kNoFeature;
    double corner_s = -1e9;
    // The mode that leads: walls, then lanes.
    bool on = false;
    std::uint32_t room = kNothing;  // the one led in
    std::size_t seen_notes = 0;
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
