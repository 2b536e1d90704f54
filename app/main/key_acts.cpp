#include "app/main/key_acts.h"

namespace handrail::program {

void KeyActs::take(const window::KeyEvent& key, wizard::WizardSession* wizard, double now_s) {
    const auto command = app_.keys().find(key.key);
    if (wizard) {  // ignore the stop key below, because ServoSwitches has already carried it out
        if (key.action != window::KeyAction::Release && command != core::Command::StopEverything)
            wizard->press(key.key, now_s);
        return;
    }
    // While the first world is read, the Leave key ends the program. While another world is read, the Leave key cancels
    // that.
    const bool leaves =
        key.action == window::KeyAction::Press && command == core::Command::Leave && !app_.dialogue().is_open();
    if (leaves && !app_.scene()) closed_ = true;
    if (leaves && worlds_.give_up_reading(now_s)) return;
    // The characters of a key arrive after the key itself. They belong to the list or question that was open before the
    // key was pressed, so store whether one was open.
    typing_ = app_.dialogue().is_open();
    if (key.action != window::KeyAction::Release && app_.apply(core::KeyTapped{key.key}, now_s)) return;
    if (!command || !app_.scene()) return;
    if (key.action == window::KeyAction::Press) app_.apply(core::CommandDown{*command}, now_s);
    else if (key.action == window::KeyAction::Release) app_.apply(core::CommandUp{*command}, now_s);
}

void KeyActs::take_text(const std::string& utf8, wizard::WizardSession* wizard, double now_s) {
    if (typing_ && !wizard) app_.apply(core::TextTyped{utf8}, now_s);
}

}  // namespace handrail::program
