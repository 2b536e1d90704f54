// What a key does, wherever it comes from: it answers the set-up by voice where there is one, goes to the list or
// question that is open, and else is the command that it stands for. App thread.
#pragma once

#include <string>

#include "app/core/session/session.h"
#include "app/main/world_visits.h"
#include "app/window/keys.h"
#include "app/wizard/wizard_session.h"

namespace handrail {

class KeyActs {
public:
    // Both outlive this object.
    KeyActs(Session& app, WorldVisits& worlds) : app_(app), worlds_(worlds) {}

    void take(const KeyEvent& key, WizardSession* wizard, double now_s);
    // The characters of the key that was taken last.
    void take_text(const std::string& utf8, WizardSession* wizard, double now_s);
    // The person left before there was a world.
    bool closed() const { return closed_; }

private:
    Session& app_;
    WorldVisits& worlds_;
    bool typing_ = false;  // a list or question was open when the last key went down
    bool closed_ = false;
};

}  // namespace handrail
