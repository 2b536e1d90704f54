// Session's part on settings that change while it goes on: all of them from outside, one of them by a command. App
// thread only.
#include "app/core/context/device_settings.h"
#include "app/core/kept/spoken_language.h"
#include "app/core/session/session.h"
#include "settings/adjust.h"

namespace handrail {

void Session::change_settings(const Settings& settings, double now_s) {
    take_settings(settings, now_s);
    if (state_.world.scene) hand_.workspace.take_settings(now_s);
}

// Without what follows for the hand and the world it is in.
void Session::take_settings(Settings settings, double now_s) {
    if (settings.speech.language != state_.person.settings.speech.language) {
        for (const Diagnostic& fault : speak_as_set(settings.speech, menu_.languages().folder()))
            say(fault.sentence(), SpeechClass::Answer, now_s);
        desk_visit_.furnish();  // its controls' names
    }
    state_.person.settings = std::move(settings);
    lay_device_overrides(state_.person.settings, state_.hands.right);
    state_.person.keys = KeyMap(state_.person.settings.keys, state_.person.settings.keyboard.hand);
}

// A live change, wherever it comes from: at once in force, stored and saved by whoever owns the settings.
Result<void> Session::change_setting(std::string_view key, const std::string& value, double now_s) {
    Settings changed = state_.person.settings;
    if (auto done = handrail::change_setting(changed, key, value); !done) return done;
    state_.person.changes.emplace_back(std::string(key), setting_text(changed, key).value_or(value));
    if (key == "workspace.scale" && at_desk()) {
        desk_visit_.keep_scale(value);
        return {};
    }
    if (key == "haptic.simplify" && state_.world.scene && !at_desk()) {
        feel_otherwise(changed, now_s);
        return {};
    }
    if (key != "workspace.scale") {
        state_.person.settings = std::move(changed);
        if (state_.world.scene) hand_.touch_view.retune();
        return {};
    }
    rescale(changed, now_s);
    return {};
}

// The same as a list has it; what it is then, or why it cannot be.
std::string Session::change_setting(std::string_view key, const std::string& value) {
    Settings changed = state_.person.settings;
    if (const auto set = set_in(changed, key, value); !set) return set.error().message;
    state_.person.changes.emplace_back(std::string(key), value);
    change_settings(changed, state_.context.tick_s);
    return setting_line(key, state_.person.settings).value;
}

}  // namespace handrail
