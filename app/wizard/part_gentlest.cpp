// The part `gentlest`: a force that grows until the person notices it. There is enough room for the person to let go of
// it.
#include "app/wizard/wizard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "worlds/base/language.h"

namespace handrail::wizard {
namespace {

constexpr double kPressAfter_s = 1.5;  // earliest time after the question began; never before it has been spoken
constexpr double kLetGoAfter_s = 5.0;  // time at this part's greatest force until it is switched off
constexpr double kNoticed_n = 0.05;    // an answer below this force is not an answer to the force

// Fills the whole workspace and pushes the hand towards the person. The ceiling decides how strongly.
std::shared_ptr<const render::HapticScene> pressing_scene() {
    render::EffectVolume push;
    push.region = render::SphereRegion{Vec3(0.0), 1.0};
    push.law = render::ForceLaw{{0.0, -1.0, 0.0}, Wizard::kGentlestMost_n};
    render::HapticSceneBuilder builder;
    builder.add_effect(push);
    return builder.build();
}

}  // namespace

void Wizard::begin_press() { begin_force(pressing_scene()); }

std::string Wizard::ask_press() const {
    return sense_.tool.waiting_for_hand ? phrase("wizard.press_waiting") : phrase("wizard.press");
}

void Wizard::accept_press() { keep_gentlest(glm::length(sense_.tool.force_n)); }

bool Wizard::watch_press(double dt_s) {
    if (!sense_.tool.waiting_for_hand && felt_.tuning.forces_on && !sense_.speaking &&
        now_s_ - asked_.begun_s > kPressAfter_s)
        felt_.tuning.force_ceiling_n =
            std::min(kGentlestMost_n, felt_.tuning.force_ceiling_n + kGentlestRise_n_per_s * dt_s);
    if (felt_.tuning.force_ceiling_n < kGentlestMost_n || !felt_.tuning.forces_on) return false;
    held_top_s_ += dt_s;
    if (held_top_s_ <= kLetGoAfter_s) return false;
    felt_.tuning.forces_on = false;
    say(phrase("wizard.let_go", {{"force", newtons(kGentlestMost_n)}}));
    return false;
}

void Wizard::keep_gentlest(double felt_n) {
    if (held_top_s_ > kLetGoAfter_s) found_.gentlest_n = kGentlestMost_n;
    else if (felt_n >= kNoticed_n)
        found_.gentlest_n = std::clamp(std::round(felt_n * 100.0) / 100.0, kNoticed_n, kGentlestMost_n);
    else found_.gentlest_n = own_profile().gentlest_n.value_or(found_.gentlest_n);
    change_profile("gentlest_n", fmt::format("{}", found_.gentlest_n));
    say(phrase("wizard.felt", {{"force", newtons(found_.gentlest_n)}}));
    go_on();
}

}  // namespace handrail::wizard
