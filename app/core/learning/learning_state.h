// The state of PlaceLearning: what is remembered of learning the places of one world. Plain data; app thread; world
// metres, seconds of the session's clock.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "app/core/learning/learning.h"
#include "app/core/learning/learnt_file.h"

namespace handrail::core {

// Progress in one room, until its world is left.
struct RoomLearning {
    std::optional<Learnt> learnt;  // made on the first query
    double spent_s = 0.0;
    // In the guided mode:
    std::optional<Vec3> base_m;
    bool walls_done = false;
    std::vector<FeatureId> done;  // announced walls
    std::size_t lanes_told = 0;
    bool to_base = false;  // a wall was announced since the person was last at the base
    bool lanes_done = false;
    bool remembered = false;  // from an earlier session; the walls already announced then are looked up once
};

struct LearningState {
    LearningNotes notes;
    std::map<std::uint32_t, RoomLearning> rooms;  // by their number in the room graph
    double last_s = 0.0, unplaced_s = 0.0;        // unplaced_s: time spent while the room was not yet known
    // The last contact of the hand.
    Vec3 hand_m{0.0};
    FeatureId hand_feature = kNoFeature;
    double corner_s = -1e9;
    // The guided mode: walls first, then lanes.
    bool on = false;
    std::uint32_t room = navigation::kNothing;  // the room in which the person is guided
    std::size_t seen_notes = 0;
    double looked_s = -1e9;
    // Stored between sessions:
    KeptLearning kept;  // as it was read
    bool keeps = false;
    std::optional<Error> fault;  // why it could not be read; then it is not overwritten
    std::size_t kept_notes = 0;
    double kept_s = 0.0, began_s = 0.0;
};

}  // namespace handrail::core
