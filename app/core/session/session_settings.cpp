// Session's part on settings that change while it goes on: all of them from outside, one of them by a command. App
// thread only.
#include "app/core/context/device_settings.h"
#include "app/core/kept/spoken_language.h"
#include "app/core/session/session.h"
#include "settings/adjust.h"

namespace handrail {

void Session::change_settings(const Settings& settings, double now_s) {
    if (settings.speech.language != person_.settings.speech.language) {
        for (const Diagnostic& fault : speak_as_set(settings.speech, menu_.languages().folder()))
            say(fault.sentence(), SpeechClass::Answer, now_s);
        desk_visit_.furnish();  // its controls' names
    }
    person_.settings = settings;
    lay_device_overrides(person_.settings, hands_.right);
    person_.keys = KeyMap(person_.settings.keys, person_.settings.keyboard.hand);
    if (world_.scene) workspace_.take_settings(now_s);
}

// A live change, wherever it comes from: at once in force, stored and saved by whoever owns the settings.
Result<void> Session::change_setting(std::string_view key, const std::string& value, double now_s) {
    Settings changed = person_.settings;
    if (auto done = handrail::change_setting(changed, key, value); !done) return done;
    person_.changes.emplace_back(std::string(key), setting_text(changed, key).value_or(value));
    if (key == "workspace.scale" && at_desk()) {
        desk_visit_.keep_scale(value);
        return {};
    }
    if (key == "haptic.simplify" && world_.scene && !at_desk()) {
        feel_otherwise(changed, now_s);
        return {};
    }
    if (key != "workspace.scale") {
        person_.settings = std::move(changed);
        if (world_.scene) touch_view_.retune();
        return {};
    }
    rescale(changed, now_s);
    return {};
}

// The same as a list has it; what it is then, or why it cannot be.
std::string Session::change_setting(std::string_view key, const std::string& value) {
    Settings changed = person_.settings;
    if (const auto set = set_in(changed, key, value); !set) return set.error().message;
    person_.changes.emplace_back(std::string(key), value);
    change_settings(changed, context_.tick_s);
    return setting_line(key, person_.settings).value;
}

}  // namespace handrail
