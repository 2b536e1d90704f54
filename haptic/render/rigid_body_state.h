// Defines the messages between the engine of the free bodies and the servos of the hands: plain values, world metres
// and newtons. LatestValue and SpscRing copy them between threads. All but DynamicsFrame have a fixed size. A frame has
// room for the bodies of its world; the engine allocates it with the first frames, and no other code does.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "haptic/render/dynamics_scene.h"
#include "haptic/render/haptic_scene.h"

namespace handrail::render {

// A place where a body touches another object or is about to touch it. The point stays in front of the plane: normal .
// point >= offset.
struct ContactPlane {
    Vec3 own_m{0.0};  // the contact point, in the body's frame
    Vec3 normal{0.0, 0.0, 1.0};
    double offset_m = 0.0;
    double friction = 0.0;    // coefficient of sliding friction
    Vec3 speed_m_per_s{0.0};  // velocity of the touched surface at that point
    // True if the body is a ball. The contact point is then always the ball's point nearest to the plane.
    bool round = false;
    double radius_m = 0.0;
};

// The state from which the servo's own model of a body can continue without the engine.
struct RigidBodyState {
    static constexpr std::size_t kMostPlanes = 12;

    std::uint32_t body = kNoBody;  // index in DynamicsScene::bodies
    double time_s = 0.0;           // time that this message describes
    Placement at;  // pose of the body's frame, whose origin is the centre of mass and whose axes are principal
    Vec3 speed_m_per_s{0.0}, turn_rad_per_s{0.0};
    double mass_kg = 1.0;
    Vec3 inertia_kg_m2{1.0};
    Vec3 gravity_m_per_s2{0.0};
    // Forces and moments on the body from the keyboard and the other hand; mean over the last step.
    Vec3 others_n{0.0}, others_nm{0.0};
    Vec3 string_at_m{0.0};
    double string_n_per_m = 0.0;   // stiffness of the string; 0: no string
    double string_ns_per_m = 0.0;  // damping of the string
    double sticks = 1.0;           // static friction as a multiple of sliding friction
    double rolling_m = 0.0;
    double gap_m = 0.0;  // least distance from the centre of this hand's proxy to the body
    std::array<ContactPlane, kMostPlanes> planes{};
    std::uint8_t count = 0;
};

// The state of all bodies after one step of the engine.
struct DynamicsFrame {
    static constexpr std::size_t kNear = 4;

    std::uint64_t number = 0;  // number of the step; 0: none yet
    std::uint32_t game = 0;    // Number of the game. Each restart raises it and invalidates everything from before.
    double time_s = 0.0;       // time of the end of the step
    std::vector<Placement> things;     // pose of each body, in the frames of HapticScene::bodies
    std::vector<std::uint32_t> moved;  // bodies whose pose differs from that in frame number - 1, in rising order
    std::array<std::array<RigidBodyState, kNear>, 2> near{};  // the nearest bodies of each hand, nearest first
    std::array<std::uint8_t, 2> near_count{};
    std::uint32_t awake = 0, waiting = 0;  // number of bodies that move, and of bodies held still until fewer move
    // The first driven thing that cannot continue because a body is jammed in front of it; kNoBody: none.
    std::uint32_t blocked = kNoBody;
};

// The force and moment of a hand on a body over one tick, in world axes, about the body's centre of mass.
struct HandPush {
    double time_s = 0.0, dt_s = 0.0;
    std::uint32_t body = kNoBody;
    std::uint32_t game = 0;
    Vec3 force_n{0.0}, moment_nm{0.0};
    double least_kg = 0.0;  // least inertial mass of the body, because two hands cannot move a lighter one stably
    double most_speed_m_per_s = 0.0;  // > 0: the hand releases the body, which may fly no faster than this
    bool held = false;
};

// The place of a hand. From it, the engine knows which bodies are near the hand.
struct HandPlace {
    Vec3 at_m{0.0};
    double radius_m = 0.0;  // radius of the proxy; 0: the hand is absent
    double time_s = 0.0;    // time of the servo's tick; each message of a hand has a different time

    bool present() const noexcept { return radius_m > 0.0; }
};

// A sound event of a body.
struct BodyEvent {
    enum class Kind : std::uint8_t { Hit, Rolls, Slides, Falls, Rests, PutBack };
    Kind kind = Kind::Hit;
    std::uint32_t body = 0;
    double time_s = 0.0;
    Vec3 at_m{0.0};
    double impulse_ns = 0.0;     // impulse of the impact, for Hit
    double speed_m_per_s = 0.0;  // speed for Rolls, Slides and Falls; change of speed for Hit
    // The feature that was hit or that is under the body. kNoFeature: not known, or another free body.
    FeatureId other = kNoFeature;
    std::uint32_t other_body = kNoBody;
};

// Friction between sticking and sliding. The engine and the servo's model of a body use the same law. Friction is
// static below a slow speed, then weakens over a distance to sliding friction.
struct Stick {
    static constexpr double kSlow_m_per_s = 0.02;
    static constexpr double kWay_m = 0.02;

    double slid_m = 0.0;

    void go(double speed_m_per_s, double dt_s) noexcept {
        slid_m = speed_m_per_s < kSlow_m_per_s ? 0.0 : slid_m + speed_m_per_s * dt_s;
    }
    // Returns the friction as a multiple of sliding friction. `sticks` is the multiple while the body does not move.
    double factor(double sticks) const noexcept {
        return slid_m >= kWay_m ? 1.0 : sticks + (1.0 - sticks) * (slid_m / kWay_m);
    }
};

}  // namespace handrail::render
