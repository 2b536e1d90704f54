// Implements the part `gentlest` of the set-up: a force that grows until the person notices it. There is enough time
// for the person to let go of the grip.
#include "app/wizard/wizard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "worlds/base/language.h"

namespace handrail::wizard {
namespace {

// The force begins this long after the question began, or later if the question is still being spoken.
constexpr double kPressAfter_s = 1.5;
constexpr double kLetGoAfter_s = 5.0;  // after this time at the greatest force of this part, the force is switched off
// If the person answers while the force is smaller than this, the person has not felt it, so the answer is not about
// the force.
constexpr double kNoticed_n = 0.05;

// Returns a scene with a force that fills the whole workspace and pushes the hand towards the person. The servo's force
// ceiling determines how strong the force is.
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

std::string Wizard::press_question() const {
    return sense_.tool.waiting_for_hand ? phrase("wizard.press_waiting") : phrase("wizard.press");
}

void Wizard::accept_press() { keep_gentlest(glm::length(sense_.tool.force_n)); }

bool Wizard::watch_press(double dt_s) {
    if (!sense_.tool.waiting_for_hand && felt_.tuning.forces_on && !sense_.speaking &&
        now_s_ - question_.begun_s > kPressAfter_s)
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
