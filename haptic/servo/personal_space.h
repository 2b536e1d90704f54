// The wall between the world and the person's own desk. It stands across the hand's reach, towards the body; pulled at
// with enough force it lets the hand through, and the hand is at the desk; the same wall leads back. This file knows
// the wall and what is left of forces when it gives way; servo_tick keeps the world's state meanwhile.
//
// Neither part gives the hand energy. The wall is a spring of stretch e <= depth behind its plane: e grows with the
// hand's way in, at most so fast that the force rises by 0.15 N a tick (the rest slips, as in a fuse), and shrinks with
// its way out. Once the wall has let go, e only shrinks: by 1/tau, and by every way back. So what is given back is
// never more than what was taken in.
//
//    force    /|          breaks at depth
//            / |__        falls with tau
//     ______/             -> towards the body
//        at_m
//
// Plain state, servo thread only; real-time safe; arithmetic of + - x / and square root only. Device frame, hand
// metres, newtons.
#pragma once

#include <cstdint>

#include "haptic/device/device_spec.h"
#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"

namespace handrail {

// Of one device, at one ceiling and stiffness.
struct PersonalWall {
    double at_m = 0.0;  // of the reach towards the body: its plane is y = -at_m
    double stiffness_n_per_m = 0.0;
    double depth_m = 0.0;  // behind the plane; there it lets the hand through

    double break_n() const noexcept { return stiffness_n_per_m * depth_m; }
};

inline constexpr double kPersonalWallAt = 0.8;  // of the reach
inline constexpr double kPersonalWallMost_n = 1.5, kPersonalWallShare = 0.6, kPersonalWallStiffest_n_per_m = 400.0;

// Breaks at the least of 1.5 N, 60 % of the ceiling, and what half of the way behind it can press. wall_n_per_m: of the
// default wall on this device.
PersonalWall personal_wall_of(const DeviceSpec& spec, double ceiling_n, double wall_n_per_m) noexcept;

class PersonalSpace {
public:
    static constexpr double kReleaseS = 0.040;  // time constant after it has let go
    static constexpr double kRearmM = 0.005;    // so far in front of the plane the hand meets a whole wall again
    static constexpr double kMostRiseN = 0.15;  // per tick; what a faster hand would press beyond that slips

    // Where the hand is. True when the wall lets it through on this tick. `whole`: nothing else moves the workspace;
    // otherwise the wall is not there until the hand has been in front of it again. The wall that is given counts from
    // the next time on that the hand is in front of its plane.
    bool tick(const Vec3& hand_m, const PersonalWall& wall, bool whole, double dt_s) noexcept;
    // On the hand, away from the body; at most the wall's break_n().
    Vec3 force_n() const noexcept { return {0.0, wall_.stiffness_n_per_m * stretch_m_, 0.0}; }
    bool armed() const noexcept { return armed_; }
    // The hand may be anywhere: no force, no wall until it was in front of it.
    void reset() noexcept {
        armed_ = false;
        known_ = false;
        stretch_m_ = 0.0;
    }

private:
    PersonalWall wall_;
    bool armed_ = false, known_ = false;
    double inside_m_ = 0.0;  // of the hand behind the plane; negative: in front
    double stretch_m_ = 0.0;
};

// The way to the desk where something of the world stands in it, as the back wall of a small room does: pulled at
// towards the body with the force that breaks the wall, straight and without sliding for kHold_s, it lets the hand
// through in its place. Nothing of the world becomes soft by that: one is at the desk, with its click, and back at the
// same place after it.
class PullThrough {
public:
    static constexpr double kHold_s = 0.8;      // longer than one tries how hard a wall is
    static constexpr double kSlide_m = 0.0015;  // of the hand, sideways; farther, it explores
    static constexpr double kStraight = 0.5;    // most force across, as a share of that along
    static constexpr double kNearHalf = 0.1;    // of the reach: only on the body's side of the middle

    // held_n: on the hand by what it touches, device frame, before any ceiling. True on the tick on which the hand is
    // let through.
    bool tick(const Vec3& hand_m, const Vec3& held_n, double reach_m, bool whole, double dt_s) noexcept;
    void reset() noexcept { held_s_ = 0.0; }

private:
    double held_s_ = 0.0;
    Vec3 from_m_{0.0};
};

// What is left of a force whose cause is gone at once: a spring along the force that only relaxes, with tau and with
// every way along it.
class LeftoverForce {
public:
    // stiffness_n_per_m > 0: of the stiffest surface there can have been, so that what is given back is no more than
    // what was stored.
    void begin(const Vec3& force_n, double stiffness_n_per_m) noexcept;
    void tick(const Vec3& hand_step_m, double dt_s) noexcept;
    Vec3 force_n() const noexcept { return direction_ * (stretch_m_ * stiffness_n_per_m_); }
    void clear() noexcept { stretch_m_ = 0.0; }

private:
    Vec3 direction_{0.0};
    double stretch_m_ = 0.0, stiffness_n_per_m_ = 0.0;
};

// What a hand does with a thing of the desk: it touches it, and presses it by a push or by the device's button. A push
// begins at press_n and ends at half of it, so that it does not flutter; what is pressed stays so while the hand slides
// on.
class DeskPress {
public:
    static constexpr double kPressN = 1.2, kPressShare = 0.6, kRelease = 0.5;

    // touched: kNoFeature for none. button: of the device; pressed on nothing it presses nothing, even when the hand
    // comes to something later.
    void tick(FeatureId touched, double press_n, bool button, double needed_n) noexcept;
    FeatureId held() const noexcept { return held_; }
    std::uint32_t presses() const noexcept { return presses_; }  // since the start
    // Nothing is pressed any more; a push that goes on presses nothing until it has ended.
    void let_go() noexcept { held_ = kNoFeature; }

private:
    FeatureId held_ = kNoFeature;
    std::uint32_t presses_ = 0;
    bool button_was_ = false, pushed_ = false;
};

}  // namespace handrail
