// Guidance that the hand can feel, only on request: a gentle pull along a path, or lines through an object on which the
// hand tends to rest. It is off unless a GuidancePath with a number is published, and then it is either one pull or one
// set of lines. The person always wins: a hand that resists the pull is released. The pull is a spring between the hand
// and a point that advances along the path. It is clamped and grows weaker the faster it moves the hand, so it never
// carries the hand faster than kFastest. Lines and grooves are bounded potentials, so they add no energy. Plain state,
// servo thread only; real-time safe; hand metres and newtons, world axes. Costs about 100 flops a tick while active, 20
// for each leg of a groove or line, and one comparison otherwise.
#pragma once

#include <array>
#include <cstdint>

#include "worlds/base/vec.h"

namespace handrail::servo {

enum class GuidanceKind : std::uint8_t {
    Pull,        // along points_m, to the last point
    CrossLines,  // three planes through points_m[0], one level and two upright, each felt within kLineHalfWidth
    // Hollows along the legs from each even point to the next: upright trenches that end at the height of the leg and
    // keep the hand from leaving sideways.
    Grooves,
    WayLines,  // the same legs as lines, which hold the hand from all sides, so that a hand can follow a path
};

// The guidance that the app requests. Published as a whole; about 1.6 kB.
struct GuidancePath {
    static constexpr std::uint32_t kMostPoints = 64;

    std::uint32_t number = 0;  // a new number restarts guidance; 0: no guidance
    GuidanceKind kind = GuidanceKind::Pull;
    double strength = 1.0;  // 0 to 1 of the force limits; 0 pulls with no force but still reports the arrival
    std::uint32_t count = 0;
    std::array<Vec3, kMostPoints> points_m{};  // world
};

enum class GuidancePhase : std::uint8_t {
    Off,
    Acts,
    LetGo,    // the person resisted
    Arrived,  // the hand reached the end of the path
    Ended,    // ended by the app, or because force must not act
};

// The published state of the guidance.
struct GuidanceState {
    GuidancePhase phase = GuidancePhase::Off;
    std::uint32_t number = 0;  // number of the path that this state belongs to
    Vec3 force_n{0.0};         // on the hand, world axes, before any ramp of the limiter
    double counter_n = 0.0;    // the unclamped force of the spring
};

class Guidance {
public:
    static constexpr double kStiffness_n_per_m = 300.0;
    // The lesser of the two limits counts; kMostShare is a share of the device's peak force.
    static constexpr double kMostForce_n = 0.8, kMostShare = 0.25;
    static constexpr double kRamp_s = 0.5, kFade_s = 0.075;
    static constexpr double kLetGo_n = 1.2, kLetGo_s = 0.3;
    static constexpr double kFastest_m_per_s = 0.05;  // at this speed of the hand the pull has fallen to zero
    // Speed of the pulling point; slower than kFastest, so that the hand can catch up.
    static constexpr double kPointSpeed_m_per_s = 0.04;
    static constexpr double kLead_m = 0.0025;    // the point waits for a hand that is farther behind than this: 0.75 N
    static constexpr double kArrived_m = 0.004;  // distance from the end of the path that counts as arrived
    static constexpr double kLineHalfWidth_m = 0.006,
                            kLine_n = 0.4;  // peak of each of the three lines, reached at 0.45 of the half width
    static constexpr double
        kGrooveHalfWidth_m = 0.006,
        // Peak of a groove far from others, reached at 0.45 of the half width; 1.28 times that where two meet.
        kGroove_n = 0.35;

    // Returns the force of this tick. hand_m: world; scale: world metres per hand metre; allowed: forces may act at
    // all, otherwise active guidance ends.
    Vec3 tick(const GuidancePath& path, const Vec3& hand_m, double scale, double peak_force_n, bool allowed,
              double dt_s) noexcept;
    // Ends active guidance, which fades from the next tick on: the hand's position is no longer valid.
    void stop() noexcept {
        if (state_.phase == GuidancePhase::Acts) end(GuidancePhase::Ended);
    }
    const GuidanceState& state() const noexcept { return state_; }
    // Returns true if nothing is active and this path requests nothing new.
    bool idle(const GuidancePath& path) const noexcept {
        return path.number == state_.number && state_.phase != GuidancePhase::Acts && fade_ <= 0.0;
    }

private:
    void begin(const GuidancePath& path, const Vec3& hand_m) noexcept;
    void end(GuidancePhase phase) noexcept;
    void go_on(const GuidancePath& path, const Vec3& hand_m, double scale, double dt_s) noexcept;
    Vec3 pull(const GuidancePath& path, const Vec3& hand_m, double scale, double most_n, double dt_s) noexcept;
    static Vec3 grooves(const GuidancePath& path, const Vec3& hand_m, double scale, double most_n) noexcept;
    Vec3 lines(const GuidancePath& path, const Vec3& hand_m, double scale, double most_n) const noexcept;

    GuidanceState state_;
    Vec3 point_m_{0.0};        // the pulling point, world
    std::uint32_t next_ = 0;   // index of the path point that the pulling point moves towards
    Vec3 hand_before_m_{0.0};  // world
    // Speed of the hand in hand metres, filtered with one pole of 20 ms: one encoder step of 0.06 mm is 3 mm/s.
    Vec3 velocity_m_per_s_{0.0};
    double acted_s_ = 0.0, against_s_ = 0.0;
    double fade_ = 0.0;  // falls from 1 to 0 after the end
    Vec3 last_n_{0.0};   // the force at the moment it ended
};

}  // namespace handrail::servo
