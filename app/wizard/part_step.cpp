// The part `step`: how long the person's step is, by figures or the arrows.
#include "app/wizard/wizard.h"

#include <fmt/format.h>

#include <algorithm>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

constexpr double kStepStep_m = 0.05, kShortestStep_m = 0.2, kLongestStep_m = 1.5;

}  // namespace

std::string Wizard::ask_step_length() const {
    return phrase("wizard.step_length", {{"length", step_length_m_ * 100.0}});
}

bool Wizard::adjust_step_length(WizardKey key) {
    if (is_across(key)) return false;
    step_length_m_ =
        std::clamp(step_length_m_ + (is_upward(key) ? kStepStep_m : -kStepStep_m), kShortestStep_m, kLongestStep_m);
    typed_.clear();
    question_ = ask_step_length();
    say(phrase("wizard.centimetres", {{"length", step_length_m_ * 100.0}}));
    return true;
}

// One number, of which the size says what it is: metres of a step, metres of ten steps, or centimetres of a step.
void Wizard::keep_step_length() {
    double typed = 0.0;
    if (!typed_.empty()) {
        double length_m = 0.0;
        if (parse_finite(typed_, typed))
            length_m = typed <= kLongestStep_m ? typed : typed <= 10.0 * kLongestStep_m ? typed / 10.0 : typed / 100.0;
        if (!(length_m >= kShortestStep_m - 1e-9 && length_m <= kLongestStep_m + 1e-9)) {
            say(phrase("wizard.no_step", {{"typed", typed_}}));
            typed_.clear();
            return ask();
        }
        step_length_m_ = length_m;
    }
    change("walk.step_length_m", fmt::format("{:.2f}", step_length_m_));
    say(phrase("wizard.step", {{"length", step_length_m_ * 100.0}}));
    go_on();
}

}  // namespace handrail
