// What a key does, wherever it comes from. It answers the set-up by voice if that is under way, else it goes to the
// open list or question, else it is a command. App thread.
#pragma once

#include <string>

#include "app/core/session/session.h"
#include "app/main/world_visits.h"
#include "app/window/keys.h"
#include "app/wizard/wizard_session.h"

namespace handrail::program {

class KeyActs {
public:
    // Both outlive this object.
    KeyActs(core::Session& app, WorldVisits& worlds) : app_(app), worlds_(worlds) {}

    void take(const window::KeyEvent& key, wizard::WizardSession* wizard, double now_s);
    // The characters of the last key given to take().
    void take_text(const std::string& utf8, wizard::WizardSession* wizard, double now_s);
    // True if the person left before there was a world.
    bool closed() const { return closed_; }

private:
    core::Session& app_;
    WorldVisits& worlds_;
    bool typing_ = false;  // a list or question was open when the last key went down
    bool closed_ = false;
};

}  // namespace handrail::program
