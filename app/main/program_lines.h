// Carries out lines that a person or a script types to the program. During a set-up, the lines are answers to the
// wizard. Otherwise the session carries them out, and lines of a script wait while a world is read. App thread.
#pragma once

#include <string>
#include <vector>

#include "app/core/session/carried_lines.h"
#include "app/main/world_visits.h"
#include "app/wizard/wizard_session.h"

namespace handrail::program {

class ProgramLines {
public:
    // `app` and `worlds` must outlive this object. `by_person`: a person types the lines, not a script. Lines of a
    // person do not wait while a world is read.
    ProgramLines(core::Session& app, WorldVisits& worlds, bool by_person)
        : app_(app), worlds_(worlds), by_person_(by_person), lines_(app) {}

    core::CarriedLines& lines() { return lines_; }
    // Call once a frame. While another world is read, a person's lines are carried out at once, in the world that the
    // person has not left yet. Lines of a script wait. Returns false if there was no line and the program awaits
    // nothing else.
    bool take(double now_s, wizard::WizardSession* wizard);
    // Returns true if a line has ended the program.
    bool left() const { return left_ || lines_.left(); }

private:
    bool answer(wizard::WizardSession& wizard, double now_s);

    core::Session& app_;
    WorldVisits& worlds_;
    const bool by_person_;
    core::CarriedLines lines_;
    bool left_ = false;  // true if the person left before the first world was entered
};

}  // namespace handrail::program
