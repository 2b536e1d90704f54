// Lines typed to the program. The session carries them out, but an open set-up takes them as answers, and they wait
// while a world is read. App thread.
#pragma once

#include <string>
#include <vector>

#include "app/core/session/carried_lines.h"
#include "app/main/world_visits.h"
#include "app/wizard/wizard_session.h"

namespace handrail::program {

class ProgramLines {
public:
    // Both outlive this object. `by_person`: a person types the lines, so they are not held back while a world is read,
    // as those of a script are.
    ProgramLines(core::Session& app, WorldVisits& worlds, bool by_person)
        : app_(app), worlds_(worlds), by_person_(by_person), lines_(app) {}

    core::CarriedLines& lines() { return lines_; }
    // Call once a frame. While a world is read, a person's lines are carried out at once, in the world the person is
    // still in; a script's lines wait. Returns false if there was nothing to do and nothing is awaited.
    bool take(double now_s, wizard::WizardSession* wizard);
    // True if a line has ended the program.
    bool left() const { return left_ || lines_.left(); }

private:
    bool answer(wizard::WizardSession& wizard, double now_s);

    core::Session& app_;
    WorldVisits& worlds_;
    const bool by_person_;
    core::CarriedLines lines_;
    bool left_ = false;  // before the first world was there
};

}  // namespace handrail::program
