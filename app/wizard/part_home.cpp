// Implements the part `home` of the set-up: the person pulls and pushes the grip until the device knows its position. A
// click reports each completed movement.
#include "app/wizard/wizard.h"

#include <bit>

#include "worlds/base/language.h"

namespace handrail::wizard {

std::string Wizard::pull_question() const { return phrase("wizard.pull"); }
std::string Wizard::push_question() const { return phrase("wizard.push"); }

void Wizard::accept_homing() {
    if (homed()) return go_on();
    say(phrase("wizard.not_homed", {{"legs", std::popcount(static_cast<unsigned>(sense_.tool.homed_legs))}}));
}

// Watches how the device finds its position. Returns true, so that the button is ignored: a person who grasps the grip
// may press the button by accident.
bool Wizard::watch_homing(double) {
    const auto legs = [](std::uint8_t bits) { return std::popcount(static_cast<unsigned>(bits)); };
    const int fresh = legs(sense_.tool.homed_legs) - legs(homing_.legs_seen);
    for (int i = 0; i < fresh; ++i) click();
    homing_.legs_seen = sense_.tool.homed_legs;
    homing_.newly_homed = homing_.newly_homed || (homed() && !homing_.was_homed);
    homing_.was_homed = homed();
    const double away_m = sense_.tool.hand_m.y;
    const bool pulled =
        legs(sense_.tool.homed_legs) > legs(homing_.legs_at_start) || (homed() && away_m < -kMovedShare * radius_m());
    const bool pushed = homed() && (homing_.newly_homed || away_m > kMovedShare * radius_m());
    if (!(question_.step == Step::Pull ? pulled : pushed)) return true;
    reply_s_ = now_s_;
    if (fresh <= 0) click();
    say(phrase("wizard.good"));
    go_on();
    return true;
}

}  // namespace handrail::wizard
