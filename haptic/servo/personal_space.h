// The wall between the world and the person's own desk. It stands across the device's workspace, on the side of the
// person's body. If the person pulls hard enough, it lets the hand through to the desk; the same wall leads back. This
// file has only the wall and the decay of its force after it breaks; servo_tick keeps the state of the world meanwhile.
//
// Neither part gives the hand energy. The wall is a spring of stretch e <= depth behind its plane. e grows as the hand
// moves in, but no faster than 0.15 N a tick (the rest slips, as in a fuse), and shrinks as the hand moves out. After
// the wall has let go, e only shrinks: by 1/tau, and with every movement back. So the wall never returns more energy
// than it took in.
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

namespace handrail::servo {

// The wall of one device, at one force ceiling and stiffness.
struct PersonalWall {
    double at_m = 0.0;  // distance from the device's middle towards the person's body; the plane is y = -at_m
    double stiffness_n_per_m = 0.0;
    double depth_m = 0.0;  // depth behind the plane at which it lets the hand through

    double break_n() const noexcept { return stiffness_n_per_m * depth_m; }
};

inline constexpr double kPersonalWallAt = 0.8;  // share of the workspace radius
inline constexpr double kPersonalWallMost_n = 1.5, kPersonalWallShare = 0.6, kPersonalWallStiffest_n_per_m = 400.0;

// The wall breaks at the least of three forces: 1.5 N, 60 % of the ceiling, and the force of its spring halfway between
// its plane and the end of the workspace. wall_n_per_m: stiffness of the default wall on this device.
PersonalWall personal_wall_of(const device::DeviceSpec& spec, double ceiling_n, double wall_n_per_m) noexcept;

class PersonalSpace {
public:
    static constexpr double kReleaseS = 0.040;  // time constant of the decay after it has let go
    static constexpr double kRearmM = 0.005;  // the wall is whole again once the hand is this far in front of its plane
    static constexpr double kMostRiseN = 0.15;  // per tick; a faster hand slips through the rest

    // Takes where the hand is. Returns true if the wall lets it through in this tick. `whole`: nothing else moves the
    // workspace; otherwise the wall is absent until the hand has been in front of it again. A new `wall` takes effect
    // only once the hand is in front of the plane.
    bool tick(const Vec3& hand_m, const PersonalWall& wall, bool whole, double dt_s) noexcept;
    // Force on the hand, away from the person's body; at most the wall's break_n().
    Vec3 force_n() const noexcept { return {0.0, wall_.stiffness_n_per_m * stretch_m_, 0.0}; }
    bool armed() const noexcept { return armed_; }
    // The hand may be anywhere: no force and no wall until the hand was in front of it.
    void reset() noexcept {
        armed_ = false;
        known_ = false;
        stretch_m_ = 0.0;
    }

private:
    PersonalWall wall_;
    bool armed_ = false, known_ = false;
    double inside_m_ = 0.0;  // how far the hand is behind the plane; negative: in front of it
    double stretch_m_ = 0.0;
};

// The way to the desk if an object of the world blocks it, such as the back wall of a small room. The person pulls
// towards the body with the force that breaks the wall, straight and without sliding, for kHold_s. The hand then goes
// through to the desk. No surface of the world softens by this: the desk is announced by its click, and the hand
// returns to the same place afterwards.
class PullThrough {
public:
    static constexpr double kHold_s = 0.8;      // longer than people press to test how hard a wall is
    static constexpr double kSlide_m = 0.0015;  // sideways movement of the hand; beyond it the person is exploring
    static constexpr double kStraight = 0.5;    // most force across, as a share of the force along the pull
    // Share of the workspace radius: a pull counts only this far on the person's side of the middle.
    static constexpr double kNearHalf = 0.1;

    // held_n: force of the touched surfaces on the hand, device frame, before any ceiling. Returns true in the tick in
    // which the hand is let through.
    bool tick(const Vec3& hand_m, const Vec3& held_n, double reach_m, bool whole, double dt_s) noexcept;
    void reset() noexcept { held_s_ = 0.0; }

private:
    double held_s_ = 0.0;
    Vec3 from_m_{0.0};
};

// The remainder of a force whose cause disappears at once: a spring along the force that only relaxes, with the time
// constant tau and with every movement along it.
class LeftoverForce {
public:
    // stiffness_n_per_m > 0: stiffness of the stiffest surface that can have caused the force, so that no more energy
    // is returned than was stored.
    void begin(const Vec3& force_n, double stiffness_n_per_m) noexcept;
    void tick(const Vec3& hand_step_m, double dt_s) noexcept;
    Vec3 force_n() const noexcept { return direction_ * (stretch_m_ * stiffness_n_per_m_); }
    void clear() noexcept { stretch_m_ = 0.0; }

private:
    Vec3 direction_{0.0};
    double stretch_m_ = 0.0, stiffness_n_per_m_ = 0.0;
};

// How a hand operates an object on the desk: it touches it, then presses it by a push or by the device's button. A push
// begins at press_n and ends at half of it, so that it does not flutter. A pressed object stays pressed while the hand
// slides on.
class DeskPress {
public:
    static constexpr double kPressN = 1.2, kPressShare = 0.6, kRelease = 0.5;

    // touched: kNoFeature for none. button: of the device; if it is pressed while nothing is touched, it presses
    // nothing, even if the hand reaches an object later.
    void tick(FeatureId touched, double press_n, bool button, double needed_n) noexcept;
    FeatureId held() const noexcept { return held_; }
    std::uint32_t presses() const noexcept { return presses_; }  // number of presses since the start
    // Releases the pressed object. A push that continues presses nothing until it has ended.
    void let_go() noexcept { held_ = kNoFeature; }

private:
    FeatureId held_ = kNoFeature;
    std::uint32_t presses_ = 0;
    bool button_was_ = false, pushed_ = false;
};

}  // namespace handrail::servo
