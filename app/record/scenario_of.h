// Turns a recording into a scenario file. The person's actions become actions of the scenario, and the program's
// answers become its expectations. What a scenario cannot contain (two worlds, plugging in, a set-up, a lesson) is left
// out and reported. Any thread.
#pragma once

#include <string>
#include <vector>

#include "app/core/scenario/read_request.h"
#include "app/record/recording.h"
#include "worlds/base/result.h"

namespace handrail::record {

struct ScenarioText {
    std::string toml;                   // the scenario file without expectations
    std::vector<std::string> expected;  // the expected answers, in order
    std::vector<std::string> left_out;  // sentences for the report about what was left out
};
// Makes a scenario from the time that the person spent in the first world. Fails with a sentence if the person entered
// no world, or if the program answered nothing.
Result<ScenarioText> scenario_of(const Recording& recording, const std::string& title);

// Runs the scenario. Removes actions that are impossible, and answers that differ from the recorded ones. Answers can
// differ because the program has changed, or because an action was left out. In a scenario, rooms and routes are also
// known at once, so some answers come earlier than in the session. `left_out` reports how many were removed. Fails with
// a sentence if the world cannot be read, or if no answer is the same as recorded. Takes about as long as the scenario.
Result<ScenarioText> as_it_runs(ScenarioText scenario, const core::WorldReader& read);

// Returns the text of the scenario file. If there are many answers, the file expects only the first ones.
std::string with_expectations(const ScenarioText& scenario);

// Returns the longest common subsequence of both lists.
std::vector<std::string> said_by_both(const std::vector<std::string>& a, const std::vector<std::string>& b);

}  // namespace handrail::record
