// Implements the part `reach` of the set-up: how far the hand can move, what length in the world this distance
// represents, and whether a rim marks the end of the workspace.
#include "app/wizard/wizard.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::wizard {
namespace {

// The hand has reached a side if it is farther out than this fraction of the device's radius.
constexpr double kSideShare = 0.3;
// A movement is no sweep if it is smaller than this fraction of the device's width.
constexpr double kLeastReachShare = 0.3;
// How far ahead of the body the middle of the workspace is, as a fraction of the workspace's depth: 5 parts of the
// depth are ahead of the body, 3 behind.
constexpr double kAheadShare = 0.125;
constexpr std::array kScales{7.5, 15.0, 30.0, 60.0, 120.0, 240.0};

// Rounds numbers below 10 to tenths, and others to whole numbers: 7.5, 9, 12.
double rounded(double value) { return value < 10.0 ? std::round(value * 10.0) / 10.0 : std::round(value); }

}  // namespace

// ---- the sweep ----

void Wizard::begin_sweep() { reach_.sides_seen = 0; }
std::string Wizard::sweep_question() const { return phrase("wizard.sweep"); }

bool Wizard::watch_sweep(double) {
    const Vec3& hand_m = sense_.tool.hand_m;
    if (!homed() || !is_finite(hand_m)) return false;
    reach_.least_m = glm::min(reach_.least_m, hand_m);
    reach_.most_m = glm::max(reach_.most_m, hand_m);
    for (int axis = 0; axis < 3; ++axis)
        for (const int high : {0, 1}) {
            const bool there = high ? hand_m[axis] > kSideShare * radius_m() : hand_m[axis] < -kSideShare * radius_m();
            const auto bit = static_cast<std::uint8_t>(1U << (2 * axis + high));
            if (!there || (reach_.sides_seen & bit)) continue;
            reach_.sides_seen |= bit;
            click();
        }
    return false;
}

void Wizard::keep_reach() {
    const Vec3 size_m = reach_.most_m - reach_.least_m, middle_m = 0.5 * (reach_.most_m + reach_.least_m);
    if (!(size_m.x >= kLeastReachShare * 2.0 * radius_m() && size_m.y >= kLeastReachShare * 2.0 * radius_m())) {
        say(phrase("wizard.reach_kept"));
        return go_on();
    }
    reach_.measured_m = size_m;
    const auto kept = [](double metres) { return fmt::format("{:.3f}", metres); };
    change_profile("width_m", kept(size_m.x));
    change_profile("depth_m", kept(size_m.y));
    change_profile("height_m", kept(std::max(size_m.z, 0.01)));
    // Put the middle of the hand's workspace a little ahead of the body, and at the height that the workspace settings
    // state.
    change_profile("offset_ahead_m", kept(std::clamp(kAheadShare * size_m.y - middle_m.y, -0.1, 0.1)));
    change_profile("offset_up_m", kept(std::clamp(-middle_m.z, -0.1, 0.1)));
    say(phrase("wizard.reach",
               {{"width", size_m.x * 100.0}, {"depth", size_m.y * 100.0}, {"height", size_m.z * 100.0}}));
    go_on();
}

// ---- the scale ----

void Wizard::begin_scale() { reach_.scale = own_profile().scale.value_or(settings_.workspace.scale); }
std::string Wizard::scale_question() const { return phrase("wizard.scale", {{"span", span_words()}}); }

std::string Wizard::span_words() const {
    const settings::DeviceProfile own = own_profile();
    const double width_m = reach_.measured_m.x > 0.0 ? reach_.measured_m.x : own.width_m.value_or(2.0 * radius_m());
    const double depth_m = reach_.measured_m.y > 0.0 ? reach_.measured_m.y : own.depth_m.value_or(2.0 * radius_m());
    return phrase("wizard.span",
                  {{"width", rounded(width_m * reach_.scale)}, {"depth", rounded(depth_m * reach_.scale)}});
}

bool Wizard::adjust_scale(WizardKey key) {
    if (is_across(key)) return false;
    const double before = reach_.scale;
    if (is_upward(key)) {
        const auto next = std::upper_bound(kScales.begin(), kScales.end(), reach_.scale + 1e-9);
        if (next != kScales.end()) reach_.scale = *next;
    } else {
        const auto next = std::lower_bound(kScales.begin(), kScales.end(), reach_.scale - 1e-9);
        if (next != kScales.begin()) reach_.scale = *(next - 1);
    }
    question_.text = scale_question();
    if (before == reach_.scale) play(cues::SoundKind::Denied, sense_.listener.ears_m);
    say(core::sentence_case(phrase("wizard.said", {{"words", span_words()}})));
    return true;
}

void Wizard::keep_scale() {
    change_profile("scale", fmt::format("{}", reach_.scale));
    settings_.workspace.scale = reach_.scale;
    go_on();
}

// ---- beyond the workspace ----

std::string Wizard::beyond_question() const {
    return settings_.workspace.rim ? phrase("wizard.beyond_on") : phrase("wizard.beyond_off");
}

bool Wizard::adjust_beyond(WizardKey key) {
    if (is_across(key)) return false;
    settings_.workspace.rim = !settings_.workspace.rim;
    question_.text = beyond_question();
    say(settings_.workspace.rim ? phrase("wizard.on") : phrase("wizard.off"));
    return true;
}

void Wizard::keep_beyond() {
    change("workspace.rim", settings_.workspace.rim ? "true" : "false");
    go_on();
}

}  // namespace handrail::wizard
