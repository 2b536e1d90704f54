#include "app/main/program_lines.h"

#include <utility>

namespace handrail::program {

bool ProgramLines::take(double now_s, wizard::WizardSession* wizard) {
    if (wizard) return answer(*wizard, now_s);
    const bool first = !app_.scene();  // true before the first world is read, when the person is in no world
    if (first || worlds_.reading()) {
        if (!by_person_) return true;
        if (lines_.next_leaves() && (first || worlds_.give_up_reading(now_s))) {
            left_ = first;
            lines_.take_next();
            return true;
        }
    }
    return lines_.take(now_s);
}

bool ProgramLines::answer(wizard::WizardSession& wizard, double now_s) {
    if (!wizard.wants_line(now_s)) return true;
    auto line = lines_.take_next();
    if (!line) return false;
    wizard.type(std::move(*line));
    return true;
}

}  // namespace handrail::program
