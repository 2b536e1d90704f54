// What is remembered of learning the places of one world: PlaceLearning's state. Plain data; app thread; metres of the
// world, seconds of the session's clock.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "app/core/learning/learning.h"
#include "app/core/learning/learnt_file.h"

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
    bool to_base = false;  // a wall was told of since one was at the base
    bool lanes_done = false;
    bool remembered = false;  // from a session before; which walls were told of then is looked up once
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
    // Kept from session to session.
    KeptLearning kept;  // as it was read
    bool keeps = false;
    std::optional<Error> fault;  // why it could not be read: then nothing is written over it
    std::size_t kept_notes = 0;
    double kept_s = 0.0, began_s = 0.0;
};

}  // namespace handrail
