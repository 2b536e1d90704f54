// Lists presets: several settings of walking and speech that a person chooses together by a name. Plain data, which any
// thread may use. The names are in settings/languages.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "settings/settings.h"

namespace handrail::settings {

struct Preset {
    std::string_view id;         // the same in every language
    std::string_view name_key;   // key of its name in settings/languages
    double step_length_m = 0.0;  // value of walk.step_length_m
    double speed_m_per_s = 0.0;  // value of walk.speed_m_per_s
    int verbosity = 0;           // value of speech.verbosity

    // Returns the settings as keys and values.
    std::vector<std::pair<std::string_view, std::string>> values() const;
    // Returns true if `settings` has these values.
    bool is_set(const Settings& settings) const;
};

// Returns the presets, the calmest first. The one with the id "usual" has the default values.
std::span<const Preset> presets();

}  // namespace handrail::settings
