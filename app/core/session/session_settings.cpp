// The part of Session that applies changed settings while the session runs. The program replaces all settings at once;
// a key, a list or a typed line changes one. App thread only.
#include <algorithm>
#include <array>

#include "app/core/context/device_settings.h"
#include "app/core/kept/spoken_language.h"
#include "app/core/session/session.h"

namespace handrail::core {
namespace {

// What the session must do after a setting has changed, in addition to storing its value.
enum class Follows : std::uint8_t {
    Nothing,
    Pose,       // move the workspace
    Tuning,     // tune the servo again, which lets the force rise again from zero
    UnderHand,  // turn or change the workspace; the point of the world under the hand stays under the hand
    Scale,      // change the scale; the point under the hand stays there, and no named scale is effective after that
    Keys,       // assign keys to other commands
    Language,   // get the names from another language
};
struct Consequence {
    std::string_view key;  // key of a setting; a key that ends with a dot is a prefix
    Follows follows;
};
constexpr std::array kConsequences{
    Consequence{"workspace.scale", Follows::Scale},
    Consequence{"workspace.offset_ahead_m", Follows::Pose},
    Consequence{"workspace.offset_up_m", Follows::Pose},
    Consequence{"workspace.hand_height_m", Follows::Pose},
    Consequence{"workspace.frame", Follows::Pose},
    Consequence{"workspace.follows_walk", Follows::Pose},
    Consequence{"workspace.turn_deg", Follows::UnderHand},
    Consequence{"workspace.rim", Follows::Tuning},
    Consequence{"workspace.grab_button", Follows::Tuning},
    Consequence{"haptic.stiffness_fraction", Follows::Tuning},
    Consequence{"haptic.friction_mu", Follows::Tuning},
    Consequence{"haptic.damping_ns_per_m", Follows::Tuning},
    Consequence{"haptic.ceiling", Follows::Tuning},
    Consequence{"haptic.button_to_feel", Follows::Tuning},
    Consequence{"desk.use", Follows::Tuning},
    Consequence{"dynamics.strength_n", Follows::Tuning},
    Consequence{"haptic.ball_diameter_mm", Follows::UnderHand},
    Consequence{"haptic.edge_rounding_mm", Follows::UnderHand},
    Consequence{"haptic.simplify", Follows::UnderHand},
    Consequence{"haptic.mesh_tolerance_mm", Follows::UnderHand},
    Consequence{"walk.body_radius_m", Follows::UnderHand},
    Consequence{"keyboard.hand", Follows::Keys},
    Consequence{"keys.", Follows::Keys},
    Consequence{"speech.language", Follows::Language},
};

Follows what_follows(std::string_view key) {
    const auto row = std::find_if(kConsequences.begin(), kConsequences.end(), [&](const Consequence& one) {
        return one.key.ends_with('.') ? key.starts_with(one.key) : key == one.key;
    });
    return row == kConsequences.end() ? Follows::Nothing : row->follows;
}

}  // namespace

void Session::change_settings(const settings::Settings& settings, double now_s) {
    take_settings(settings, now_s);
    if (state_.world.scene) hand_.workspace.take_settings(now_s);
}

// Applies all settings. The caller applies the consequences for the hand and the world.
void Session::take_settings(settings::Settings settings, double now_s) {
    speak_language_of(settings.speech, now_s);
    state_.person.settings = std::move(settings);
    lay_device_overrides(state_.person.settings, state_.hands.right);
    state_.person.keys = KeyMap(state_.person.settings.keys, state_.person.settings.keyboard.hand);
}

void Session::speak_language_of(const settings::Settings::Speech& speech, double now_s) {
    if (speech.language == state_.person.settings.speech.language) return;
    for (const Diagnostic& fault : speak_as_set(speech, menu_.languages().folder()))
        say(fault.sentence(), cues::SpeechClass::Answer, now_s);
    desk_visit_.furnish();  // The controls of the desk get names in the new language.
}

// Changes one setting. Every change of a single setting goes through this function. The owner of the settings stores
// and saves them.
Result<void> Session::set(std::string_view key, const std::string& value, double now_s) {
    settings::Settings changed = state_.person.settings;
    if (auto done = settings::change_setting(changed, key, value); !done) return done;
    const std::string written = settings::setting_text(changed, key).value_or(value);
    state_.person.changes.emplace_back(key, written);
    if (what_follows(key) == Follows::Scale && at_desk()) desk_visit_.keep_scale(written);
    else follow(key, std::move(changed), now_s);
    return {};
}

// Applies `changed`, in which only the value of `key` is new, with the consequences of that change.
void Session::follow(std::string_view key, settings::Settings changed, double now_s) {
    const Follows follows = what_follows(key);
    if (follows == Follows::Language) speak_language_of(changed.speech, now_s);
    const auto take = [&] {
        if (follows == Follows::Scale) state_.hands.named_scale.reset();
        state_.person.settings = std::move(changed);
        return true;
    };
    // At the desk, the workspace must not move, because a jump would end the visit.
    const bool moves = state_.world.scene && !at_desk();
    const bool under_hand = follows == Follows::UnderHand || follows == Follows::Scale;
    if (under_hand && moves) return hand_.workspace.change_under_hand(take, now_s);
    take();
    if (follows == Follows::Keys)
        state_.person.keys = KeyMap(state_.person.settings.keys, state_.person.settings.keyboard.hand);
    if (state_.world.scene && (under_hand || follows == Follows::Tuning)) hand_.touch_view.retune();
    if (moves && (follows == Follows::Pose || follows == Follows::Tuning)) publish_pose(now_s, PoseChange::Moved);
}

}  // namespace handrail::core
