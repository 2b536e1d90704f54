// The one table of settings: key, unit, range, default and where the value lives; what is said of them stands in
// settings/languages. Files, the command line, `handrail settings` and its documentation all go through it. Private to
// this folder; app thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "settings/settings.h"
#include "worlds/base/result.h"
#include "worlds/base/variant.h"

namespace handrail {

// What TOML can say where a setting is expected; a whole number is kept apart from a decimal one.
using SettingValue = CopyableVariant<bool, std::int64_t, double, std::string>;

struct NumberField {
    double& (*at)(Settings&);
    double least, most;
};
struct WholeField {
    int& (*at)(Settings&);
    int least, most;
};
struct SwitchField {
    bool& (*at)(Settings&);
};
// One of a few words; `index` of the word in `words` is the enum's value.
struct ChoiceField {
    std::span<const std::string_view> words;
    std::size_t (*get)(const Settings&);
    void (*set)(Settings&, std::size_t);
};
// 1 to 64 printable characters.
struct TextField {
    std::string& (*at)(Settings&);
};

struct SettingInfo {
    std::string_view key;
    std::string_view unit;  // its name among the texts: "m_per_s"
    bool world_may_set;
    std::variant<NumberField, WholeField, SwitchField, ChoiceField, TextField> field;
};

std::span<const SettingInfo> settings_table();
const SettingInfo* find_setting(std::string_view key);

// Fields of [workspace.device."NAME"]; range and unit are those of the plain workspace setting of the same name.
struct OverrideInfo {
    std::string_view field;    // "scale"
    const SettingInfo* plain;  // "workspace.scale"
    std::optional<double> Settings::Workspace::Override::*at;
};
std::span<const OverrideInfo> override_table();

// Fields of [profile."NAME"]: numbers, and the one choice, `hand`, whose words stand in `words`.
struct ProfileInfo {
    std::string_view field, unit;
    double least = 0.0, most = 0.0;
    std::optional<double> DeviceProfile::*number = nullptr;  // null: the hand
    std::span<const std::string_view> words{};
};
std::span<const ProfileInfo> profile_table();
std::string range_of(const ProfileInfo& info);
// What is said of a setting, in the language spoken: its meaning in one sentence, its unit (empty where there is none).
std::string meaning_of(const SettingInfo& info);
std::string meaning_of(const ProfileInfo& info);
std::string spoken_unit(std::string_view unit);
// Writes the value into the profile, or fails in one sentence with the legal range and changes nothing.
Result<void> apply(std::string_view key, const ProfileInfo& info, const SettingValue& value, DeviceProfile& profile);
SettingValue value_from_word(const ProfileInfo& info, std::string_view word);

// "1 to 500", "light, normal or full", "true or false".
std::string range_of(const SettingInfo& info);
// Writes the value into the settings, or fails in one sentence with the legal range and changes nothing.
Result<void> apply(const SettingInfo& info, const SettingValue& value, Settings& settings);
// A decimal number within the range of `plain`, named `key` in errors.
Result<double> number_in_range(std::string_view key, const SettingInfo& plain, const SettingValue& value);
// 1 to 64 printable characters of valid UTF-8.
bool is_short_text(std::string_view text);
// Fails unless `value` is 1 to 64 printable characters.
Result<std::string> short_text(std::string_view key, const SettingValue& value);
// A text as it was typed or as a list of settings shows it, without quotes around it.
std::string without_quotes(std::string_view word);
// The same as short_text for names of keys: each must be one that can be pressed.
Result<std::string> key_text(std::string_view key, const SettingValue& value);
// The value as it now is.
SettingValue current_value(const SettingInfo& info, const Settings& settings);
// A word from a command line as the kind of value this setting takes; what does not fit comes back as text and is
// refused by apply.
SettingValue value_from_word(const SettingInfo& info, std::string_view word);

}  // namespace handrail
