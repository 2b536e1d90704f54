// Guides the hand, only on request: by a gentle pull along a path, or by lines through an object at which the hand
// tends to rest. Guidance is off unless a GuidancePath with a number is published, and then it is either one pull or
// one set of lines. The person always wins: the pull releases a hand that resists it.
//
// The pull is a spring between the hand and a point that advances along the path. Its force is limited and decreases
// with the speed at which it moves the hand, so it never moves the hand faster than kFastest. Lines and grooves are
// bounded potentials, so they add no energy. Plain state, servo thread only; real-time safe; hand metres and newtons,
// world axes. Costs about 100 flops a tick while active, 20 for each leg of a groove or line, and one comparison
// otherwise.
#pragma once

#include <array>
#include <cstdint>

#include "worlds/base/vec.h"

namespace handrail::servo {

enum class GuidanceKind : std::uint8_t {
    Pull,        // a pull along points_m to the last point
    CrossLines,  // three planes through points_m[0], one horizontal and two vertical, each felt within kLineHalfWidth
    // Grooves along the legs from each even point to the next. A groove is a vertical trench that ends at the height of
    // its leg and keeps the hand from leaving sideways.
    Grooves,
    PathLines,  // The same legs as lines. They hold the hand from all sides, so that the hand can follow the path.
};

// The guidance that the app requests. Published as one value; about 1.6 kB.
struct GuidancePath {
    static constexpr std::uint32_t kMostPoints = 64;

    std::uint32_t number = 0;  // a new number restarts guidance; 0: no guidance
    GuidanceKind kind = GuidanceKind::Pull;
    // Share of the force limits, 0 to 1. If it is 0, there is no force, but the arrival is still reported.
    double strength = 1.0;
    std::uint32_t count = 0;
    std::array<Vec3, kMostPoints> points_m{};  // points of the path, in the world
};

enum class GuidancePhase : std::uint8_t {
    Off,
    Acts,
    LetGo,    // the person resisted, so the pull released the hand
    Arrived,  // the hand reached the end of the path
    Ended,    // the app ended the guidance, or force is no longer permitted
};

// The published state of the guidance.
struct GuidanceState {
    GuidancePhase phase = GuidancePhase::Off;
    std::uint32_t number = 0;  // number of the path to which this state belongs
    Vec3 force_n{0.0};         // force on the hand in world axes, before the ramp of the limiter
    double counter_n = 0.0;    // force of the spring, before any limit
};

class Guidance {
public:
    static constexpr double kStiffness_n_per_m = 300.0;
    // Limits of the force: an absolute value, and kMostShare of the device's peak force. The smaller one applies.
    static constexpr double kMostForce_n = 0.8, kMostShare = 0.25;
    static constexpr double kRamp_s = 0.5, kFade_s = 0.075;
    static constexpr double kLetGo_n = 1.2, kLetGo_s = 0.3;
    static constexpr double kFastest_m_per_s = 0.05;  // speed of the hand at which the pull has decreased to zero
    // Speed of the pulling point. It is less than kFastest, so that the hand can catch up.
    static constexpr double kPointSpeed_m_per_s = 0.04;
    // Distance of the hand behind the pulling point at which the point waits for the hand. The spring then gives 0.75
    // N.
    static constexpr double kLead_m = 0.0025;
    static constexpr double kArrived_m = 0.004;  // distance from the end of the path at which the hand has arrived
    static constexpr double kLineHalfWidth_m = 0.006,
                            // Greatest force of each of the three lines, reached at 0.45 of the half width.
        kLine_n = 0.4;
    static constexpr double kGrooveHalfWidth_m = 0.006,
                            // Greatest force of a groove far from others, reached at 0.45 of the half width. Where two
                            // grooves meet, the force is up to 1.28 times as great.
        kGroove_n = 0.35;

    // Returns the force of this tick. `hand_m` is in the world; `scale` is world metres per hand metre. `allowed` says
    // whether force may act at all; if not, active guidance ends.
    Vec3 tick(const GuidancePath& path, const Vec3& hand_m, double scale, double peak_force_n, bool allowed,
              double dt_s) noexcept;
    // Ends active guidance because the hand's position is no longer valid. The force fades from the next tick on.
    void stop() noexcept {
        if (state_.phase == GuidancePhase::Acts) end(GuidancePhase::Ended);
    }
    const GuidanceState& state() const noexcept { return state_; }
    // Returns true if no guidance is active and `path` requests nothing new.
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
    Vec3 point_m_{0.0};        // the pulling point, in the world
    std::uint32_t next_ = 0;   // index of the path point towards which the pulling point moves
    Vec3 hand_before_m_{0.0};  // position of the hand in the last tick, in the world
    // Velocity of the hand in hand metres, filtered with one pole of 20 ms. Without the filter, one encoder step of
    // 0.06 mm would count as 60 mm/s; with it, it counts as 3 mm/s.
    Vec3 velocity_m_per_s_{0.0};
    double acted_s_ = 0.0, against_s_ = 0.0;
    double fade_ = 0.0;  // falls from 1 to 0 after guidance has ended
    Vec3 last_n_{0.0};   // force at the moment when guidance ended
};

}  // namespace handrail::servo
