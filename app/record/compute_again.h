// Computes a recorded session again. A new session receives everything that the recorded session received. Each of its
// three loops (session, hands and ears) reads from the other loops exactly what it read during the recording. The new
// session must say the same lines in the same order as the recorded one. This tests the program, and helps to
// investigate a reported fault. One thread; it runs as fast as it can.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/scenario/read_request.h"
#include "app/record/input_text.h"
#include "app/record/recording.h"
#include "worlds/base/result.h"

namespace handrail::record {

// Reads the world's file that a recording names. Fails with a sentence if the file cannot be read, or if it has changed
// since the recording.
Result<std::shared_ptr<const Scene>> read_recorded_scene(const RecordedWorld& world, const core::WorldReader& read);

struct ComputedAgain {
    std::vector<SaidLine> said;
    double until_s = 0.0;  // The computation reached this time, counted from the beginning of the recording.
    // True if the recording or the computation ended early. Lines after `until_s` must then not be compared.
    bool cut = false;
    // `ticks`: how many ticks of the hands were computed. `other_forces`: in how many of them the force differs from
    // the recorded one by more than rounding to a millinewton.
    std::size_t ticks = 0, other_forces = 0;
    // Sentences that say why the computation is not complete, or why lines may differ.
    std::vector<std::string> remarks;
};

// Computes the session again. Fails with a sentence if a world cannot be read or a line is invalid. Computed lines are
// compared with recorded lines as text, so the current spoken language must be that of the recording.
Result<ComputedAgain> compute_again(const Recording& recording, const core::WorldReader& read);

// The first line that differs between the recording and the computation.
struct LineDifference {
    std::size_t line = 0;            // index among all lines that were said, counted from 0
    std::string recorded, computed;  // the two lines; empty if there is no such line
};
std::optional<LineDifference> first_difference(const Recording& recording, const ComputedAgain& again);

}  // namespace handrail::record
