// Help that the hand can feel, and only on request: a gentle pull along a way, or lines through a thing on which the
// hand likes to rest. Off unless a GuidancePath with a number is published; then one pull or one set of lines, never
// both. What the person does wins: a hand that holds against the pull is let go. The pull is a spring between the hand
// and a point that goes along the way, clamped, and weaker the faster it moves the hand, so that it never carries it
// along at more than kFastest. Lines and grooves are bounded potentials, so they give no energy. Plain state, servo
// thread only; real-time safe; hand metres and newtons, world axes. About 100 flops a tick while it acts, 20 for each
// leg of a groove or line, one comparison otherwise.
#pragma once

#include <array>
#include <cstdint>

#include "worlds/base/vec.h"

namespace handrail {

enum class GuidanceKind : std::uint8_t {
    Pull,        // along points_m, to the last one
    CrossLines,  // the three level and upright planes through points_m[0], each felt from kLineHalfWidth on
    Grooves,  // hollows along the legs from each even point to the next: upright trenches that end at the height of the
              // leg and hold the hand aside
    WayLines,  // the same legs as lines, which hold the hand from all sides: a way that a hand can follow
};

// What the app wants. Published as a whole; about 1.6 kB.
struct GuidancePath {
    static constexpr std::uint32_t kMostPoints = 64;

    std::uint32_t number = 0;  // another number starts anew; 0: no guidance
    GuidanceKind kind = GuidanceKind::Pull;
    double strength = 1.0;  // 0 to 1 of the limits; 0 pulls nothing and still tells of arriving
    std::uint32_t count = 0;
    std::array<Vec3, kMostPoints> points_m{};  // world
};

enum class GuidancePhase : std::uint8_t {
    Off,
    Acts,
    LetGo,    // the person held against it
    Arrived,  // at the end of the way
    Ended,    // by the app, or because force may not act
};

// What others may know of it.
struct GuidanceState {
    GuidancePhase phase = GuidancePhase::Off;
    std::uint32_t number = 0;  // of the path that this is about
    Vec3 force_n{0.0};         // on the hand, world axes, before any ramp of the limiter
    double counter_n = 0.0;    // the unclamped force of the spring
};

class Guidance {
public:
    static constexpr double kStiffness_n_per_m = 300.0;
    static constexpr double kMostForce_n = 0.8, kMostShare = 0.25;  // whichever is less, the share of the device's peak
    static constexpr double kRamp_s = 0.5, kFade_s = 0.075;
    static constexpr double kLetGo_n = 1.2, kLetGo_s = 0.3;
    static constexpr double kFastest_m_per_s = 0.05;  // the pull is nothing at this speed of the hand
    static constexpr double kPointSpeed_m_per_s =
        0.04;                                    // of the point that pulls; the rest is for the hand to catch up
    static constexpr double kLead_m = 0.0025;    // the point waits for a hand that is farther behind: 0.75 N
    static constexpr double kArrived_m = 0.004;  // from the end of the way
    static constexpr double kLineHalfWidth_m = 0.006,
                            kLine_n = 0.4;  // of each of the three lines at most, at 0.45 of the half width
    static constexpr double
        kGrooveHalfWidth_m = 0.006,
        kGroove_n = 0.35;  // of a groove far from others, at 0.45 of the half width; 1.28 of it where two meet

    // Force of this tick. hand_m: world; scale: world metres per hand metre; allowed: forces may act at all, else what
    // acts ends.
    Vec3 tick(const GuidancePath& path, const Vec3& hand_m, double scale, double peak_force_n, bool allowed,
              double dt_s) noexcept;
    // What acts ends, and fades from the next tick on: the place of the hand means nothing any more.
    void stop() noexcept {
        if (state_.phase == GuidancePhase::Acts) end(GuidancePhase::Ended);
    }
    const GuidanceState& state() const noexcept { return state_; }
    // Nothing is under way and this path asks for nothing new.
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
    Vec3 point_m_{0.0};        // that pulls, world
    std::uint32_t next_ = 0;   // of the way's points that it goes to
    Vec3 hand_before_m_{0.0};  // world
    // Of the hand, hand metres, one pole of 20 ms: a step of an encoder of 0.06 mm is 3 mm/s.
    Vec3 velocity_m_per_s_{0.0};
    double acted_s_ = 0.0, against_s_ = 0.0;
    double fade_ = 0.0;  // 1 to 0 after the end
    Vec3 last_n_{0.0};   // when it ended
};

}  // namespace handrail
