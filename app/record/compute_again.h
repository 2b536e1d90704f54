// Computes a recorded session again. Everything that reached it is given to a new session, and each of the three loops
// reads exactly what it read from the others then. The new session must say the same lines in the same order. This
// tests the program, and helps to investigate a reported fault. One thread; it runs as fast as it can.
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

// Reads a world that a recording names from its file. Fails with a sentence, also if the file has changed since.
Result<std::shared_ptr<const Scene>> read_recorded_scene(const RecordedWorld& world, const core::WorldReader& read);

struct ComputedAgain {
    std::vector<SaidLine> said;
    double until_s = 0.0;  // how far the session could be computed, since the recording began
    // Lines after `until_s` must not be compared, because the recording or the computation ends there.
    bool cut = false;
    // Ticks of the hands, and how many of them gave a force that differs from the recorded one by more than rounding to
    // a millinewton.
    std::size_t ticks = 0, other_forces = 0;
    // Whole sentences: why the computation is not complete, or why lines may differ.
    std::vector<std::string> remarks;
};

// Fails with a sentence if a world cannot be read or a line is invalid. Computed lines are compared with recorded ones
// as text, so the language spoken now must be that of the recording.
Result<ComputedAgain> compute_again(const Recording& recording, const core::WorldReader& read);

// The first line that differs; two recordings of the same session have none.
struct LineDifference {
    std::size_t line = 0;            // counted from 0, among all lines that were said
    std::string recorded, computed;  // empty: there is no such line
};
std::optional<LineDifference> first_difference(const Recording& recording, const ComputedAgain& again);

}  // namespace handrail::record
