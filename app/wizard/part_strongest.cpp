// Implements the part `strongest` of the set-up: a wall to push against. With the arrows, the person changes the wall's
// force until it is as strong as the device should ever be.
#include "app/wizard/wizard.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::wizard {
namespace {

constexpr double kLeastCeiling_n = 0.5;
constexpr double kFineCeiling_n = 0.1;

std::shared_ptr<const render::HapticScene> wall_scene(double face_y_m) {
    render::HapticSceneBuilder builder;
    builder.add_box({{-1.0, face_y_m, -1.0}, {1.0, face_y_m + 1.0, 1.0}});
    return builder.build();
}

}  // namespace

double Wizard::strongest_n() const { return std::min(sense_.hand.spec.peak_force_n, 40.0); }
double Wizard::weakest_ceiling_n() const {
    return std::min(strongest_n(), std::max(kLeastCeiling_n, 2.0 * found_.gentlest_n));
}

// Returns the first force of the wall. If the person has never chosen a force, returns a light one, so that nobody is
// startled.
double Wizard::first_ceiling_n() const { return own_profile().ceiling_n.value_or(settings::kLightCeiling_n); }

void Wizard::begin_wall() {
    found_.ceiling_n = std::clamp(first_ceiling_n(), weakest_ceiling_n(), strongest_n());
    begin_force(wall_scene(std::clamp(question_.hand_m.y + 0.005, -kMovedShare * radius_m(), 0.3 * radius_m())));
}

std::string Wizard::wall_question() const { return phrase("wizard.wall", {{"force", ceiling_words()}}); }

std::string Wizard::ceiling_words() const {
    const auto is = [this](double level_n) { return std::abs(found_.ceiling_n - level_n) < 1e-6; };
    const std::string force = newtons(found_.ceiling_n);
    if (is(settings::kLightCeiling_n)) return phrase("wizard.light", {{"force", force}});
    if (is(settings::kNormalCeiling_n)) return phrase("wizard.normal", {{"force", force}});
    return is(strongest_n()) ? phrase("wizard.full", {{"force", force}}) : force;
}

bool Wizard::adjust_wall(WizardKey key) {
    const double sign = is_upward(key) ? 1.0 : -1.0;
    double wanted_n = found_.ceiling_n + sign * kFineCeiling_n;
    if (!is_across(key)) {  // the arrow moves to the next of the three force levels
        const std::array levels{settings::kLightCeiling_n, settings::kNormalCeiling_n, strongest_n()};
        wanted_n = sign > 0.0 ? strongest_n() : weakest_ceiling_n();
        for (const double level_n : levels)
            if ((level_n - found_.ceiling_n) * sign > 1e-6 &&
                std::abs(level_n - found_.ceiling_n) < std::abs(wanted_n - found_.ceiling_n))
                wanted_n = level_n;
    }
    const double before_n = std::exchange(found_.ceiling_n, std::clamp(wanted_n, weakest_ceiling_n(), strongest_n()));
    question_.text = wall_question();
    if (before_n == found_.ceiling_n) play(cues::SoundKind::Denied, sense_.listener.ears_m);
    say(core::sentence_case(phrase("wizard.said", {{"words", ceiling_words()}})));
    return true;
}

bool Wizard::watch_wall(double dt_s) {
    const double most_n = kCeilingRise_n_per_s * dt_s;
    felt_.tuning.force_ceiling_n += std::clamp(found_.ceiling_n - felt_.tuning.force_ceiling_n, -most_n, most_n);
    return false;
}

void Wizard::keep_ceiling() {
    change_profile("ceiling_n", fmt::format("{:.1f}", found_.ceiling_n));
    // Raises the force level that all devices share if that level would be too low for this device. Never lowers it
    // because of a single device.
    const bool above_normal = found_.ceiling_n > settings::kNormalCeiling_n,
               above_light = found_.ceiling_n > settings::kLightCeiling_n;
    if (above_normal && settings_.haptic.ceiling != settings::ForceCeiling::Full) change("haptic.ceiling", "full");
    else if (above_light && settings_.haptic.ceiling == settings::ForceCeiling::Light)
        change("haptic.ceiling", "normal");
    say(phrase("wizard.ceiling", {{"force", newtons(found_.ceiling_n)}}));
    go_on();
}

}  // namespace handrail::wizard
