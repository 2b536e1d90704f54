// Stores what the person has chosen: settings, and the keys that result from them. Plain state for the app thread only.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/core/dialogue/key_map.h"
#include "settings/settings.h"

namespace handrail::core {

struct Person {
    explicit Person(const settings::Settings& chosen) : settings(chosen), keys(chosen.keys, chosen.keyboard.hand) {}

    settings::Settings settings;
    KeyMap keys;
    // Keys and values of the settings that a command changed and the owner still has to save.
    std::vector<std::pair<std::string, std::string>> changes;
};

}  // namespace handrail::core
