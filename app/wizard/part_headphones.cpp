// Implements the part `headphones` of the set-up: plays a bell on each side, and swaps the sides if the person hears
// them reversed.
#include "app/wizard/wizard.h"

#include "worlds/base/language.h"

namespace handrail::wizard {
namespace {

constexpr double kBellEvery_s = 2.5;
constexpr double kBellAside_m = 1.5;

}  // namespace

void Wizard::begin_bell() { bell_due_s_ = now_s_; }
std::string Wizard::bell_left_question() const { return phrase("wizard.bell_left"); }
std::string Wizard::bell_right_question() const { return phrase("wizard.bell_right"); }

bool Wizard::adjust_bell_left(WizardKey key) {
    if (key == WizardKey::Left) {
        go_on();
    } else if (key == WizardKey::Right) {
        settings_.sound.swap_sides = !settings_.sound.swap_sides;
        change("sound.swap_sides", settings_.sound.swap_sides ? "true" : "false");
        say(phrase("wizard.swapped"));
        enter(index_);
    } else {
        return false;
    }
    return true;
}

bool Wizard::adjust_bell_right(WizardKey key) {
    if (!is_across(key)) return false;
    if (key == WizardKey::Left) say(phrase("wizard.one_side"));
    go_on();
    return true;
}

void Wizard::hear_bell() {
    if (paused_ || now_s_ < bell_due_s_) return;
    bell_due_s_ = now_s_ + kBellEvery_s;
    const Vec3 right = right_of_heading(sense_.listener.heading_rad);
    play(cues::SoundKind::Bell,
         sense_.listener.ears_m + right * (question_.step == Step::BellLeft ? -kBellAside_m : kBellAside_m));
}

}  // namespace handrail::wizard
