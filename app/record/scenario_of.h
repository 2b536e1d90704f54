// A recording as a scenario file: what the person did becomes its actions, and what was answered is what it expects.
// What a scenario cannot do (two worlds, plugging in, a set-up) is left out and told.
#pragma once

#include <string>
#include <vector>

#include "app/record/recording.h"
#include "worlds/base/result.h"

namespace handrail {

struct ScenarioText {
    std::string toml;
    std::vector<std::string> left_out;  // sentences
};
// From the first world on, to the second. Fails with a sentence where no world was entered or nothing answered.
Result<ScenarioText> scenario_of(const Recording& recording, const std::string& title);

}  // namespace handrail
