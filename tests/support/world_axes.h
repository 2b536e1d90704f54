// Tests the whole chain from a driver to the world, at heading 0. Computes which position in the world belongs to the
// position that the driver reports, and which force the driver gets when the world pushes the hand.
#pragma once

#include "tests/support/names.h"
#include "tests/support/servo_rig.h"

namespace handrail::test {

struct ThroughWorld {
    Vec3 world_m{0.0};  // position of the hand in the world, relative to the middle of the workspace
    // The command to the driver while a solid pushes the hand along the positive axis of the world, pressed 2 mm deep.
    ForceCommand command;
};

inline ThroughWorld through_world(const DeviceSpec& spec, const Vec3& seen_m, int axis) {
    constexpr double kScale = 60.0, kProxy = 0.1, kPress = 0.002;
    ThroughWorld out;
    ServoRig rig(spec);
    rig.tuning.touch.world_m_per_hand_m = kScale;
    rig.tuning.touch.radius_m = kProxy;
    rig.pose.origin_m = Vec3(7.0, -3.0, 1.0);
    // A solid fills the world up to the position at which 2 mm of hand movement presses the proxy into it. The hand
    // comes from the free side.
    Aabb solid{Vec3(-500.0), Vec3(500.0)};
    solid.max_m[axis] = rig.pose.origin_m[axis] + kScale * (seen_m[axis] + kPress) - kProxy;
    HapticSceneBuilder builder;
    builder.add_box(solid);
    rig.scene = builder.build();
    Vec3 off{0.0};
    off[axis] = 0.008;
    rig.tick(seen_m + off);
    rig.go(seen_m + 1.5 * off);
    for (int i = 0; i < 1200; ++i) rig.tick(seen_m + off);
    rig.go(seen_m);
    out.command = rig.tick(seen_m);
    out.world_m = rig.tool().hip_m - rig.pose.origin_m;
    return out;
}

// Checks that a hand movement of `step_m` along an axis (right, forward, up) goes 60 times as far east, north or up in
// the world, and that the push has the same direction.
inline void expect_east_north_up(const ThroughWorld& through, int axis, double step_m, double within_m) {
    Vec3 expected{0.0};
    expected[axis] = 60.0 * step_m;
    EXPECT_LT(glm::length(through.world_m - expected), 60.0 * within_m) << "axis " << axis;
    const Vec3& force = through.command.force_n;
    EXPECT_GT(force[axis], 0.1) << "axis " << axis;
    EXPECT_NEAR(force[axis], glm::length(force), 1e-9) << "axis " << axis;
}

}  // namespace handrail::test
