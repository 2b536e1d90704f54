// Decides what a key from the window or the terminal does. During a set-up by voice, the key is an answer. Otherwise an
// open list or question receives the key; if none is open, the key is a command. App thread.
#pragma once

#include <string>

#include "app/core/session/session.h"
#include "app/main/world_visits.h"
#include "app/window/keys.h"
#include "app/wizard/wizard_session.h"

namespace handrail::program {

class KeyActs {
public:
    // Both arguments must outlive this object.
    KeyActs(core::Session& app, WorldVisits& worlds) : app_(app), worlds_(worlds) {}

    void take(const window::KeyEvent& key, wizard::WizardSession* wizard, double now_s);
    // Applies the characters of the key that was last given to take().
    void take_text(const std::string& utf8, wizard::WizardSession* wizard, double now_s);
    // Returns true if the person left before the first world was entered.
    bool closed() const { return closed_; }

private:
    core::Session& app_;
    WorldVisits& worlds_;
    bool typing_ = false;  // true if a list or question was open when the last key went down
    bool closed_ = false;
};

}  // namespace handrail::program
