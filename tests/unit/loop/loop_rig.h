// Provides walls for the closed loop. They are half-spaces in a random orientation, which the tests touch through
// touch_tick as the program does.
#pragma once

#include <random>

#include "haptic/device/device_spec.h"
#include "haptic/loop/closed_loop.h"
#include "haptic/render/touch.h"
#include "tests/support/names.h"
#include "tests/support/touch_worlds.h"

namespace handrail::test {

// A box with one face on the plane through the origin. The x axis of the wall's frame points out of that face.
struct TiltedWall {
    Motion motion;
    std::shared_ptr<const HapticScene> scene;
    Vec3 out, along, across;

    explicit TiltedWall(std::uint32_t seed) {
        std::mt19937 random(seed);
        if (seed != 0) motion = random_turn(random);
        TouchWorld world;
        world.box({-1.0, -2.0, -2.0}, {0.0, 2.0, 2.0});
        scene = world.scene(motion);
        out = motion.turn * Vec3(1, 0, 0);
        along = motion.turn * Vec3(0, 1, 0);
        across = motion.turn * Vec3(0, 0, 1);
    }
    // Converts between world directions and the wall's frame, whose x axis points outwards.
    Vec3 to_world(const Vec3& own) const { return motion(own); }
    Vec3 to_own(const Vec3& world) const { return motion.back(world); }
};

inline TouchTuning loop_tuning(double stiffness_n_per_m, double damping_ns_per_m = 5.0) {
    TouchTuning tuning;
    tuning.radius_m = 0.002;
    tuning.override_stiffness_n_per_m = stiffness_n_per_m;
    tuning.damping_ns_per_m = damping_ns_per_m;
    return tuning;
}

// Returns the program's renderer as a function that the loop calls. The function keeps its own state.
inline ClosedLoop::Render touch_renderer(std::shared_ptr<const HapticScene> scene, const TouchTuning& tuning) {
    auto state = std::make_shared<TouchState>();
    return [=](const Vec3& measured_m, double, double since_s) {
        return touch_tick(*state, *scene, tuning, measured_m, since_s).force_n;
    };
}

// Returns half the highest stiffness that is stable for a light grip if the device and the renderer damp.
inline double safe_stiffness_n_per_m(double delay_s, double damping_ns_per_m) {
    DeviceSpec spec;
    spec.rated_stiffness_n_per_m = 1e9;
    spec.delay_s = delay_s;
    return 0.8 * effective_stiffness_n_per_m(spec, 1e-3, damping_ns_per_m);
}

}  // namespace handrail::test
