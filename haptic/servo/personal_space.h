// Implements the wall between the world and the person's own desk. It stands across the device's workspace, on the side
// of the person's body. If the person pulls hard enough, the wall lets the hand through to the desk. The same wall
// leads back. This file contains only the wall and the decay of the wall's force after it breaks. Meanwhile,
// servo_tick() keeps the hand's state in the world.
//
// Neither the wall nor the decay gives the hand energy. The wall is a spring of stretch e <= depth behind its plane. e
// grows as the hand moves in, but by no more than 0.15 N a tick; the rest slips. e shrinks as the hand moves out. After
// the wall has broken, e only shrinks: by 1/tau, and with every movement back. So the wall never returns more energy
// than it received.
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

// The wall of one device, for a given force ceiling and stiffness.
struct PersonalWall {
    // Distance of the wall's plane from the device's middle, towards the person's body. The plane is y = -at_m.
    double at_m = 0.0;
    double stiffness_n_per_m = 0.0;
    double depth_m = 0.0;  // depth behind the plane at which the wall breaks

    double break_n() const noexcept { return stiffness_n_per_m * depth_m; }
};

inline constexpr double kPersonalWallAt = 0.8;  // position of the plane as a share of the workspace radius
inline constexpr double kPersonalWallMost_n = 1.5, kPersonalWallShare = 0.6, kPersonalWallStiffest_n_per_m = 400.0;

// Returns the wall. It breaks at the least of three forces: 1.5 N, 60 % of the ceiling, and the force of the wall's
// spring halfway between the wall's plane and the end of the workspace. `wall_n_per_m` is the stiffness of the default
// wall on this device.
PersonalWall personal_wall_of(const device::DeviceSpec& spec, double ceiling_n, double wall_n_per_m) noexcept;

class PersonalSpace {
public:
    static constexpr double kReleaseS = 0.040;  // time constant with which the force decays after the wall has broken
    static constexpr double kRearmM = 0.005;    // the wall is restored once the hand is this far in front of its plane
    static constexpr double kMostRiseN = 0.15;  // greatest rise of the force per tick; a faster hand slips

    // Updates the wall for the hand's new position. Returns true if the wall lets the hand through in this tick.
    // `whole` says that nothing else moves the workspace. If it is false, the wall is absent until the hand has been in
    // front of the wall again. A new `wall` takes effect only once the hand is in front of the plane.
    bool tick(const Vec3& hand_m, const PersonalWall& wall, bool whole, double dt_s) noexcept;
    // Returns the force on the hand, away from the person's body. It is at most the wall's break_n().
    Vec3 force_n() const noexcept { return {0.0, wall_.stiffness_n_per_m * stretch_m_, 0.0}; }
    bool armed() const noexcept { return armed_; }
    // Call it if the hand may be anywhere. There is no force and no wall until the hand has been in front of the plane.
    void reset() noexcept {
        armed_ = false;
        known_ = false;
        stretch_m_ = 0.0;
    }

private:
    PersonalWall wall_;
    bool armed_ = false, known_ = false;
    double inside_m_ = 0.0;  // distance of the hand behind the plane; negative: in front of it
    double stretch_m_ = 0.0;
};

// Lets the hand through to the desk if an object of the world blocks the hand, such as the back wall of a small room.
// The person pulls towards the body with the force that breaks the wall, straight and without sliding, for kHold_s. The
// surfaces of the world do not become softer: a click announces the desk, and the hand later returns to the same place.
class PullThrough {
public:
    static constexpr double kHold_s = 0.8;  // duration of the pull; longer than people press to test how hard a wall is
    // Sideways movement of the hand above which the person is exploring and not pulling.
    static constexpr double kSlide_m = 0.0015;
    static constexpr double kStraight = 0.5;  // greatest sideways force, as a share of the force along the pull
    // Least distance of the hand from the middle, on the person's side, at which it can pull; as a share of the
    // workspace radius.
    static constexpr double kNearHalf = 0.1;

    // Returns true in the tick in which the hand is let through. `held_n` is the force of the touched surfaces on the
    // hand, in the device frame, before any ceiling.
    bool tick(const Vec3& hand_m, const Vec3& held_n, double reach_m, bool whole, double dt_s) noexcept;
    void reset() noexcept { held_s_ = 0.0; }

private:
    double held_s_ = 0.0;
    Vec3 from_m_{0.0};
};

// A force that remains when its cause disappears at once. LeftoverForce is a spring along the force's direction, which
// only relaxes: with the time constant tau, and with every movement of the hand along it.
class LeftoverForce {
public:
    // `stiffness_n_per_m` (> 0) is the stiffness of the stiffest surface that can have caused the force. With it, the
    // spring returns no more energy than was stored.
    void begin(const Vec3& force_n, double stiffness_n_per_m) noexcept;
    void tick(const Vec3& hand_step_m, double dt_s) noexcept;
    Vec3 force_n() const noexcept { return direction_ * (stretch_m_ * stiffness_n_per_m_); }
    void clear() noexcept { stretch_m_ = 0.0; }

private:
    Vec3 direction_{0.0};
    double stretch_m_ = 0.0, stiffness_n_per_m_ = 0.0;
};

// Decides how a hand operates an object on the desk: the hand touches the object, then presses it by a push or by the
// device's button. A push begins at the force `needed_n` and ends at half of it, so that it does not flicker. A pressed
// object stays pressed while the hand slides on.
class DeskPress {
public:
    static constexpr double kPressN = 1.2, kPressShare = 0.6, kRelease = 0.5;

    // `touched` is the touched object, or kNoFeature. `button` is the device's button. If the person presses the button
    // while the hand touches nothing, it presses nothing, even if the hand reaches an object later.
    void tick(FeatureId touched, double press_n, bool button, double needed_n) noexcept;
    FeatureId held() const noexcept { return held_; }
    std::uint32_t presses() const noexcept { return presses_; }  // number of presses since the start
    // Releases the pressed object. A push that continues has no effect until it has ended.
    void let_go() noexcept { held_ = kNoFeature; }

private:
    FeatureId held_ = kNoFeature;
    std::uint32_t presses_ = 0;
    bool button_was_ = false, pushed_ = false;
};

}  // namespace handrail::servo
