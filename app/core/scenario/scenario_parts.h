// The parts of a scenario that other files contain too: actions and expectations. For readers of scenarios and lessons.
// The functions throw BadField (toml_fields.h). Any thread.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/core/scenario/scenario.h"
#include "settings/toml_value.h"

namespace handrail::core {

// Where to search for the worlds and models that a file names.
struct ScenarioFolders {
    std::filesystem::path beside;
    std::vector<std::filesystem::path> others;
};

// Throws if there is none with that name.
std::filesystem::path find_named_world(const std::string& name, const ScenarioFolders& folders, int line);
// The actions of one table of `do`; adds their names to `names`. Throws if a name exists already.
std::vector<ScenarioAction> read_actions(const settings::TomlValue& table, const ScenarioFolders& folders,
                                         std::set<std::string>& names);
// Reads one table of `expect`; `names`: of the actions.
Expectation read_expectation(const settings::TomlValue& table, const std::set<std::string>& names);
// Turns the error of a TomlReader about that file into one sentence.
Error no_toml(const Error& error, const std::string& file);

}  // namespace handrail::core
