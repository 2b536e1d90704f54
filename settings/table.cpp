#include "settings/table.h"

#include <fmt/ranges.h>

#include "settings/key_names.h"
#include "worlds/base/language.h"
#include "worlds/base/overloaded.h"
#include "worlds/base/text.h"

namespace handrail::settings {
namespace {

constexpr std::array<std::string_view, 3> kCeilingWords{"light", "normal", "full"};
constexpr std::array<std::string_view, 2> kFrameWords{"map", "walk"};
constexpr std::array<std::string_view, 2> kHandWords{"right", "left"};
constexpr std::array<std::string_view, 3> kKeyboardWords{"both", "left", "right"};
constexpr std::array<std::string_view, 4> kColourWords{"dark", "light", "high-contrast", "colour-safe"};
constexpr std::array<std::string_view, 3> kDirectionWords{"sides", "clock", "compass"};
constexpr std::array<std::string_view, 3> kSpotlightWords{"off", "ahead", "hand"};
constexpr std::array<std::string_view, 3> kCaneWords{"constant-contact", "two-point", "shoreline"};
constexpr std::array<std::string_view, 5> kThroughWords{"auto", "screen-reader", "speech-dispatcher", "embedded",
                                                        "text"};
constexpr std::size_t kLongestText = 64;

// The accessor of a field of Settings, as a plain function pointer.
// NOLINTBEGIN(bugprone-macro-parentheses): a member takes none
#define HANDRAIL_AT(member) \
    [](Settings & s) -> auto& { return s.member; }
// NOLINTEND(bugprone-macro-parentheses)

constexpr bool kWorldToo = true;
constexpr bool kPersonOnly = false;

// A world may set the scale, the proxy, the walker and the frame. Only the person may set forces, speech, sound volumes
// and keys.
const std::array kTable{
    SettingInfo{"workspace.scale", "scale", kWorldToo, NumberField{HANDRAIL_AT(workspace.scale), 1.0, 500.0}},
    SettingInfo{"workspace.offset_ahead_m", "hand_m", kWorldToo,
                NumberField{HANDRAIL_AT(workspace.offset_ahead_m), -0.1, 0.1}},
    SettingInfo{"workspace.offset_up_m", "hand_m", kWorldToo,
                NumberField{HANDRAIL_AT(workspace.offset_up_m), -0.1, 0.1}},
    SettingInfo{"workspace.hand_height_m", "world_m", kWorldToo,
                NumberField{HANDRAIL_AT(workspace.hand_height_m), 0.0, 2.0}},
    SettingInfo{"workspace.frame", "", kWorldToo,
                ChoiceField{kFrameWords, [](const Settings& s) { return static_cast<std::size_t>(s.workspace.frame); },
                            [](Settings& s, std::size_t i) { s.workspace.frame = static_cast<FrameChoice>(i); }}},
    SettingInfo{"workspace.turn_deg", "deg", kPersonOnly, NumberField{HANDRAIL_AT(workspace.turn_deg), -180.0, 180.0}},
    SettingInfo{"workspace.follows_walk", "", kPersonOnly, SwitchField{HANDRAIL_AT(workspace.follows_walk)}},
    SettingInfo{"workspace.rim", "", kPersonOnly, SwitchField{HANDRAIL_AT(workspace.rim)}},
    SettingInfo{"workspace.grab_button", "", kPersonOnly, WholeField{HANDRAIL_AT(workspace.grab_button), 0, 8}},
    SettingInfo{"haptic.stiffness_fraction", "fraction_of_rating", kPersonOnly,
                NumberField{HANDRAIL_AT(haptic.stiffness_fraction), 0.0, 1.0}},
    SettingInfo{"haptic.friction_mu", "", kWorldToo, NumberField{HANDRAIL_AT(haptic.friction_mu), 0.0, 2.0}},
    SettingInfo{"haptic.damping_ns_per_m", "ns_per_m", kPersonOnly,
                NumberField{HANDRAIL_AT(haptic.damping_ns_per_m), 0.0, 20.0}},
    SettingInfo{"haptic.ball_diameter_mm", "hand_mm", kWorldToo,
                NumberField{HANDRAIL_AT(haptic.ball_diameter_mm), 1.0, 10.0}},
    SettingInfo{"haptic.edge_rounding_mm", "hand_mm", kWorldToo,
                NumberField{HANDRAIL_AT(haptic.edge_rounding_mm), 0.0, 3.0}},
    SettingInfo{"haptic.simplify", "", kWorldToo, SwitchField{HANDRAIL_AT(haptic.simplify)}},
    SettingInfo{"haptic.mesh_tolerance_mm", "hand_mm", kWorldToo,
                NumberField{HANDRAIL_AT(haptic.mesh_tolerance_mm), 0.0, 1.0}},
    SettingInfo{"haptic.ceiling", "", kPersonOnly,
                ChoiceField{kCeilingWords, [](const Settings& s) { return static_cast<std::size_t>(s.haptic.ceiling); },
                            [](Settings& s, std::size_t i) { s.haptic.ceiling = static_cast<ForceCeiling>(i); }}},
    SettingInfo{"haptic.button_to_feel", "", kPersonOnly, SwitchField{HANDRAIL_AT(haptic.button_to_feel)}},
    SettingInfo{"haptic.device", "", kPersonOnly, TextField{HANDRAIL_AT(haptic.device)}},
    SettingInfo{"haptic.left_device", "", kPersonOnly, TextField{HANDRAIL_AT(haptic.left_device)}},
    SettingInfo{"walk.step_length_m", "m", kWorldToo, NumberField{HANDRAIL_AT(walk.step_length_m), 0.2, 1.5}},
    SettingInfo{"walk.speed_m_per_s", "m_per_s", kWorldToo, NumberField{HANDRAIL_AT(walk.speed_m_per_s), 0.2, 3.0}},
    SettingInfo{"walk.turn_deg", "deg", kWorldToo, NumberField{HANDRAIL_AT(walk.turn_deg), 1.0, 90.0}},
    SettingInfo{"walk.body_radius_m", "m", kWorldToo, NumberField{HANDRAIL_AT(walk.body_radius_m), 0.1, 0.6}},
    SettingInfo{"walk.callouts", "", kPersonOnly, SwitchField{HANDRAIL_AT(walk.callouts)}},
    SettingInfo{"walk.stop_at_drops", "", kPersonOnly, SwitchField{HANDRAIL_AT(walk.stop_at_drops)}},
    SettingInfo{"speech.through", "", kPersonOnly,
                ChoiceField{kThroughWords, [](const Settings& s) { return static_cast<std::size_t>(s.speech.through); },
                            [](Settings& s, std::size_t i) { s.speech.through = static_cast<SpeechThrough>(i); }}},
    SettingInfo{"speech.rate_wpm", "wpm", kPersonOnly, WholeField{HANDRAIL_AT(speech.rate_wpm), 80, 450}},
    SettingInfo{"speech.verbosity", "", kPersonOnly, WholeField{HANDRAIL_AT(speech.verbosity), 0, 4}},
    SettingInfo{"speech.language", "", kPersonOnly, TextField{HANDRAIL_AT(speech.language)}},
    SettingInfo{"speech.voice", "", kPersonOnly, TextField{HANDRAIL_AT(speech.voice)}},
    SettingInfo{"speech.distances_in_steps", "", kPersonOnly, SwitchField{HANDRAIL_AT(speech.distances_in_steps)}},
    SettingInfo{
        "speech.directions", "", kPersonOnly,
        ChoiceField{kDirectionWords, [](const Settings& s) { return static_cast<std::size_t>(s.speech.directions); },
                    [](Settings& s, std::size_t i) { s.speech.directions = static_cast<DirectionChoice>(i); }}},
    SettingInfo{"speech.rounded", "", kPersonOnly, SwitchField{HANDRAIL_AT(speech.rounded)}},
    SettingInfo{"speech.rooms", "", kPersonOnly, SwitchField{HANDRAIL_AT(speech.rooms)}},
    SettingInfo{"speech.braille", "", kPersonOnly, SwitchField{HANDRAIL_AT(speech.braille)}},
    SettingInfo{"speech.from_places", "", kPersonOnly, SwitchField{HANDRAIL_AT(speech.from_places)}},
    SettingInfo{"speech.crowding_hint", "", kPersonOnly, SwitchField{HANDRAIL_AT(speech.crowding_hint)}},
    SettingInfo{"sound.volume", "", kPersonOnly, NumberField{HANDRAIL_AT(sound.volume), 0.0, 1.0}},
    SettingInfo{"sound.speech_volume", "", kPersonOnly, NumberField{HANDRAIL_AT(sound.speech_volume), 0.0, 1.0}},
    SettingInfo{"sound.contact_volume", "", kPersonOnly, NumberField{HANDRAIL_AT(sound.contact_volume), 0.0, 1.0}},
    SettingInfo{"sound.footstep_volume", "", kPersonOnly, NumberField{HANDRAIL_AT(sound.footstep_volume), 0.0, 1.0}},
    SettingInfo{"sound.wall_tone_volume", "", kPersonOnly, NumberField{HANDRAIL_AT(sound.wall_tone_volume), 0.0, 1.0}},
    SettingInfo{"sound.world_volume", "", kPersonOnly, NumberField{HANDRAIL_AT(sound.world_volume), 0.0, 1.0}},
    SettingInfo{"sound.earcon_volume", "", kPersonOnly, NumberField{HANDRAIL_AT(sound.earcon_volume), 0.0, 1.0}},
    SettingInfo{"sound.beacon_volume", "", kPersonOnly, NumberField{HANDRAIL_AT(sound.beacon_volume), 0.0, 1.0}},
    SettingInfo{"sound.reverberation", "", kPersonOnly, NumberField{HANDRAIL_AT(sound.reverberation), 0.0, 1.0}},
    SettingInfo{"sound.periods", "", kPersonOnly, WholeField{HANDRAIL_AT(sound.periods), 2, 8}},
    SettingInfo{"sound.hrtf", "", kPersonOnly, TextField{HANDRAIL_AT(sound.hrtf)}},
    SettingInfo{"sound.pack", "", kPersonOnly, TextField{HANDRAIL_AT(sound.pack)}},
    SettingInfo{"sound.headphones", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.headphones)}},
    SettingInfo{"sound.mono", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.mono)}},
    SettingInfo{"sound.behind", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.behind)}},
    SettingInfo{"sound.height", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.height)}},
    SettingInfo{"sound.wall_tone", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.wall_tone)}},
    SettingInfo{"sound.contact", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.contact)}},
    SettingInfo{"sound.slide", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.slide)}},
    SettingInfo{"sound.door", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.door)}},
    SettingInfo{"sound.splash", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.splash)}},
    SettingInfo{"sound.footstep", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.footstep)}},
    SettingInfo{"sound.bump", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.bump)}},
    SettingInfo{"sound.world", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.world)}},
    SettingInfo{"sound.denied", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.denied)}},
    SettingInfo{"sound.forces", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.forces)}},
    SettingInfo{"sound.turn", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.turn)}},
    SettingInfo{"sound.frame", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.frame)}},
    SettingInfo{"sound.arrived", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.arrived)}},
    SettingInfo{"sound.corner", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.corner)}},
    SettingInfo{"sound.drop", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.drop)}},
    SettingInfo{"sound.ways", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.ways)}},
    SettingInfo{"sound.workspace", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.workspace)}},
    SettingInfo{"sound.desk", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.desk)}},
    SettingInfo{"sound.marks", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.marks)}},
    SettingInfo{"sound.beacon", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.beacon)}},
    SettingInfo{"sound.guide", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.guide)}},
    SettingInfo{"sound.swap_sides", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.swap_sides)}},
    SettingInfo{"sound.as_text", "", kPersonOnly, SwitchField{HANDRAIL_AT(sound.as_text)}},
    SettingInfo{
        "sound.spotlight", "", kPersonOnly,
        ChoiceField{kSpotlightWords, [](const Settings& s) { return static_cast<std::size_t>(s.sound.spotlight); },
                    [](Settings& s, std::size_t i) { s.sound.spotlight = static_cast<SpotlightChoice>(i); }}},
    SettingInfo{"sound.spotlight_deg", "deg", kPersonOnly, NumberField{HANDRAIL_AT(sound.spotlight_deg), 10.0, 180.0}},
    SettingInfo{"sound.most_at_once", "", kPersonOnly, WholeField{HANDRAIL_AT(sound.most_at_once), 1, 8}},
    SettingInfo{"cane.technique", "", kPersonOnly,
                ChoiceField{kCaneWords, [](const Settings& s) { return static_cast<std::size_t>(s.cane.technique); },
                            [](Settings& s, std::size_t i) { s.cane.technique = static_cast<CaneTechnique>(i); }}},
    SettingInfo{"cane.length_m", "m", kPersonOnly, NumberField{HANDRAIL_AT(cane.length_m), 0.9, 1.8}},
    SettingInfo{"desk.use", "", kPersonOnly, SwitchField{HANDRAIL_AT(desk.use)}},
    SettingInfo{"dynamics.strength_n", "n", kPersonOnly, NumberField{HANDRAIL_AT(dynamics.strength_n), 5.0, 500.0}},
    SettingInfo{"pads.use", "", kPersonOnly, SwitchField{HANDRAIL_AT(pads.use)}},
    SettingInfo{"pads.triggers", "", kPersonOnly, SwitchField{HANDRAIL_AT(pads.triggers)}},
    SettingInfo{"pads.rumble", "", kPersonOnly, SwitchField{HANDRAIL_AT(pads.rumble)}},
    SettingInfo{"pads.strength", "", kPersonOnly, NumberField{HANDRAIL_AT(pads.strength), 0.0, 1.0}},
    SettingInfo{"marks.ask_name", "", kPersonOnly, SwitchField{HANDRAIL_AT(marks.ask_name)}},
    SettingInfo{"marks.button", "", kPersonOnly, WholeField{HANDRAIL_AT(marks.button), 0, 8}},
    SettingInfo{"guidance.pull", "", kPersonOnly, SwitchField{HANDRAIL_AT(guidance.pull)}},
    SettingInfo{"guidance.strength", "", kPersonOnly, NumberField{HANDRAIL_AT(guidance.strength), 0.1, 1.0}},
    SettingInfo{"guidance.fades", "", kPersonOnly, SwitchField{HANDRAIL_AT(guidance.fades)}},
    SettingInfo{"guidance.grooves", "", kPersonOnly, SwitchField{HANDRAIL_AT(guidance.grooves)}},
    SettingInfo{"guidance.along_way", "", kPersonOnly, SwitchField{HANDRAIL_AT(guidance.along_way)}},
    SettingInfo{"keyboard.hand", "", kPersonOnly,
                ChoiceField{kKeyboardWords, [](const Settings& s) { return static_cast<std::size_t>(s.keyboard.hand); },
                            [](Settings& s, std::size_t i) { s.keyboard.hand = static_cast<KeyboardHand>(i); }}},
    SettingInfo{"display.text_size", "", kPersonOnly, NumberField{HANDRAIL_AT(display.text_size), 0.5, 1.5}},
    SettingInfo{"display.colours", "", kPersonOnly,
                ChoiceField{kColourWords, [](const Settings& s) { return static_cast<std::size_t>(s.display.colours); },
                            [](Settings& s, std::size_t i) { s.display.colours = static_cast<ColourSet>(i); }}},
    SettingInfo{"display.outline_width", "", kPersonOnly, NumberField{HANDRAIL_AT(display.outline_width), 0.5, 3.0}},
    SettingInfo{"display.reduced_motion", "", kPersonOnly, SwitchField{HANDRAIL_AT(display.reduced_motion)}},
    SettingInfo{"display.full_screen", "", kPersonOnly, SwitchField{HANDRAIL_AT(display.full_screen)}},
    SettingInfo{"display.place", "", kPersonOnly, TextField{HANDRAIL_AT(display.place)}},
    SettingInfo{"welcome.done", "", kPersonOnly, SwitchField{HANDRAIL_AT(welcome.done)}},
    SettingInfo{"welcome.step", "", kPersonOnly, WholeField{HANDRAIL_AT(welcome.step), 0, 20}},
};
#undef HANDRAIL_AT

using Override = Settings::Workspace::Override;
const std::array kOverrides{
    OverrideInfo{"scale", &kTable[0], &Override::scale},
    OverrideInfo{"offset_ahead_m", &kTable[1], &Override::offset_ahead_m},
    OverrideInfo{"offset_up_m", &kTable[2], &Override::offset_up_m},
    OverrideInfo{"hand_height_m", &kTable[3], &Override::hand_height_m},
};

using Profile = DeviceProfile;
constexpr std::array kProfile{
    ProfileInfo{"ceiling_n", "n", 0.5, 40.0, &Profile::ceiling_n},
    ProfileInfo{"gentlest_n", "n", 0.02, 2.0, &Profile::gentlest_n},
    ProfileInfo{"hand", "", 0.0, 0.0, nullptr, kHandWords},
    ProfileInfo{"scale", "scale", 1.0, 500.0, &Profile::scale},
    ProfileInfo{"offset_ahead_m", "hand_m", -0.1, 0.1, &Profile::offset_ahead_m},
    ProfileInfo{"offset_up_m", "hand_m", -0.1, 0.1, &Profile::offset_up_m},
    ProfileInfo{"width_m", "hand_m", 0.01, 1.0, &Profile::width_m},
    ProfileInfo{"depth_m", "hand_m", 0.01, 1.0, &Profile::depth_m},
    ProfileInfo{"height_m", "hand_m", 0.01, 1.0, &Profile::height_m},
};

std::string what_it_is(const SettingValue& value) {
    return std::visit(
        Overloaded{[](bool v) { return std::string(v ? "true" : "false"); },
                   [](std::int64_t v) { return fmt::format("{}", v); }, [](double v) { return fmt::format("{}", v); },
                   [](const std::string& v) { return fmt::format("\"{}\"", v.substr(0, kLongestText)); }},
        value);
}

// Returns an error such as "workspace.scale is 900, but must be 1 to 500 world metres per hand metre."
template <class Info>
tl::unexpected<Error> refuse(std::string_view key, const Info& info, const SettingValue& value) {
    if (info.unit.empty())
        return fail(
            phrase("setting_error.refused", {{"key", key}, {"value", what_it_is(value)}, {"range", range_of(info)}}));
    return fail(phrase(
        "setting_error.refused_unit",
        {{"key", key}, {"value", what_it_is(value)}, {"range", range_of(info)}, {"unit", spoken_unit(info.unit)}}));
}

// Numbers have a decimal point in every language, because the person must type them so.
std::string number_range(double least, double most) {
    return phrase("setting_range.number", {{"least", fmt::format("{}", least)}, {"most", fmt::format("{}", most)}});
}

// Returns the words as an enumeration: "light, normal or full".
std::string any_of_words(std::span<const std::string_view> words) {
    return phrase("setting_range.words", {{"words", fmt::format("{}", fmt::join(words.first(words.size() - 1), ", "))},
                                          {"last", words.back()}});
}

// Returns the index of the word that equals the value, ignoring case. Empty if none does.
std::optional<std::size_t> index_of_word(std::span<const std::string_view> words, const SettingValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    const auto word = text ? std::find(words.begin(), words.end(), lower_ascii(*text)) : words.end();
    if (word == words.end()) return std::nullopt;
    return static_cast<std::size_t>(word - words.begin());
}

std::optional<double> as_number(const SettingValue& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
    if (const auto* decimal = std::get_if<double>(&value); decimal && std::isfinite(*decimal)) return *decimal;
    return std::nullopt;
}

}  // namespace

std::span<const SettingInfo> settings_table() { return kTable; }
std::span<const OverrideInfo> override_table() { return kOverrides; }
std::span<const ProfileInfo> profile_table() { return kProfile; }

const SettingInfo* find_setting(std::string_view key) {
    const auto found =
        std::find_if(kTable.begin(), kTable.end(), [&](const SettingInfo& info) { return info.key == key; });
    return found == kTable.end() ? nullptr : &*found;
}

bool world_may_set(std::string_view key) {
    const SettingInfo* info = find_setting(key);
    return info && info->world_may_set;
}

std::string range_of(const SettingInfo& info) {
    return std::visit(Overloaded{[](const NumberField& f) { return number_range(f.least, f.most); },
                                 [](const WholeField& f) {
                                     return phrase("setting_range.whole", {{"least", f.least}, {"most", f.most}});
                                 },
                                 [](const SwitchField&) { return phrase("setting_range.switch"); },
                                 [](const ChoiceField& f) { return any_of_words(f.words); },
                                 [&](const TextField&) { return phrase("setting_range." + std::string(info.key)); }},
                      info.field);
}

std::string range_of(const ProfileInfo& info) {
    return info.number ? number_range(info.least, info.most) : any_of_words(info.words);
}

std::string meaning_of(const SettingInfo& info) { return phrase("setting." + std::string(info.key)); }
std::string meaning_of(const ProfileInfo& info) { return phrase("setting.profile." + std::string(info.field)); }
std::string spoken_unit(std::string_view unit) {
    return unit.empty() ? std::string() : phrase("unit." + std::string(unit));
}

Result<void> apply(std::string_view key, const ProfileInfo& info, const SettingValue& value, DeviceProfile& profile) {
    if (info.number) {
        const std::optional<double> number = as_number(value);
        if (!number || *number < info.least || *number > info.most) return refuse(key, info, value);
        profile.*info.number = *number;
    } else {
        const std::optional<std::size_t> word = index_of_word(info.words, value);
        if (!word) return refuse(key, info, value);
        profile.hand = static_cast<HoldingHand>(*word);
    }
    return {};
}

SettingValue value_from_word(const ProfileInfo& info, std::string_view word) {
    double number = 0.0;
    if (info.number && parse_finite(word, number)) return number;
    return std::string(word);
}

Result<double> number_in_range(std::string_view key, const SettingInfo& plain, const SettingValue& value) {
    const auto& field = std::get<NumberField>(plain.field);
    const std::optional<double> number = as_number(value);
    if (!number || *number < field.least || *number > field.most) return refuse(key, plain, value);
    return *number;
}

bool is_short_text(std::string_view text) {
    const auto unprintable = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    return !text.empty() && text.size() <= kLongestText && std::none_of(text.begin(), text.end(), unprintable) &&
           is_utf8(text);
}

Result<std::string> short_text(std::string_view key, const SettingValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    if (!text || !is_short_text(*text))
        return fail(phrase("setting_error.not_short_text", {{"key", key}, {"most", kLongestText}}));
    return *text;
}

Result<std::string> key_text(std::string_view key, const SettingValue& value) {
    Result<std::string> text = short_text(key, value);
    if (!text) return text;
    if (const auto wrong = misnamed_key(*text))
        return fail(
            phrase("setting_error.no_key", {{"key", key}, {"word", *wrong}, {"nearest", nearest_key_name(*wrong)}}));
    return text;
}

Result<void> apply(const SettingInfo& info, const SettingValue& value, Settings& settings) {
    return std::visit(
        Overloaded{[&](const NumberField& f) -> Result<void> {
                       return number_in_range(info.key, info, value).map([&](double number) {
                           f.at(settings) = number;
                       });
                   },
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
                       const std::optional<std::size_t> word = index_of_word(f.words, value);
                       if (!word) return refuse(info.key, info, value);
                       f.set(settings, *word);
                       return {};
                   },
                   [&](const TextField& f) -> Result<void> {
                       return short_text(info.key, value).map([&](const std::string& text) { f.at(settings) = text; });
                   }},
        info.field);
}

SettingValue current_value(const SettingInfo& info, const Settings& settings) {
    // The accessors need a non-const reference, but nothing is written through them here.
    Settings& s = const_cast<Settings&>(settings);
    return std::visit(Overloaded{[&](const NumberField& f) -> SettingValue { return f.at(s); },
                                 [&](const WholeField& f) -> SettingValue { return std::int64_t{f.at(s)}; },
                                 [&](const SwitchField& f) -> SettingValue { return f.at(s); },
                                 [&](const ChoiceField& f) -> SettingValue { return std::string(f.words[f.get(s)]); },
                                 [&](const TextField& f) -> SettingValue { return f.at(s); }},
                      info.field);
}

std::string without_quotes(std::string_view word) {
    const bool quoted = word.size() >= 2 && word.front() == '"' && word.back() == '"';
    return std::string(quoted ? word.substr(1, word.size() - 2) : word);
}

SettingValue value_from_word(const SettingInfo& info, std::string_view word) {
    if (const std::string bare = without_quotes(word); bare.size() < word.size()) return bare;
    if (std::holds_alternative<ChoiceField>(info.field) || std::holds_alternative<TextField>(info.field))
        return std::string(word);
    if (word == "true" || word == "on") return true;
    if (word == "false" || word == "off") return false;
    double number = 0.0;
    if (!parse_finite(word, number)) return std::string(word);
    if (std::holds_alternative<WholeField>(info.field) && number == std::floor(number) && std::abs(number) < 1e9)
        return static_cast<std::int64_t>(number);
    return number;
}

}  // namespace handrail::settings
