// Implements the part `step` of the set-up: the length of the person's step, typed in figures or set with the arrows.
#include "app/wizard/wizard.h"

#include <fmt/format.h>

#include <algorithm>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::wizard {
namespace {

constexpr double kStepStep_m = 0.05, kShortestStep_m = 0.2, kLongestStep_m = 1.5;

}  // namespace

std::string Wizard::step_length_question() const {
    return phrase("wizard.step_length", {{"length", found_.step_length_m * 100.0}});
}

bool Wizard::adjust_step_length(WizardKey key) {
    if (is_across(key)) return false;
    found_.step_length_m = std::clamp(found_.step_length_m + (is_upward(key) ? kStepStep_m : -kStepStep_m),
                                      kShortestStep_m, kLongestStep_m);
    question_.typed.clear();
    question_.text = step_length_question();
    say(phrase("wizard.centimetres", {{"length", found_.step_length_m * 100.0}}));
    return true;
}

// Stores the typed number. The size of the number shows which unit the person means: metres for one step, metres for
// ten steps, or centimetres for one step.
void Wizard::keep_step_length() {
    double typed = 0.0;
    if (!question_.typed.empty()) {
        double length_m = 0.0;
        if (parse_finite(question_.typed, typed))
            length_m = typed <= kLongestStep_m ? typed : typed <= 10.0 * kLongestStep_m ? typed / 10.0 : typed / 100.0;
        if (!(length_m >= kShortestStep_m - 1e-9 && length_m <= kLongestStep_m + 1e-9)) {
            say(phrase("wizard.no_step", {{"typed", question_.typed}}));
            question_.typed.clear();
            return pose_question();
        }
        found_.step_length_m = length_m;
    }
    change("walk.step_length_m", fmt::format("{:.2f}", found_.step_length_m));
    say(phrase("wizard.step", {{"length", found_.step_length_m * 100.0}}));
    go_on();
}

}  // namespace handrail::wizard
