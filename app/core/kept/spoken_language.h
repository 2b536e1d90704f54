// Selects the language of speech and texts that the settings name. Call it on the app thread only.
#pragma once

#include <filesystem>
#include <vector>

#include "settings/settings.h"
#include "worlds/base/language.h"

namespace handrail::core {

// Returns the code of the language that speak_as_set() would select, without opening a file.
std::string language_as_set(const settings::Settings::Speech& settings, const std::filesystem::path& folder);
// Switches to the language that the settings name. "auto" means the language of the environment, or else English.
// `folder` contains the language files. Returns errors to announce. If there is no file for that language, the previous
// language stays.
std::vector<Diagnostic> speak_as_set(const settings::Settings::Speech& settings, const std::filesystem::path& folder);

// Returns the folder for a person's own language files, "languages" in the data folder. The path is empty if there is
// no data folder.
std::filesystem::path user_languages_folder();

}  // namespace handrail::core
