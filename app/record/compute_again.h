// Computes a recorded session again: all that reached it goes into another one, and each of its three loops reads of
// the others exactly what it read then. The lines that are said must come out alike, in order: a test of the program,
// and how a report of a fault is looked into. One thread, in no time of its own.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/scenario/read_request.h"
#include "app/record/input_text.h"
#include "app/record/recording.h"
#include "worlds/base/result.h"

namespace handrail {

// Reads a world that a recording names, as its file has it. Fails with a sentence, also where the file is another one
// by now.
Result<std::shared_ptr<const Scene>> read_recorded_scene(const RecordedWorld& world, const WorldReader& read);

struct ComputedAgain {
    std::vector<SaidLine> said;
    double until_s = 0.0;  // so far it could be computed, since the recording began
    bool cut = false;  // what was said later is not to be compared: the recording or what can be computed ends there
    // Ticks of the hands, and those of them whose force came out otherwise than it is written, to a millinewton.
    std::size_t ticks = 0, other_forces = 0;
    // Why that is not all of it, or why lines may differ: whole sentences.
    std::vector<std::string> remarks;
};

// Fails with a sentence where a world cannot be read or a line makes no sense. The words of the language that is spoken
// now are compared with those of the recording, so that has to be the same.
Result<ComputedAgain> compute_again(const Recording& recording, const WorldReader& read);

// The first line that is not as it was; of two recordings of one session none is.
struct LineDifference {
    std::size_t line = 0;            // counted from 0, of all that were said
    std::string recorded, computed;  // empty: there is none
};
std::optional<LineDifference> first_difference(const Recording& recording, const ComputedAgain& again);

}  // namespace handrail
