#include "settings/table.h"

#include "worlds/base/overloaded.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

constexpr std::array<std::string_view, 3> kCeilingWords{"light", "normal", "full"};
constexpr std::array<std::string_view, 2> kFrameWords{"map", "walk"};
constexpr std::size_t kLongestText = 64;

// The accessor of a field that lies in Settings, as a plain function pointer.
#define HANDRAIL_AT(member) \
    [](Settings & s) -> auto& { return s.member; }

constexpr bool kWorldToo = true;
constexpr bool kPersonOnly = false;

// A world may shape scale, ball, body and frame. Forces, speech, sound volumes and keys belong to the person alone.
const std::array kTable{
    SettingInfo{"workspace.scale", "world metres per hand metre", "How much world one movement of the hand crosses.", kWorldToo,
                NumberField{HANDRAIL_AT(workspace.scale), 1.0, 500.0}},
    SettingInfo{"workspace.offset_ahead_m", "hand metres", "How far the middle of the hand's workspace lies ahead of the body.", kWorldToo,
                NumberField{HANDRAIL_AT(workspace.offset_ahead_m), -0.1, 0.1}},
    SettingInfo{"workspace.offset_up_m", "hand metres", "How far the middle of the hand's workspace is raised.", kWorldToo,
                NumberField{HANDRAIL_AT(workspace.offset_up_m), -0.1, 0.1}},
    SettingInfo{"workspace.hand_height_m", "world metres", "Height of the workspace's middle above the soles.", kWorldToo,
                NumberField{HANDRAIL_AT(workspace.hand_height_m), 0.0, 2.0}},
    SettingInfo{"workspace.frame", "", "map: north stays up; walk: the workspace turns with the body.", kWorldToo,
                ChoiceField{kFrameWords, [](const Settings& s) { return static_cast<std::size_t>(s.workspace.frame); },
                            [](Settings& s, std::size_t i) { s.workspace.frame = static_cast<FrameChoice>(i); }}},
    SettingInfo{"haptic.stiffness_fraction", "fraction of the device's rating", "Hardness of surfaces that name none.", kPersonOnly,
                NumberField{HANDRAIL_AT(haptic.stiffness_fraction), 0.0, 1.0}},
    SettingInfo{"haptic.friction_mu", "", "Friction of surfaces that name none.", kWorldToo, NumberField{HANDRAIL_AT(haptic.friction_mu), 0.0, 2.0}},
    SettingInfo{"haptic.damping_ns_per_m", "newton seconds per metre", "Damping of surfaces, against the hand's speed.", kPersonOnly,
                NumberField{HANDRAIL_AT(haptic.damping_ns_per_m), 0.0, 20.0}},
    SettingInfo{"haptic.ball_diameter_mm", "millimetres of hand travel", "Felt size of the ball that touches, at scale 60.", kWorldToo,
                NumberField{HANDRAIL_AT(haptic.ball_diameter_mm), 1.0, 10.0}},
    SettingInfo{"haptic.ceiling", "", "Strongest force: light is 1.2 newtons, normal 2.5, full what the device can do.", kPersonOnly,
                ChoiceField{kCeilingWords, [](const Settings& s) { return static_cast<std::size_t>(s.haptic.ceiling); },
                            [](Settings& s, std::size_t i) { s.haptic.ceiling = static_cast<ForceCeiling>(i); }}},
    SettingInfo{"haptic.device", "", "Which haptic device to use.", kPersonOnly, TextField{HANDRAIL_AT(haptic.device), "auto, none or a device's name"}},
    SettingInfo{"walk.step_length_m", "metres", "Length of one step.", kWorldToo, NumberField{HANDRAIL_AT(walk.step_length_m), 0.2, 1.5}},
    SettingInfo{"walk.speed_m_per_s", "metres per second", "Walking speed while a key is held.", kWorldToo,
                NumberField{HANDRAIL_AT(walk.speed_m_per_s), 0.2, 3.0}},
    SettingInfo{"walk.turn_deg", "degrees", "How far one press of Left or Right turns.", kWorldToo, NumberField{HANDRAIL_AT(walk.turn_deg), 1.0, 90.0}},
    SettingInfo{"walk.body_radius_m", "metres", "Radius of the walking body.", kWorldToo, NumberField{HANDRAIL_AT(walk.body_radius_m), 0.1, 0.6}},
    SettingInfo{"speech.rate_wpm", "words per minute", "How fast the voice speaks.", kPersonOnly, WholeField{HANDRAIL_AT(speech.rate_wpm), 80, 450}},
    SettingInfo{"speech.verbosity", "", "How much is said: 0 is sounds alone, 4 is everything.", kPersonOnly, WholeField{HANDRAIL_AT(speech.verbosity), 0, 4}},
    SettingInfo{"speech.voice", "", "Voice or language of the built-in speech.", kPersonOnly,
                TextField{HANDRAIL_AT(speech.voice), "an espeak-ng voice or language"}},
    SettingInfo{"speech.distances_in_steps", "", "Short distances are said in steps, else in metres.", kPersonOnly,
                SwitchField{HANDRAIL_AT(speech.distances_in_steps)}},
    SettingInfo{"sound.volume", "", "Volume of everything; alarms stay audible.", kPersonOnly, NumberField{HANDRAIL_AT(sound.volume), 0.0, 1.0}},
    SettingInfo{"sound.speech_volume", "", "Volume of speech.", kPersonOnly, NumberField{HANDRAIL_AT(sound.speech_volume), 0.0, 1.0}},
    SettingInfo{"sound.contact_volume", "", "Volume of touching and sliding.", kPersonOnly, NumberField{HANDRAIL_AT(sound.contact_volume), 0.0, 1.0}},
    SettingInfo{"sound.footstep_volume", "", "Volume of footsteps.", kPersonOnly, NumberField{HANDRAIL_AT(sound.footstep_volume), 0.0, 1.0}},
    SettingInfo{"sound.wall_tone_volume", "", "Volume of the tone near walls.", kPersonOnly, NumberField{HANDRAIL_AT(sound.wall_tone_volume), 0.0, 1.0}},
    SettingInfo{"sound.wall_tone", "", "A tone tells that a wall is near.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.wall_tone)}},
};
#undef HANDRAIL_AT

using Override = Settings::Workspace::Override;
const std::array kOverrides{
    OverrideInfo{"scale", &kTable[0], &Override::scale},
    OverrideInfo{"offset_ahead_m", &kTable[1], &Override::offset_ahead_m},
    OverrideInfo{"offset_up_m", &kTable[2], &Override::offset_up_m},
    OverrideInfo{"hand_height_m", &kTable[3], &Override::hand_height_m},
};

std::string what_it_is(const SettingValue& value) {
    return std::visit(
        Overloaded{[](bool v) { return std::string(v ? "true" : "false"); }, [](std::int64_t v) { return fmt::format("{}", v); },
                   [](double v) { return fmt::format("{}", v); }, [](const std::string& v) { return fmt::format("\"{}\"", v.substr(0, kLongestText)); }},
        value);
}

// "workspace.scale is 900, but must be 1 to 500 world metres per hand metre."
tl::unexpected<Error> refuse(std::string_view key, const SettingInfo& info, const SettingValue& value) {
    const std::string unit = info.unit.empty() ? "" : fmt::format(" {}", info.unit);
    return fail(fmt::format("The setting {} is {}, but must be {}{}.", key, what_it_is(value), range_of(info), unit));
}

std::optional<double> as_number(const SettingValue& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
    if (const auto* decimal = std::get_if<double>(&value); decimal && std::isfinite(*decimal)) return *decimal;
    return std::nullopt;
}

}  // namespace

std::span<const SettingInfo> settings_table() { return kTable; }
std::span<const OverrideInfo> override_table() { return kOverrides; }

const SettingInfo* find_setting(std::string_view key) {
    const auto found = std::find_if(kTable.begin(), kTable.end(), [&](const SettingInfo& info) { return info.key == key; });
    return found == kTable.end() ? nullptr : &*found;
}

bool world_may_set(std::string_view key) {
    const SettingInfo* info = find_setting(key);
    return info && info->world_may_set;
}

std::string range_of(const SettingInfo& info) {
    return std::visit(Overloaded{[](const NumberField& f) { return fmt::format("{} to {}", f.least, f.most); },
                                 [](const WholeField& f) { return fmt::format("a whole number, {} to {}", f.least, f.most); },
                                 [](const SwitchField&) { return std::string("true or false"); },
                                 [](const ChoiceField& f) {
                                     std::string text(f.words[0]);
                                     for (std::size_t i = 1; i < f.words.size(); ++i)
                                         text += fmt::format("{}{}", i + 1 == f.words.size() ? " or " : ", ", f.words[i]);
                                     return text;
                                 },
                                 [](const TextField& f) { return std::string(f.range); }},
                      info.field);
}

Result<double> number_in_range(std::string_view key, const SettingInfo& plain, const SettingValue& value) {
    const auto& field = std::get<NumberField>(plain.field);
    const std::optional<double> number = as_number(value);
    if (!number || *number < field.least || *number > field.most) return refuse(key, plain, value);
    return *number;
}

bool is_short_text(std::string_view text) {
    const auto unprintable = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    return !text.empty() && text.size() <= kLongestText && std::none_of(text.begin(), text.end(), unprintable) && is_utf8(text);
}

Result<std::string> short_text(std::string_view key, const SettingValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    if (!text || !is_short_text(*text)) return fail(fmt::format("The setting {} must be text of 1 to {} letters.", key, kLongestText));
    return *text;
}

Result<void> apply(const SettingInfo& info, const SettingValue& value, Settings& settings) {
    return std::visit(
        Overloaded{
            [&](const NumberField& f) -> Result<void> { return number_in_range(info.key, info, value).map([&](double number) { f.at(settings) = number; }); },
            [&](const WholeField& f) -> Result<void> {
                const auto* whole = std::get_if<std::int64_t>(&value);
                if (!whole || *whole < f.least || *whole > f.most) return refuse(info.key, info, value);
                f.at(settings) = static_cast<int>(*whole);
                return {};
            },
            [&](const SwitchField& f) -> Result<void> {
                const auto* on = std::get_if<bool>(&value);
                if (!on) return refuse(info.key, info, value);
                f.at(settings) = *on;
                return {};
            },
            [&](const ChoiceField& f) -> Result<void> {
                const auto* text = std::get_if<std::string>(&value);
                const auto word = text ? std::find(f.words.begin(), f.words.end(), lower_ascii(*text)) : f.words.end();
                if (word == f.words.end()) return refuse(info.key, info, value);
                f.set(settings, static_cast<std::size_t>(word - f.words.begin()));
                return {};
            },
            [&](const TextField& f) -> Result<void> { return short_text(info.key, value).map([&](const std::string& text) { f.at(settings) = text; }); }},
        info.field);
}

SettingValue current_value(const SettingInfo& info, const Settings& settings) {
    Settings& s = const_cast<Settings&>(settings);  // the accessors give references; nothing is written through them here
    return std::visit(
        Overloaded{[&](const NumberField& f) -> SettingValue { return f.at(s); }, [&](const WholeField& f) -> SettingValue { return std::int64_t{f.at(s)}; },
                   [&](const SwitchField& f) -> SettingValue { return f.at(s); },
                   [&](const ChoiceField& f) -> SettingValue { return std::string(f.words[f.get(s)]); },
                   [&](const TextField& f) -> SettingValue { return f.at(s); }},
        info.field);
}

SettingValue value_from_word(const SettingInfo& info, std::string_view word) {
    if (word.size() >= 2 && word.front() == '"' && word.back() == '"') return std::string(word.substr(1, word.size() - 2));
    if (std::holds_alternative<ChoiceField>(info.field) || std::holds_alternative<TextField>(info.field)) return std::string(word);
    if (word == "true" || word == "on") return true;
    if (word == "false" || word == "off") return false;
    double number = 0.0;
    if (!parse_finite(word, number)) return std::string(word);
    if (std::holds_alternative<WholeField>(info.field) && number == std::floor(number) && std::abs(number) < 1e9) return static_cast<std::int64_t>(number);
    return number;
}

}  // namespace handrail
