#include "settings/adjust.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "settings/table.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/overloaded.h"

namespace handrail::settings {
namespace {

constexpr double kSteps = 20.0;
// Units that are short enough to be spoken after every value. All other units are spoken only with the meaning of the
// setting.
constexpr std::array<std::string_view, 5> kShortUnits{"deg", "hand_m", "m", "n", "world_m"};

// Returns the greatest number not above `step` that is 1, 2 or 5 times a power of ten.
double round_step(double step) {
    const double power = std::pow(10.0, std::floor(std::log10(step) + 1e-9));
    for (const double nice : {5.0, 2.0})
        if (step >= nice * power * (1.0 - 1e-9)) return nice * power;
    return power;
}

std::string in_words(const SettingInfo& info, const Settings& settings) {
    const SettingValue value = current_value(info, settings);
    const bool choice = std::holds_alternative<ChoiceField>(info.field);
    std::string text =
        std::visit(Overloaded{[](bool v) { return v ? phrase("setting_value.on") : phrase("setting_value.off"); },
                              [](std::int64_t v) { return fmt::format("{}", v); },
                              [](double v) {
                                  return phrase("setting_value.number", {{"value", v}});
                              },
                              [&](const std::string& v) {
                                  return choice ? phrase(fmt::format("setting_choice.{}.{}", info.key, v)) : v;
                              }},
                   value);
    if (std::find(kShortUnits.begin(), kShortUnits.end(), info.unit) == kShortUnits.end()) return text;
    return phrase("setting_value.with_unit", {{"value", text}, {"unit", spoken_unit(info.unit)}});
}

const SettingInfo& row(std::string_view key) {
    const SettingInfo* info = find_setting(key);
    contract_pre(info != nullptr);
    return *info;
}

std::string_view topic_of(std::string_view key) { return key.substr(0, key.find('.')); }

SettingLine line_of(const SettingInfo& info, const Settings& settings) {
    return {info.key,       phrase("setting_name." + std::string(info.key)), in_words(info, settings), meaning_of(info),
            range_of(info), !std::holds_alternative<TextField>(info.field)};
}

}  // namespace

std::vector<std::string_view> setting_topics() {
    std::vector<std::string_view> topics;
    for (const SettingInfo& info : settings_table())
        if (std::find(topics.begin(), topics.end(), topic_of(info.key)) == topics.end())
            topics.push_back(topic_of(info.key));
    return topics;
}

std::string topic_name(std::string_view topic) { return phrase("setting_topic." + std::string(topic)); }

std::vector<SettingLine> setting_lines(std::string_view topic, const Settings& settings) {
    std::vector<SettingLine> lines;
    for (const SettingInfo& info : settings_table())
        if (topic_of(info.key) == topic) lines.push_back(line_of(info, settings));
    return lines;
}

SettingLine setting_line(std::string_view key, const Settings& settings) { return line_of(row(key), settings); }

std::string stepped(std::string_view key, const Settings& settings, int by) {
    contract_pre(by != 0);
    const SettingInfo& info = row(key);
    // Nothing is written through `s`. As in current_value, the accessors need a non-const reference.
    Settings& s = const_cast<Settings&>(settings);
    return std::visit(
        Overloaded{[&](const NumberField& f) {
                       const double step = round_step((f.most - f.least) / kSteps);
                       const double here = f.at(s) / step;
                       // Moves to the next multiple of `step` in the direction of `by`, even if the current value is
                       // not a multiple.
                       const double next = by > 0 ? std::floor(here + 1e-6) + 1.0 : std::ceil(here - 1e-6) - 1.0;
                       const double value = std::clamp(next * step, f.least, f.most);
                       return fmt::format("{}", std::round(value * 1e9) / 1e9);
                   },
                   [&](const WholeField& f) {
                       const int step =
                           std::max(1, static_cast<int>(round_step(std::max(1.0, (f.most - f.least) / kSteps))));
                       return fmt::format("{}", std::clamp(f.at(s) + by * step, f.least, f.most));
                   },
                   [&](const SwitchField& f) { return std::string(f.at(s) ? "false" : "true"); },
                   [&](const ChoiceField& f) {
                       const auto count = static_cast<int>(f.words.size());
                       return std::string(
                           f.words[static_cast<std::size_t>((static_cast<int>(f.get(s)) + by + count) % count)]);
                   },
                   [&](const TextField& f) { return f.at(s); }},
        info.field);
}

}  // namespace handrail::settings
