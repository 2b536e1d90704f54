// Functions with which a person changes settings in a list, by one step or one value at a time. They are plain
// functions over Settings and its table, for the app thread only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "settings/settings.h"

namespace handrail::settings {

// Returns the first parts of the keys, in table order: "workspace", "haptic", ...
std::vector<std::string_view> setting_topics();
// Returns the spoken name of a topic: "Workspace".
std::string topic_name(std::string_view topic);

struct SettingLine {
    std::string_view key;
    std::string name;   // the setting's name: "stiffness"
    std::string value;  // the setting's value: "0.8", "on", "light"; with the unit if that is short
    std::string meaning;
    std::string range;
    bool steps = true;  // false: the person cannot change the setting in steps, only type a text
};
std::vector<SettingLine> setting_lines(std::string_view topic, const Settings& settings);
SettingLine setting_line(std::string_view key, const Settings& settings);

// Returns the value of `key` one step up or down, as text for SettingsStore::set. A switch toggles. A choice moves on
// to the next word and wraps round. A number changes by about a twentieth of its range, in round numbers, and stops at
// the ends. `key` must be in the table and have steps.
std::string stepped(std::string_view key, const Settings& settings, int by);

}  // namespace handrail::settings
