// Turns a recording into a scenario file: the person's actions become its actions, and the answers become its
// expectations. Whatever a scenario cannot do (two worlds, plugging in, a set-up, a lesson) is left out and reported.
// Any thread.
#pragma once

#include <string>
#include <vector>

#include "app/core/scenario/read_request.h"
#include "app/record/recording.h"
#include "worlds/base/result.h"

namespace handrail::record {

struct ScenarioText {
    std::string toml;                   // without expectations
    std::vector<std::string> expected;  // answers, in order
    std::vector<std::string> left_out;  // sentences for the report
};
// Covers the time from the first world to the second. Fails with a sentence if no world was entered or nothing was
// answered.
Result<ScenarioText> scenario_of(const Recording& recording, const std::string& title);

// Runs the scenario and keeps what works: removes actions that are impossible, and answers that come out differently.
// Answers can differ because the program has changed, something was left out, or they came later in the session than in
// a scenario, where rooms and routes are known at once. `left_out` reports their numbers. Fails with a sentence if the
// world cannot be read or no answer comes out as recorded. Takes about as long as the scenario.
Result<ScenarioText> as_it_runs(ScenarioText scenario, const core::WorldReader& read);

// The text of the file. If there are many answers, only the first are expected.
std::string with_expectations(const ScenarioText& scenario);

// The longest common sequence of both lists.
std::vector<std::string> said_by_both(const std::vector<std::string>& a, const std::vector<std::string>& b);

}  // namespace handrail::record
