// Typed lines at the program: carried out by the session, but answers to the set-up while that is open, and held back
// while a world is read. App thread.
#pragma once

#include <string>
#include <vector>

#include "app/core/session/carried_lines.h"
#include "app/main/world_visits.h"
#include "app/wizard/wizard_session.h"

namespace handrail {

class ProgramLines {
public:
    // Both outlive this object. by_person: typed by somebody, who does not wait for a world in vain as a script does.
    ProgramLines(Session& app, WorldVisits& worlds, bool by_person)
        : app_(app), worlds_(worlds), by_person_(by_person), lines_(app) {}

    CarriedLines& lines() { return lines_; }
    // Once a frame. While a world is read, a person's lines are carried out at once, in the world the person is still
    // in, and a script's lines wait. False if there was nothing to do and nothing is waited for.
    bool take(double now_s, WizardSession* wizard);
    // A line asked to end the program.
    bool left() const { return left_ || lines_.left(); }

private:
    bool answer(WizardSession& wizard, double now_s);

    Session& app_;
    WorldVisits& worlds_;
    const bool by_person_;
    CarriedLines lines_;
    bool left_ = false;  // before the first world was there
};

}  // namespace handrail
