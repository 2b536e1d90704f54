// The language of the settings, spoken. App thread only.
#pragma once

#include <filesystem>
#include <vector>

#include "settings/settings.h"
#include "worlds/base/language.h"

namespace handrail {

// The code of the language that the settings name, resolved as below; no file is opened.
std::string language_as_set(const Settings::Speech& settings, const std::filesystem::path& folder);
// Speaks the language that the settings name ("auto": the environment's, else English), with the files of `folder`.
// Returns what is wrong, to be said; where there is no such language, the one spoken before stays.
std::vector<Diagnostic> speak_as_set(const Settings::Speech& settings, const std::filesystem::path& folder);

// Where a person's own language files lie: "languages" in the data folder; empty without one.
std::filesystem::path user_languages_folder();

}  // namespace handrail
