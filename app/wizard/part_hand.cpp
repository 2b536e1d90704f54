// Implements the part `hand` of the set-up: which hand holds the grip. The person presses a key or moves the grip to
// the side of that hand.
#include "app/wizard/wizard.h"

#include <cmath>

#include "worlds/base/language.h"

namespace handrail::wizard {

std::string Wizard::hand_question() const { return phrase("wizard.which_hand"); }
void Wizard::accept_hand() { keep_hand(own_profile().hand.value_or(settings::HoldingHand::Right)); }

bool Wizard::adjust_hand(WizardKey key) {
    if (!is_across(key)) return false;
    keep_hand(key == WizardKey::Left ? settings::HoldingHand::Left : settings::HoldingHand::Right);
    return true;
}

bool Wizard::watch_aside(double) {
    const double aside_m = sense_.tool.hand_m.x - question_.hand_m.x;
    if (!homed() || std::abs(aside_m) <= kMovedShare * radius_m()) return false;
    reply_s_ = now_s_;
    keep_hand(aside_m < 0.0 ? settings::HoldingHand::Left : settings::HoldingHand::Right);
    return true;
}

void Wizard::keep_hand(settings::HoldingHand hand) {
    change_profile("hand", hand == settings::HoldingHand::Left ? "left" : "right");
    say(hand == settings::HoldingHand::Left ? phrase("wizard.left_hand") : phrase("wizard.right_hand"));
    go_on();
}

}  // namespace handrail::wizard
