// Defines the table of all settings: key, unit, range, default, and where the value is stored. The texts about the
// settings are in settings/languages. The code for files, the command line, `handrail settings` and its documentation
// uses this table. Private to this folder; app thread only.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "settings/settings.h"
#include "worlds/base/result.h"
#include "worlds/base/variant.h"

namespace handrail::settings {

// The values that a setting can have. Whole and decimal numbers are separate types, as in TOML.
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
// A setting that is one of several words. The index of the word in `words` is the value of the enumeration.
struct ChoiceField {
    std::span<const std::string_view> words;
    std::size_t (*get)(const Settings&);
    void (*set)(Settings&, std::size_t);
};
// A setting that is a text of 1 to 64 printable characters.
struct TextField {
    std::string& (*at)(Settings&);
};

struct SettingInfo {
    std::string_view key;
    std::string_view unit;  // the key of the unit's text: "m_per_s"
    bool world_may_set;
    std::variant<NumberField, WholeField, SwitchField, ChoiceField, TextField> field;
};

std::span<const SettingInfo> settings_table();
const SettingInfo* find_setting(std::string_view key);

// A field of [workspace.device."NAME"]. Its range and unit are those of the workspace setting with the same name.
struct OverrideInfo {
    std::string_view field;    // name of the field: "scale"
    const SettingInfo* plain;  // the workspace setting with that name: "workspace.scale"
    std::optional<double> Settings::Workspace::Override::*at;
};
std::span<const OverrideInfo> override_table();

// A field of [profile."NAME"]. It is either a number or the choice `hand`, whose words are in `words`.
struct ProfileInfo {
    std::string_view field, unit;
    double least = 0.0, most = 0.0;
    std::optional<double> DeviceProfile::*number = nullptr;  // null for the field `hand`
    std::span<const std::string_view> words{};
};
std::span<const ProfileInfo> profile_table();
std::string range_of(const ProfileInfo& info);
// meaning_of returns the meaning of a setting in one sentence, spoken_unit the name of a unit (empty if it has none).
// Both are in the spoken language.
std::string meaning_of(const SettingInfo& info);
std::string meaning_of(const ProfileInfo& info);
std::string spoken_unit(std::string_view unit);
// Writes the value into the profile. If the value is illegal, fails with one sentence that states the legal range, and
// changes nothing.
Result<void> apply(std::string_view key, const ProfileInfo& info, const SettingValue& value, DeviceProfile& profile);
SettingValue value_from_word(const ProfileInfo& info, std::string_view word);

// Returns the legal values as text: "1 to 500", "light, normal or full", "true or false".
std::string range_of(const SettingInfo& info);
// Writes the value into the settings. If the value is illegal, fails with one sentence that states the legal range, and
// changes nothing.
Result<void> apply(const SettingInfo& info, const SettingValue& value, Settings& settings);
// Returns the value if it is a decimal number within the range of `plain`; else fails with an error about `key`.
Result<double> number_in_range(std::string_view key, const SettingInfo& plain, const SettingValue& value);
// True if the text is well-formed UTF-8 and has 1 to 64 printable characters.
bool is_short_text(std::string_view text);
// Returns the value if it is a text of 1 to 64 printable characters; else fails with an error about `key`.
Result<std::string> short_text(std::string_view key, const SettingValue& value);
// Removes the quotation marks around a text that the person typed or copied from a list of settings.
std::string without_quotes(std::string_view word);
// Like short_text, for the names of keys. Fails unless each name is a valid key name.
Result<std::string> key_text(std::string_view key, const SettingValue& value);
// Returns the current value of the setting.
SettingValue current_value(const SettingInfo& info, const Settings& settings);
// Converts a word of a command line to the type of this setting. If the word does not fit that type, returns the word
// as text, which apply() then refuses.
SettingValue value_from_word(const SettingInfo& info, std::string_view word);

}  // namespace handrail::settings
