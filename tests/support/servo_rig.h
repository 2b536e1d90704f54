// Simulates a hand, a wall and a servo in virtual time, for tests of the servo without a device.
#pragma once

#include <memory>
#include <vector>

#include "haptic/render/haptic_scene.h"
#include "haptic/servo/servo_tick.h"
#include "tests/support/names.h"

namespace handrail::test {

inline constexpr double kTick = 1e-3;

// Returns a scene in which everything north of `wall_y_m` is solid: one box with the feature `name`, 20 m wide and 10 m
// deep.
inline std::shared_ptr<const HapticScene> wall_scene(double wall_y_m, FeatureId name = FeatureId{7}) {
    HapticSceneBuilder builder;
    builder.add_box({Vec3(-10.0, wall_y_m, -10.0), Vec3(10.0, wall_y_m + 10.0, 10.0)},
                    SurfaceLabel{name, kDefaultMaterial, false});
    return builder.build();
}

struct ServoRig {
    static constexpr double kWallY = 0.03;  // position of the wall; the proxy, of 5 mm, touches it at y = 0.025
    static constexpr FeatureId kWall{7};

    ServoState state;
    std::shared_ptr<const HapticScene> scene = wall_scene(kWallY, kWall);
    ServoTuning tuning;
    WorkspacePose pose;
    DeviceSample sample;
    double now_s = 50.0;
    ForceCommand last;
    std::vector<ContactEvent> events;

    // Returns a Touch that renders 1000 N/m, so that the default wall has 800 N/m, without damping and friction.
    static DeviceSpec stiff_touch() {
        DeviceSpec spec = *find_device_spec("sim-t");
        spec.rated_stiffness_n_per_m = 1000.0;
        spec.delay_s = 0.0;
        return spec;
    }
    explicit ServoRig(const DeviceSpec& spec = stiff_touch()) : state(spec) { pose.time_s = now_s; }

    ForceCommand tick_raw(const Vec3& device_m, double dt_s) {
        now_s += dt_s;
        pose.time_s = now_s;
        sample.position_m = device_m;
        last = servo_tick(state, {scene.get(), tuning, pose, sample, now_s});
        events.insert(events.end(), state.events().begin(), state.events().end());
        return last;
    }
    ForceCommand tick(const Vec3& device_m, double dt_s = kTick) {
        sample.fresh = sample.connected = true;
        return tick_raw(device_m, dt_s);
    }
    ForceCommand silent_tick() {
        sample.fresh = false;
        return tick_raw(sample.position_m, kTick);
    }
    ForceCommand unplugged_tick() {
        sample.fresh = sample.connected = false;
        return tick_raw(sample.position_m, kTick);
    }
    // Moves the hand straight to a position at half a metre per second.
    void go(const Vec3& device_m) {
        const Vec3 from = state.tool().hand_m;
        const int steps = static_cast<int>(glm::length(device_m - from) / 0.5e-3) + 1;
        for (int i = 1; i <= steps; ++i) tick(from + (device_m - from) * (static_cast<double>(i) / steps));
    }
    // Makes the first movement, after which the servo permits force.
    void arm() {
        tick(Vec3(0.0));
        go(Vec3(0.0, 0.0, 0.004));
        go(Vec3(0.0));
    }
    // Moves the hand to this position, after arm() and the ramp.
    void press(const Vec3& device_m) {
        arm();
        go(device_m);
        for (int i = 0; i < 1100; ++i) tick(device_m);
    }
    const ToolState& tool() const { return state.tool(); }
    int count(ContactEventKind kind) const {
        int n = 0;
        for (const ContactEvent& event : events) n += event.kind == kind;
        return n;
    }
    ContactEvent first(ContactEventKind kind) const {
        for (const ContactEvent& event : events)
            if (event.kind == kind) return event;
        return {};
    }
};

}  // namespace handrail::test
