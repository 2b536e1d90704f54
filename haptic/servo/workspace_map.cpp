#include "haptic/servo/workspace_map.h"

#include <algorithm>
#include <cmath>

#include "haptic/render/tick_assert.h"

namespace handrail::servo {
namespace {

// Greatest delay of a pose, beyond the usual one, for which the playback need not wait.
constexpr double kMarginS = 0.004;
// Longest time between two poses of one movement. If the time is longer, the walker stood still or the app hung.
constexpr double kLongestFrameS = 0.1;
constexpr double kCatchUpS = 0.1;  // time constant with which the playback adjusts its lag
constexpr double kMostCatchUp = 0.1;
constexpr double kTurn = 2.0 * kPi;

}  // namespace

void sin_cos_of_heading(double heading_rad, double& sine, double& cosine) noexcept {
    // Quarter turns are subtracted in two parts, so that the remainder keeps its precision (Cody & Waite, Software
    // Manual for the Elementary Functions).
    constexpr double kHalfPiHigh = 1.57079632673412561417e+00;  // the first 33 bits of pi / 2
    constexpr double kHalfPiLow = 6.07710050650619224932e-11;
    const double quarters = std::floor(heading_rad * (2.0 / kPi) + 0.5);
    const double x = (heading_rad - quarters * kHalfPiHigh) - quarters * kHalfPiLow;
    const double x2 = x * x;
    // Taylor series for |x| <= pi/4. The first omitted term is below 1e-18.
    double s = 0.0, c = 0.0;
    for (int n = 17; n >= 3; n -= 2) s = (s + (n % 4 == 1 ? 1.0 : -1.0)) * x2 / (n * (n - 1));
    s = x * (1.0 + s);
    for (int n = 18; n >= 2; n -= 2) c = (c + (n % 4 == 0 ? 1.0 : -1.0)) * x2 / (n * (n - 1));
    c = 1.0 + c;
    switch (static_cast<int>(quarters - 4.0 * std::floor(quarters / 4.0))) {
        case 0:
            sine = s, cosine = c;
            break;
        case 1:
            sine = c, cosine = -s;
            break;
        case 2:
            sine = -s, cosine = -c;
            break;
        default:
            sine = -c, cosine = s;
            break;
    }
}

WorkspaceFrame frame_of(const Vec3& origin_m, double heading_rad) noexcept {
    double sine = 0.0, cosine = 1.0;
    sin_cos_of_heading(heading_rad, sine, cosine);
    return {origin_m, Vec3(cosine, -sine, 0.0), Vec3(sine, cosine, 0.0)};
}

WorkspaceFrame PosePlayback::frame(const Vec3& origin_m, double heading_rad) noexcept {
    if (heading_rad != turned_for_rad_) {
        turned_for_rad_ = heading_rad;
        turned_ = frame_of(Vec3(0.0), heading_rad);
    }
    return {origin_m, turned_.right, turned_.forward};
}

void PosePlayback::push(const WorkspacePose& pose) noexcept {
    if (count_ == kPoses) {
        first_ = (first_ + 1) % kPoses;
        --count_;
    }
    poses_[(first_ + count_) % kPoses] = pose;
    ++count_;
}

bool PosePlayback::give(const WorkspacePose& newest, double now_s) noexcept {
    if (!is_finite(newest.origin_m) || !std::isfinite(newest.heading_rad) || !std::isfinite(newest.time_s))
        return false;
    if (count_ == 0 || newest.jump != pose(count_ - 1).jump) {
        count_ = 0;
        push(newest);
        play_s_ = newest.time_s;
        return true;
    }
    const double interval_s = newest.time_s - pose(count_ - 1).time_s;
    if (!(interval_s > 0.0)) return false;
    if (interval_s > kLongestFrameS) {
        // The playback has been waiting at the last pose for a long time. The movement starts at that pose, about one
        // frame before the new pose.
        WorkspacePose still = pose(count_ - 1);
        still.time_s = newest.time_s - wait_s_;
        count_ = 0;
        push(still);
        play_s_ = still.time_s;
    } else {
        const double wait_s = std::clamp(now_s - pose(count_ - 1).time_s, interval_s, kLongestFrameS);
        wait_s_ = wait_s > wait_s_ ? wait_s : wait_s_ + 0.005 * (wait_s - wait_s_);
    }
    push(newest);
    return false;
}

WorkspaceFrame PosePlayback::at(double now_s, double dt_s) noexcept {
    if (count_ == 0) return {};
    const double late_s = (now_s - play_s_) - (wait_s_ + kMarginS);
    const double speed = 1.0 + std::clamp(late_s / kCatchUpS, -kMostCatchUp, kMostCatchUp);
    play_s_ = std::clamp(play_s_ + dt_s * speed, pose(0).time_s, pose(count_ - 1).time_s);
    while (count_ > 2 && pose(1).time_s <= play_s_) {
        first_ = (first_ + 1) % kPoses;
        --count_;
    }
    if (count_ == 1) return frame(pose(0).origin_m, pose(0).heading_rad);
    const WorkspacePose& a = pose(0);
    const WorkspacePose& b = pose(1);
    const double part = (play_s_ - a.time_s) / (b.time_s - a.time_s);
    tick_assert(part >= 0.0 && part <= 1.0);
    double turn = b.heading_rad - a.heading_rad;  // the next line makes it the shorter rotation
    turn -= kTurn * std::floor((turn + kPi) / kTurn);
    return frame(a.origin_m + (b.origin_m - a.origin_m) * part, a.heading_rad + turn * part);
}

}  // namespace handrail::servo
