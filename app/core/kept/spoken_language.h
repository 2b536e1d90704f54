// Speaks the language that the settings name. App thread only.
#pragma once

#include <filesystem>
#include <vector>

#include "settings/settings.h"
#include "worlds/base/language.h"

namespace handrail::core {

// The code of the language that the settings name, resolved as below, without opening a file.
std::string language_as_set(const settings::Settings::Speech& settings, const std::filesystem::path& folder);
// Switches to the language that the settings name ("auto": that of the environment, else English), with the files in
// `folder`. Returns errors to announce. If there is no such language, the previous one stays.
std::vector<Diagnostic> speak_as_set(const settings::Settings::Speech& settings, const std::filesystem::path& folder);

// The folder of a person's own language files: "languages" in the data folder; empty if there is none.
std::filesystem::path user_languages_folder();

}  // namespace handrail::core
