#include "app/core/walking/gait.h"

#include <algorithm>
#include <cmath>

#include "worlds/navigation/blind_ground.h"

namespace handrail::core {
namespace {

// If the walker makes less than this share of the intended distance in a tick, something has stopped it, and the
// decision is made at once.
constexpr double kHeadOn = 0.1;
constexpr double kStraightIn_m = 0.01;
constexpr int kMostLineUps = 2;

}  // namespace

void Gait::went_aside(double intended_m, double made_m) {
    const double left_m = std::max(0.0, std::abs(aside_m_) - intended_m);
    aside_m_ = made_m < kHeadOn * intended_m ? 0.0 : std::copysign(left_m, aside_m_);
    if (left_m == 0.0) aside_m_ = 0.0;
}

Gait::Course Gait::went(double intended_m, double made_m, bool met,
                        const std::function<std::optional<double>()>& line_up_m) {
    intended_m_ += intended_m;
    made_m_ += made_m;
    const bool held = met && made_m < kHeadOn * intended_m;
    if (!held && intended_m_ < navigation::kStoppedWindow_m) return met ? Course::Along : Course::On;
    const bool slow = made_m_ < navigation::kStoppedBelow * intended_m_;
    intended_m_ = made_m_ = 0.0;
    if (!held && !slow) return met ? Course::Along : Course::On;
    const std::optional<double> aside_m = lined_up_ < kMostLineUps && line_up_m ? line_up_m() : std::nullopt;
    if (!aside_m || std::abs(*aside_m) < kStraightIn_m) return Course::Stopped;
    ++lined_up_;
    aside_m_ = *aside_m;
    return Course::Aside;
}

}  // namespace handrail::core
