// Reads the parts of a scenario that lessons contain too: actions and expectations. The readers of scenarios and
// lessons use these functions. They throw BadField (toml_fields.h). Any thread may call them.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/core/scenario/scenario.h"
#include "settings/toml_value.h"

namespace handrail::core {

// The folders in which to search for the worlds and models that a file names.
struct ScenarioFolders {
    std::filesystem::path beside;
    std::vector<std::filesystem::path> others;
};

// Returns the file of the world with this name, and throws if there is none.
std::filesystem::path find_named_world(const std::string& name, const ScenarioFolders& folders, int line);
// Reads the actions of one table `do`, and adds the names of the actions to `names`. Throws if a name already exists.
std::vector<ScenarioAction> read_actions(const settings::TomlValue& table, const ScenarioFolders& folders,
                                         std::set<std::string>& names);
// Reads one table `expect`. `names` are the names of the actions.
Expectation read_expectation(const settings::TomlValue& table, const std::set<std::string>& names);
// Turns the error of a TomlReader about `file` into one sentence.
Error no_toml(const Error& error, const std::string& file);

}  // namespace handrail::core
