#include "settings/table.h"

#include "worlds/base/overloaded.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

constexpr std::array<std::string_view, 3> kCeilingWords{"light", "normal", "full"};
constexpr std::array<std::string_view, 2> kFrameWords{"map", "walk"};
constexpr std::array<std::string_view, 2> kHandWords{"right", "left"};
constexpr std::array<std::string_view, 3> kKeyboardWords{"both", "left", "right"};
constexpr std::array<std::string_view, 3> kDirectionWords{"sides", "clock", "compass"};
constexpr std::array<std::string_view, 5> kThroughWords{"auto", "screen-reader", "speech-dispatcher", "embedded", "text"};
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
    SettingInfo{"workspace.turn_deg", "degrees", "How far the workspace is turned against its frame, clockwise.", kPersonOnly,
                NumberField{HANDRAIL_AT(workspace.turn_deg), -180.0, 180.0}},
    SettingInfo{"workspace.follows_walk", "", "The workspace goes where the body walks.", kPersonOnly, SwitchField{HANDRAIL_AT(workspace.follows_walk)}},
    SettingInfo{"workspace.rim", "", "Pressing the hand past the rim of its reach moves the workspace on.", kPersonOnly,
                SwitchField{HANDRAIL_AT(workspace.rim)}},
    SettingInfo{"workspace.grab_button", "", "Button of the device that takes the world along with the hand while it is held; 0 is none.", kPersonOnly,
                WholeField{HANDRAIL_AT(workspace.grab_button), 0, 8}},
    SettingInfo{"haptic.stiffness_fraction", "fraction of the device's rating", "Hardness of surfaces that name none.", kPersonOnly,
                NumberField{HANDRAIL_AT(haptic.stiffness_fraction), 0.0, 1.0}},
    SettingInfo{"haptic.friction_mu", "", "Friction of surfaces that name none.", kWorldToo, NumberField{HANDRAIL_AT(haptic.friction_mu), 0.0, 2.0}},
    SettingInfo{"haptic.damping_ns_per_m", "newton seconds per metre", "Damping of surfaces, against the hand's speed.", kPersonOnly,
                NumberField{HANDRAIL_AT(haptic.damping_ns_per_m), 0.0, 20.0}},
    SettingInfo{"haptic.ball_diameter_mm", "millimetres of hand travel", "Felt size of the ball that touches, at scale 60.", kWorldToo,
                NumberField{HANDRAIL_AT(haptic.ball_diameter_mm), 1.0, 10.0}},
    SettingInfo{"haptic.edge_rounding_mm", "millimetres of hand travel", "Radius by which the outer edges of solids are rounded; sharp at scales below 30.",
                kWorldToo, NumberField{HANDRAIL_AT(haptic.edge_rounding_mm), 0.0, 3.0}},
    SettingInfo{"haptic.ceiling", "", "Strongest force: light is 1.2 newtons, normal 2.5, full what the device can do.", kPersonOnly,
                ChoiceField{kCeilingWords, [](const Settings& s) { return static_cast<std::size_t>(s.haptic.ceiling); },
                            [](Settings& s, std::size_t i) { s.haptic.ceiling = static_cast<ForceCeiling>(i); }}},
    SettingInfo{"haptic.button_to_feel", "", "Force only while a button of the device is held; let go, it is gone within a tenth of a second.", kPersonOnly,
                SwitchField{HANDRAIL_AT(haptic.button_to_feel)}},
    SettingInfo{"haptic.device", "", "Which haptic device to use.", kPersonOnly, TextField{HANDRAIL_AT(haptic.device), "auto, none or a device's name"}},
    SettingInfo{"haptic.left_device", "", "A second haptic device, for the left hand; the first is then the right one.", kPersonOnly,
                TextField{HANDRAIL_AT(haptic.left_device), "none, a device's name or its serial number"}},
    SettingInfo{"walk.step_length_m", "metres", "Length of one step.", kWorldToo, NumberField{HANDRAIL_AT(walk.step_length_m), 0.2, 1.5}},
    SettingInfo{"walk.speed_m_per_s", "metres per second", "Walking speed while a key is held.", kWorldToo,
                NumberField{HANDRAIL_AT(walk.speed_m_per_s), 0.2, 3.0}},
    SettingInfo{"walk.turn_deg", "degrees", "How far one press of Left or Right turns.", kWorldToo, NumberField{HANDRAIL_AT(walk.turn_deg), 1.0, 90.0}},
    SettingInfo{"walk.body_radius_m", "metres", "Radius of the walking body.", kWorldToo, NumberField{HANDRAIL_AT(walk.body_radius_m), 0.1, 0.6}},
    SettingInfo{"walk.callouts", "", "Stairs, drops, ramps and openings are told without being asked for.", kPersonOnly,
                SwitchField{HANDRAIL_AT(walk.callouts)}},
    SettingInfo{"walk.stop_at_drops", "", "At an edge the body stops until the key is pressed a second time.", kPersonOnly,
                SwitchField{HANDRAIL_AT(walk.stop_at_drops)}},
    SettingInfo{"speech.through", "", "Who speaks; auto takes the first of the others that is there, in this order.", kPersonOnly,
                ChoiceField{kThroughWords, [](const Settings& s) { return static_cast<std::size_t>(s.speech.through); },
                            [](Settings& s, std::size_t i) { s.speech.through = static_cast<SpeechThrough>(i); }}},
    SettingInfo{"speech.rate_wpm", "words per minute", "How fast the built-in voice speaks; other voices keep their own rate.", kPersonOnly,
                WholeField{HANDRAIL_AT(speech.rate_wpm), 80, 450}},
    SettingInfo{"speech.verbosity", "", "How much is said: 0 is sounds alone, 4 is everything.", kPersonOnly, WholeField{HANDRAIL_AT(speech.verbosity), 0, 4}},
    SettingInfo{"speech.language", "", "The language of what is said; auto is that of your desktop, or English.", kPersonOnly,
                TextField{HANDRAIL_AT(speech.language), "auto or the code of a language, such as en or de"}},
    SettingInfo{"speech.voice", "", "Voice or language of the built-in speech; auto is that of what is said.", kPersonOnly,
                TextField{HANDRAIL_AT(speech.voice), "auto, an espeak-ng voice or language"}},
    SettingInfo{"speech.distances_in_steps", "", "Short distances are said in steps, else in metres.", kPersonOnly,
                SwitchField{HANDRAIL_AT(speech.distances_in_steps)}},
    SettingInfo{"speech.directions", "", "Directions are said by your sides with degrees, by the clock, or by the compass.", kPersonOnly,
                ChoiceField{kDirectionWords, [](const Settings& s) { return static_cast<std::size_t>(s.speech.directions); },
                            [](Settings& s, std::size_t i) { s.speech.directions = static_cast<DirectionChoice>(i); }}},
    SettingInfo{"speech.rounded", "", "Distances and degrees are rounded, more the farther; else said to the decimetre and degree.", kPersonOnly,
                SwitchField{HANDRAIL_AT(speech.rounded)}},
    SettingInfo{"speech.rooms", "", "The name of a room is told when one comes into it.", kPersonOnly, SwitchField{HANDRAIL_AT(speech.rooms)}},
    SettingInfo{"speech.braille", "", "What is said also stands on a braille display, where no screen reader sees to that.", kPersonOnly,
                SwitchField{HANDRAIL_AT(speech.braille)}},
    SettingInfo{"speech.crowding_hint", "", "On entering a world it is told where more than five materials lie close together.", kPersonOnly,
                SwitchField{HANDRAIL_AT(speech.crowding_hint)}},
    SettingInfo{"sound.volume", "", "Volume of everything; alarms stay audible.", kPersonOnly, NumberField{HANDRAIL_AT(sound.volume), 0.0, 1.0}},
    SettingInfo{"sound.speech_volume", "", "Volume of speech.", kPersonOnly, NumberField{HANDRAIL_AT(sound.speech_volume), 0.0, 1.0}},
    SettingInfo{"sound.contact_volume", "", "Volume of touching and sliding.", kPersonOnly, NumberField{HANDRAIL_AT(sound.contact_volume), 0.0, 1.0}},
    SettingInfo{"sound.footstep_volume", "", "Volume of footsteps.", kPersonOnly, NumberField{HANDRAIL_AT(sound.footstep_volume), 0.0, 1.0}},
    SettingInfo{"sound.wall_tone_volume", "", "Volume of the tone near walls.", kPersonOnly, NumberField{HANDRAIL_AT(sound.wall_tone_volume), 0.0, 1.0}},
    SettingInfo{"sound.world_volume", "", "Volume of the world's own sounds.", kPersonOnly, NumberField{HANDRAIL_AT(sound.world_volume), 0.0, 1.0}},
    SettingInfo{"sound.earcon_volume", "", "Volume of the short signals that answer a key.", kPersonOnly,
                NumberField{HANDRAIL_AT(sound.earcon_volume), 0.0, 1.0}},
    SettingInfo{"sound.beacon_volume", "", "Volume of the beacon, and of warmer and colder.", kPersonOnly,
                NumberField{HANDRAIL_AT(sound.beacon_volume), 0.0, 1.0}},
    SettingInfo{"sound.reverberation", "", "How much rooms echo; 0 is not at all.", kPersonOnly, NumberField{HANDRAIL_AT(sound.reverberation), 0.0, 1.0}},
    SettingInfo{"sound.periods", "", "Periods of 5.3 milliseconds that the sound device holds, from the next start on; more are later and steadier.",
                kPersonOnly, WholeField{HANDRAIL_AT(sound.periods), 2, 8}},
    SettingInfo{"sound.headphones", "", "Sound is filtered for headphones, else plain stereo for loudspeakers, from the next start on.", kPersonOnly,
                SwitchField{HANDRAIL_AT(sound.headphones)}},
    SettingInfo{"sound.mono", "", "Everything sounds from the middle, for one loudspeaker or one ear.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.mono)}},
    SettingInfo{"sound.behind", "", "The world's sounds flutter when they are behind you.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.behind)}},
    SettingInfo{"sound.height", "", "The world's sounds rise when they are above you and fall when they are below.", kPersonOnly,
                SwitchField{HANDRAIL_AT(sound.height)}},
    SettingInfo{"sound.wall_tone", "", "A tone tells that a wall is near.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.wall_tone)}},
    SettingInfo{"sound.contact", "", "Surfaces sound when the hand meets them.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.contact)}},
    SettingInfo{"sound.slide", "", "Surfaces sound when the hand slides along them.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.slide)}},
    SettingInfo{"sound.door", "", "Doors, lifts and buttons are heard as they move.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.door)}},
    SettingInfo{"sound.splash", "", "Liquids splash.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.splash)}},
    SettingInfo{"sound.footstep", "", "Steps sound like the floor.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.footstep)}},
    SettingInfo{"sound.bump", "", "Walls thud when the body meets them.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.bump)}},
    SettingInfo{"sound.world", "", "Things that make a sound of their own are heard.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.world)}},
    SettingInfo{"sound.denied", "", "A signal tells that something cannot be done.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.denied)}},
    SettingInfo{"sound.forces", "", "A signal tells that forces go on or off.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.forces)}},
    SettingInfo{"sound.turn", "", "A tick tells each turn.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.turn)}},
    SettingInfo{"sound.frame", "", "A signal tells the change between Map and Walk.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.frame)}},
    SettingInfo{"sound.arrived", "", "A signal tells that you have arrived.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.arrived)}},
    SettingInfo{"sound.corner", "", "Corners chime, and openings are heard, as you trail a wall.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.corner)}},
    SettingInfo{"sound.drop", "", "A beat warns of an edge, from two metres on.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.drop)}},
    SettingInfo{"sound.ways", "", "Doors and stairs before you are heard.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.ways)}},
    SettingInfo{"sound.workspace", "", "Signals tell when the rim and the grip begin and end to move the workspace.", kPersonOnly,
                SwitchField{HANDRAIL_AT(sound.workspace)}},
    SettingInfo{"sound.desk", "", "The wall to your desk and what is pressed there click.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.desk)}},
    SettingInfo{"sound.marks", "", "Marks, landmarks and clues sound when hand or body comes near.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.marks)}},
    SettingInfo{"sound.beacon", "", "The beacon, and warmer and colder, are heard.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.beacon)}},
    SettingInfo{"sound.guide", "", "Signals tell when the hand begins and ends to be led.", kPersonOnly, SwitchField{HANDRAIL_AT(sound.guide)}},
    SettingInfo{"sound.swap_sides", "", "Exchanges the left and the right ear, where headphones are the other way round.", kPersonOnly,
                SwitchField{HANDRAIL_AT(sound.swap_sides)}},
    SettingInfo{"desk.use", "", "Pulled towards you through a wall, the hand comes to a desk of controls; a key lists them too.", kPersonOnly,
                SwitchField{HANDRAIL_AT(desk.use)}},
    SettingInfo{"pads.use", "", "Game pads and SpaceMouse walk and give cues.", kPersonOnly, SwitchField{HANDRAIL_AT(pads.use)}},
    SettingInfo{"pads.triggers", "", "Triggers of a pad resist, tremble and click.", kPersonOnly, SwitchField{HANDRAIL_AT(pads.triggers)}},
    SettingInfo{"pads.rumble", "", "Pads knock at bumps and tremble with materials.", kPersonOnly, SwitchField{HANDRAIL_AT(pads.rumble)}},
    SettingInfo{"pads.strength", "", "How strong the cues of pads are.", kPersonOnly, NumberField{HANDRAIL_AT(pads.strength), 0.0, 1.0}},
    SettingInfo{"marks.ask_name", "", "A new mark asks for a name, which may be typed at once.", kPersonOnly, SwitchField{HANDRAIL_AT(marks.ask_name)}},
    SettingInfo{"marks.button", "", "Button of the device that sets a mark; 0 is none, and the one that grabs the world does not count.", kPersonOnly,
                WholeField{HANDRAIL_AT(marks.button), 0, 8}},
    SettingInfo{"guidance.pull", "", "Take me there leads the hand by a gentle pull; else it sets the beacon.", kPersonOnly,
                SwitchField{HANDRAIL_AT(guidance.pull)}},
    SettingInfo{"guidance.strength", "", "How strongly the hand is led; 1 is 0.8 newtons or a quarter of the device's force.", kPersonOnly,
                NumberField{HANDRAIL_AT(guidance.strength), 0.1, 1.0}},
    SettingInfo{"guidance.fades", "", "The hand is led less from lap to lap as errors fall.", kPersonOnly, SwitchField{HANDRAIL_AT(guidance.fades)}},
    SettingInfo{"keyboard.hand", "", "Which hand has the keyboard: left and right lay the most used keys under that hand alone.", kPersonOnly,
                ChoiceField{kKeyboardWords, [](const Settings& s) { return static_cast<std::size_t>(s.keyboard.hand); },
                            [](Settings& s, std::size_t i) { s.keyboard.hand = static_cast<KeyboardHand>(i); }}},
    SettingInfo{"welcome.done", "", "The first minutes are over; false begins the next start with them.", kPersonOnly, SwitchField{HANDRAIL_AT(welcome.done)}},
    SettingInfo{"welcome.step", "", "Where the first minutes go on.", kPersonOnly, WholeField{HANDRAIL_AT(welcome.step), 0, 20}},
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
    ProfileInfo{"ceiling_n", "newtons", "Strongest comfortable force; the smaller of this and haptic.ceiling counts.", 0.5, 40.0, &Profile::ceiling_n},
    ProfileInfo{"gentlest_n", "newtons", "The least force that was noticed.", 0.02, 2.0, &Profile::gentlest_n},
    ProfileInfo{"hand", "", "The hand that holds this device.", 0.0, 0.0, nullptr, kHandWords},
    ProfileInfo{"scale", "world metres per hand metre", "How much world one movement of the hand crosses.", 1.0, 500.0, &Profile::scale},
    ProfileInfo{"offset_ahead_m", "hand metres", "How far the middle of the hand's workspace lies ahead of the body.", -0.1, 0.1, &Profile::offset_ahead_m},
    ProfileInfo{"offset_up_m", "hand metres", "How far the middle of the hand's workspace is raised.", -0.1, 0.1, &Profile::offset_up_m},
    ProfileInfo{"width_m", "hand metres", "Comfortable reach from left to right.", 0.01, 1.0, &Profile::width_m},
    ProfileInfo{"depth_m", "hand metres", "Comfortable reach from near to far.", 0.01, 1.0, &Profile::depth_m},
    ProfileInfo{"height_m", "hand metres", "Comfortable reach from low to high.", 0.01, 1.0, &Profile::height_m},
};

std::string what_it_is(const SettingValue& value) {
    return std::visit(
        Overloaded{[](bool v) { return std::string(v ? "true" : "false"); }, [](std::int64_t v) { return fmt::format("{}", v); },
                   [](double v) { return fmt::format("{}", v); }, [](const std::string& v) { return fmt::format("\"{}\"", v.substr(0, kLongestText)); }},
        value);
}

// "workspace.scale is 900, but must be 1 to 500 world metres per hand metre."
template <class Info>
tl::unexpected<Error> refuse(std::string_view key, const Info& info, const SettingValue& value) {
    const std::string unit = info.unit.empty() ? "" : fmt::format(" {}", info.unit);
    return fail(fmt::format("The setting {} is {}, but must be {}{}.", key, what_it_is(value), range_of(info), unit));
}

// "light, normal or full".
std::string any_of_words(std::span<const std::string_view> words) {
    std::string text(words[0]);
    for (std::size_t i = 1; i < words.size(); ++i) text += fmt::format("{}{}", i + 1 == words.size() ? " or " : ", ", words[i]);
    return text;
}

// Which of the words a value is, whatever its case; none: nothing.
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
                                 [](const SwitchField&) { return std::string("true or false"); }, [](const ChoiceField& f) { return any_of_words(f.words); },
                                 [](const TextField& f) { return std::string(f.range); }},
                      info.field);
}

std::string range_of(const ProfileInfo& info) { return info.number ? fmt::format("{} to {}", info.least, info.most) : any_of_words(info.words); }

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
                const std::optional<std::size_t> word = index_of_word(f.words, value);
                if (!word) return refuse(info.key, info, value);
                f.set(settings, *word);
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
