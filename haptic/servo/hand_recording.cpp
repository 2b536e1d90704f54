#include "haptic/servo/hand_recording.h"

#include <limits>

namespace handrail::servo {
namespace {

constexpr double kSteps = 1e6;  // number of steps per metre and per radian
constexpr double kFarthest = 1e3;

void round_all(Vec3& v) noexcept {
    bool whole = true;
    for (int axis = 0; axis < 3; ++axis) {
        v[axis] = std::round(v[axis] * kSteps) / kSteps;
        whole = whole && std::abs(v[axis]) <= kFarthest;  // becomes false if a value is too large or not finite
    }
    if (!whole) v = Vec3(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

void round_to_whole_steps(device::DeviceSample& sample) noexcept {
    round_all(sample.position_m);
    round_all(sample.gimbal_rad);
}

}  // namespace handrail::servo
