// The messages between the engine of movable bodies and the hand's side: plain values, world metres and newtons.
// LatestValue and SpscRing copy them between threads. All but DynamicsFrame have a fixed size. A frame has room for the
// bodies of its world; only the engine allocates that room, with the first frames.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "haptic/render/dynamics_scene.h"
#include "haptic/render/haptic_scene.h"

namespace handrail::render {

// A place where a body touches or is about to touch. Its point stays on the plane's side: normal . point >= offset.
struct ContactPlane {
    Vec3 own_m{0.0};  // the point, in the body's frame
    Vec3 normal{0.0, 0.0, 1.0};
    double offset_m = 0.0;
    double friction = 0.0;    // sliding friction
    Vec3 speed_m_per_s{0.0};  // speed there of the touched surface
    bool round = false;       // for a ball: the point is always the one nearest to the plane
    double radius_m = 0.0;
};

// Everything that the servo's own model of a body needs to continue without the engine.
struct RigidBodyState {
    static constexpr std::size_t kMostPlanes = 12;

    std::uint32_t body = kNoBody;  // index in DynamicsScene::bodies
    double time_s = 0.0;           // the moment that this message describes
    Placement at;                  // pose of the body's frame: centre of mass, principal axes
    Vec3 speed_m_per_s{0.0}, turn_rad_per_s{0.0};
    double mass_kg = 1.0;
    Vec3 inertia_kg_m2{1.0};
    Vec3 gravity_m_per_s2{0.0};
    Vec3 others_n{0.0}, others_nm{0.0};  // from keys and the other hand: mean over the last step
    Vec3 string_at_m{0.0};
    double string_n_per_m = 0.0;   // 0: no string
    double string_ns_per_m = 0.0;  // damping of the string
    double sticks = 1.0;           // static friction as a multiple of the sliding friction
    double rolling_m = 0.0;
    double gap_m = 0.0;  // least distance from this hand's proxy centre to the body
    std::array<ContactPlane, kMostPlanes> planes{};
    std::uint8_t count = 0;
};

// The state of all bodies after one step of the engine.
struct DynamicsFrame {
    static constexpr std::size_t kNear = 4;

    std::uint64_t number = 0;          // number of the step; 0: none yet
    std::uint32_t game = 0;            // rises with every restart, after which nothing of the one before is valid
    double time_s = 0.0;               // time of the end of the step
    std::vector<Placement> things;     // pose of each body, for the frames that HapticScene::bodies use
    std::vector<std::uint32_t> moved;  // bodies whose pose differs from the frame before (number - 1), in rising order
    std::array<std::array<RigidBodyState, kNear>, 2> near{};  // for each hand, the nearest body first
    std::array<std::uint8_t, 2> near_count{};
    std::uint32_t awake = 0, waiting = 0;  // number of bodies that move, and of bodies held still until fewer move
    // The first driven thing that cannot continue because a body is jammed in front of it.
    std::uint32_t blocked = kNoBody;
};

// The force of a hand on a body over one tick, in world newtons, about the body's centre of mass.
struct HandPush {
    double time_s = 0.0, dt_s = 0.0;
    std::uint32_t body = kNoBody;
    std::uint32_t game = 0;
    Vec3 force_n{0.0}, moment_nm{0.0};
    double least_kg = 0.0;  // a body feels at least this heavy, because two hands cannot move a lighter one stably
    double most_speed_m_per_s = 0.0;  // > 0: the hand lets go here, and the body may fly no faster than this
    bool held = false;
};

// Where a hand is, so that the engine knows which bodies are near it.
struct HandPlace {
    Vec3 at_m{0.0};
    double radius_m = 0.0;  // 0: the hand is absent
    double time_s = 0.0;    // time of the servo's tick; unique among the messages of a hand

    bool present() const noexcept { return radius_m > 0.0; }
};

// A sound event of a body.
struct BodyEvent {
    enum class Kind : std::uint8_t { Hit, Rolls, Slides, Falls, Rests, PutBack };
    Kind kind = Kind::Hit;
    std::uint32_t body = 0;
    double time_s = 0.0;
    Vec3 at_m{0.0};
    double impulse_ns = 0.0;     // for Hit
    double speed_m_per_s = 0.0;  // for Rolls, Slides and Falls; for Hit the change of speed
    // The feature that was hit, or that is under the body. kNoFeature: unknown, or another free body.
    FeatureId other = kNoFeature;
    std::uint32_t other_body = kNoBody;
};

// Friction between standing still and sliding; the engine and the hand's model use the same law. It is full below a
// slow speed, then weakens over a distance.
struct Stick {
    static constexpr double kSlow_m_per_s = 0.02;
    static constexpr double kWay_m = 0.02;

    double slid_m = 0.0;

    void go(double speed_m_per_s, double dt_s) noexcept {
        slid_m = speed_m_per_s < kSlow_m_per_s ? 0.0 : slid_m + speed_m_per_s * dt_s;
    }
    // Returns the friction as a multiple of the sliding friction. sticks: the multiple when standing still.
    double factor(double sticks) const noexcept {
        return slid_m >= kWay_m ? 1.0 : sticks + (1.0 - sticks) * (slid_m / kWay_m);
    }
};

}  // namespace handrail::render
