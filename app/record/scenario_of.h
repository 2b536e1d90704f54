// A recording as a scenario file: what the person did becomes its actions, and what was answered is what it expects.
// What a scenario cannot do (two worlds, plugging in, a set-up, a lesson) is left out and told. Any thread.
#pragma once

#include <string>
#include <vector>

#include "app/core/scenario/read_request.h"
#include "app/record/recording.h"
#include "worlds/base/result.h"

namespace handrail {

struct ScenarioText {
    std::string toml;                   // without expectations
    std::vector<std::string> expected;  // answers, in order
    std::vector<std::string> left_out;  // sentences
};
// From the first world on, to the second. Fails with a sentence where no world was entered or nothing answered.
Result<ScenarioText> scenario_of(const Recording& recording, const std::string& title);

// The same as far as it comes true when it is run: without actions that cannot be done there, and without answers that
// come otherwise, because the program has changed since, or something was left out, or came later in the session than
// in a scenario, where rooms and ways are known at once. How many these are is told in left_out. Fails with a sentence
// where the world cannot be read or no answer comes as it was recorded. Takes about as long as the scenario does.
Result<ScenarioText> as_it_runs(ScenarioText scenario, const WorldReader& read);

// The text of the file. Of many answers the first are expected.
std::string with_expectations(const ScenarioText& scenario);

// What is in both, in this order; as many as there can be.
std::vector<std::string> said_by_both(const std::vector<std::string>& a, const std::vector<std::string>& b);

}  // namespace handrail
