// Settings as a person changes them in a list, one step or one value at a time. Plain functions over Settings and the
// one table; app thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "settings/settings.h"

namespace handrail {

// The first words of keys, in table order: "workspace", "haptic", ...
std::vector<std::string_view> setting_topics();
// What such a topic is called: "Workspace".
std::string topic_name(std::string_view topic);

struct SettingLine {
    std::string_view key;
    std::string name;   // "stiffness"
    std::string value;  // "0.8", "on", "light", with its unit where it is short
    std::string meaning;
    std::string range;
    bool steps = true;  // false: a text, which is typed
};
std::vector<SettingLine> setting_lines(std::string_view topic, const Settings& settings);
SettingLine setting_line(std::string_view key, const Settings& settings);

// The value one step up or down as SettingsStore::set takes it: a switch turns, a choice goes on (round), a number goes
// by a twentieth of its range in round numbers and stops at the ends. `key` must be one of the table that steps.
std::string stepped(std::string_view key, const Settings& settings, int by);

}  // namespace handrail
