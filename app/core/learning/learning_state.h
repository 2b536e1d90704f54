// Defines the state of PlaceLearning: the progress of learning the places of one world. Plain data for the app thread,
// in world metres and seconds of the session's clock.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "app/core/learning/diary.h"
#include "app/core/learning/learning.h"
#include "app/core/learning/learnt_file.h"

namespace handrail::core {

// The progress in one room. It is kept until the walker enters another world.
struct RoomLearning {
    std::optional<Learnt> learnt;  // the parts that are known; made when they are needed for the first time
    double spent_s = 0.0;
    double spent_before_s = 0.0;  // share of `spent_s` from earlier sessions
    // The following fields belong to the guided mode.
    std::optional<Vec3> base_m;
    bool walls_done = false;
    std::vector<FeatureId> done;  // walls that have been announced as done
    std::size_t lanes_announced = 0;
    bool to_base = false;  // true: a wall has been announced since the person was last at the base
    bool lanes_done = false;
    // True: the progress comes from an earlier session, so walls that are already done are not announced again.
    bool remembered = false;
};

struct LearningState {
    LearningNotes notes;
    std::map<std::uint32_t, RoomLearning> rooms;  // the key is the number of the room in the room graph
    double last_s = 0.0, unplaced_s = 0.0;        // `unplaced_s`: time spent in a room that was not yet known
    // The following fields describe the last contact of the hand.
    Vec3 hand_m{0.0};
    FeatureId hand_feature = kNoFeature;
    double corner_s = -1e9;
    // The following fields describe the guided mode, which begins with the walls and continues with the lanes.
    bool on = false;
    std::uint32_t room = navigation::kNothing;  // the room in which the person is being guided
    std::size_t seen_notes = 0;
    double looked_s = -1e9;
    // The following fields describe the progress that is stored between sessions.
    KeptLearning kept;  // progress as it was read from the side file
    bool keeps = false;
    std::optional<Error> fault;  // why the stored progress could not be read; if set, it is not overwritten
    std::size_t kept_notes = 0;
    double kept_s = 0.0, began_s = 0.0;
    std::vector<DiaryEntry> diary_before;  // the diary as it was when the world was entered
};

}  // namespace handrail::core
