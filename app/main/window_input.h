// Passes on the person's input if there is a window: keys, text, pointer movement, the accessible list, and the keys of
// the braille display. App thread. The stop key and the loss of keyboard focus also act at once, on the thread of the
// window.
#pragma once

#include <memory>

#include "app/core/session/session.h"
#include "app/main/ears.h"
#include "app/main/key_acts.h"
#include "app/main/world_visits.h"
#include "app/window/window.h"
#include "app/wizard/wizard_session.h"
#include "haptic/servo/servo_switches.h"

namespace handrail::program {

class WindowInput {
public:
    // Everything that is passed by reference must outlive this object. `ears` owns the outputs that belong to a window.
    WindowInput(std::unique_ptr<window::Window> window, core::Session& app, WorldVisits& worlds, Ears& ears,
                servo::ServoSwitches& switches, Clock& clock);

    // Call once a frame. If `wizard` is not null, it receives the input.
    void take(wizard::WizardSession* wizard);
    // Returns true if the person left before the first world was entered, or closed the window.
    bool closed() const { return closed_ || acts_.closed(); }
    void draw(const core::ViewState& view) { window_->draw(view); }
    // Returns the place of the window as the setting display.place has it; empty if it fills the screen.
    std::string place() const { return window_->place(); }

private:
    core::Session& app_;
    Ears& ears_;
    Clock& clock_;
    KeyActs acts_;
    std::unique_ptr<window::Window> window_;
    bool closed_ = false;
};

}  // namespace handrail::program
