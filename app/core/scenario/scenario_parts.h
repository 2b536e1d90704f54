// The parts of a scenario that other files hold too: what is done and what is expected. They throw BadField
// (toml_fields.h). For readers of scenarios and lessons. Any thread.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/core/scenario/scenario.h"
#include "settings/toml_value.h"

namespace handrail {

// Where the worlds and models that a file names are looked for.
struct ScenarioFolders {
    std::filesystem::path beside;
    std::vector<std::filesystem::path> others;
};

// Throws where there is none of that name.
std::filesystem::path find_named_world(const std::string& name, const ScenarioFolders& folders, int line);
// What one table of `do` stands for; `names` gets the names of its actions. Throws where one is there already.
std::vector<ScenarioAction> read_actions(const TomlValue& table, const ScenarioFolders& folders,
                                         std::set<std::string>& names);
// One table of `expect`; `names`: of the actions there are.
Expectation read_expectation(const TomlValue& table, const std::set<std::string>& names);
// What a TomlReader said of that file, as one sentence.
Error no_toml(const Error& error, const std::string& file);

}  // namespace handrail
