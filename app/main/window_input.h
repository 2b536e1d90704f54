// What a person does at the window and at what goes with it: keys, text, a moved pointer, the accessible list, the
// braille display's keys. App thread; the stop key and the keyboard's loss act on the window's own thread too, at once.
#pragma once

#include <memory>

#include "app/core/session/session.h"
#include "app/main/ears.h"
#include "app/main/key_acts.h"
#include "app/main/world_visits.h"
#include "app/window/window.h"
#include "app/wizard/wizard_session.h"
#include "haptic/servo/servo_switches.h"

namespace handrail {

class WindowInput {
public:
    // All outlive this object; the ears have what goes with a window.
    WindowInput(std::unique_ptr<Window> window, Session& app, WorldVisits& worlds, Ears& ears, ServoSwitches& switches,
                Clock& clock);

    // Once a frame. To the wizard, where there is one.
    void take(WizardSession* wizard);
    // The person left before there was a world, or closed the window.
    bool closed() const { return closed_ || acts_.closed(); }
    void draw(const ViewState& view) { window_->draw(view); }

private:
    Session& app_;
    Ears& ears_;
    Clock& clock_;
    KeyActs acts_;
    std::unique_ptr<Window> window_;
    bool closed_ = false;
};

}  // namespace handrail
