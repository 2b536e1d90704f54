// What the engine of movable bodies and the hand's side tell each other: plain values, world metres and newtons. Copied
// between threads by LatestValue and SpscRing. All but DynamicsFrame have a fixed size; a frame has room for the bodies
// of its world, which only the engine allocates, with the first frames.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "haptic/render/dynamics_scene.h"
#include "haptic/render/haptic_scene.h"

namespace handrail {

// Where a body touches or is about to touch: its point stays on the plane's side, normal . point >= offset.
struct ContactPlane {
    Vec3 own_m{0.0};  // the point, in the body's frame
    Vec3 normal{0.0, 0.0, 1.0};
    double offset_m = 0.0;
    double friction = 0.0;    // while it slides
    Vec3 speed_m_per_s{0.0};  // of what is touched, there
    bool round = false;       // a ball: the point is always the one nearest to the plane
    double radius_m = 0.0;
};

// All that the servo's own model of a body needs to go on by itself.
struct BodyWord {
    static constexpr std::size_t kMostPlanes = 12;

    std::uint32_t body = kNoBody;  // place in DynamicsScene::bodies
    double time_s = 0.0;           // the moment it is true of
    Placement at;                  // of the body's frame: middle of mass, principal axes
    Vec3 speed_m_per_s{0.0}, turn_rad_per_s{0.0};
    double mass_kg = 1.0;
    Vec3 inertia_kg_m2{1.0};
    Vec3 gravity_m_per_s2{0.0};
    Vec3 others_n{0.0}, others_nm{0.0};  // keys and the other hand: mean over the last step
    Vec3 string_at_m{0.0};
    double string_n_per_m = 0.0;   // 0: no string
    double string_ns_per_m = 0.0;  // what damps it
    double sticks = 1.0;           // static friction in units of the sliding one
    double rolling_m = 0.0;
    double gap_m = 0.0;  // from this hand's middle to the body, at least
    std::array<ContactPlane, kMostPlanes> planes{};
    std::uint8_t count = 0;
};

// Everything after one step of the engine.
struct DynamicsFrame {
    static constexpr std::size_t kNear = 4;

    std::uint64_t number = 0;          // of the step; 0: none yet
    std::uint32_t game = 0;            // rises with every restart: nothing of the one before holds
    double time_s = 0.0;               // end of the step
    std::vector<Placement> things;     // of each body, as HapticScene::bodies have them
    std::vector<std::uint32_t> moved;  // those that are elsewhere than in the frame before (number - 1), rising
    std::array<std::array<BodyWord, kNear>, 2> near{};  // per hand, the nearest first
    std::array<std::uint8_t, 2> near_count{};
    std::uint32_t awake = 0, waiting = 0;  // bodies that move, and those held still until fewer move
    std::uint32_t blocked = kNoBody;       // the first driven thing that cannot go on, since a body is jammed before it
};

// A hand's force on a body over one tick, world newtons, about the body's middle.
struct HandPush {
    double time_s = 0.0, dt_s = 0.0;
    std::uint32_t body = kNoBody;
    std::uint32_t game = 0;
    Vec3 force_n{0.0}, moment_nm{0.0};
    double least_kg = 0.0;            // inertia below which a body is not led by two hands
    double most_speed_m_per_s = 0.0;  // > 0: the hand lets go here, and the body flies no faster
    bool held = false;
};

// Where a hand is, so that the engine knows what is near it.
struct HandPlace {
    Vec3 at_m{0.0};
    double radius_m = 0.0;  // 0: the hand is not there
    double time_s = 0.0;    // of the servo's tick: no two of a hand have the same

    bool present() const noexcept { return radius_m > 0.0; }
};

// What can be heard of a body.
struct BodyEvent {
    enum class Kind : std::uint8_t { Hit, Rolls, Slides, Falls, Rests, PutBack };
    Kind kind = Kind::Hit;
    std::uint32_t body = 0;
    double time_s = 0.0;
    Vec3 at_m{0.0};
    double impulse_ns = 0.0;       // Hit
    double speed_m_per_s = 0.0;    // Rolls, Slides, Falls; Hit: change of speed
    FeatureId other = kNoFeature;  // what was hit or is under it; kNoFeature: not known, or another free body
    std::uint32_t other_body = kNoBody;
};

// Friction from standing to sliding, the same law in the engine and in the hand's model: full below a slow speed, then
// weakening over a way.
struct Stick {
    static constexpr double kSlow_m_per_s = 0.02;
    static constexpr double kWay_m = 0.02;

    double slid_m = 0.0;

    void go(double speed_m_per_s, double dt_s) noexcept {
        slid_m = speed_m_per_s < kSlow_m_per_s ? 0.0 : slid_m + speed_m_per_s * dt_s;
    }
    // In units of the sliding friction; sticks: that of standing still.
    double factor(double sticks) const noexcept {
        return slid_m >= kWay_m ? 1.0 : sticks + (1.0 - sticks) * (slid_m / kWay_m);
    }
};

}  // namespace handrail
