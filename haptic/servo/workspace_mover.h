// Lets the hand move its workspace through the world. Pressing past the rim of the workspace scrolls it, a held button
// drags the world along with the hand, and keys push it. The resulting shift is added to the walker's pose.
//
// Moving the workspace never pushes the hand: meanwhile the hand feels less than kMovingForceN. If contacts press
// harder, the workspace yields like a slipping clutch, towards the place where the proxy rests, so springs only relax.
// The workspace does not move into surfaces that the proxy touches. The rim's force is the slope of a potential over
// the hand's position. So neither the yielding nor the rim gives the hand energy. Yielding may cross the limits of the
// workspace, but only as far as the hand has pressed. Plain state, servo thread only; real-time safe; arithmetic of + -
// x / and square root only. World metres, unless a name says hand.
#pragma once

#include <cstdint>
#include <limits>

#include "haptic/device/device_spec.h"
#include "haptic/render/touch.h"
#include "haptic/servo/workspace_map.h"
#include "worlds/geometry/convex.h"

namespace handrail::servo {

// The person's settings for the workspace, and what the person requests by keys.
struct WorkspaceTuning {
    bool rim = false;  // pressing past the rim of the workspace scrolls it
    // If true, there is no rim on the side of the person's body, because the wall to the desk may be there. Around that
    // direction the rim is a tube.
    bool rim_open_behind = false;
    // Buttons of the device that drag the world along with the hand while they are held; 0: no button does.
    std::uint32_t grab_buttons = 0;
    bool grab_key = false;        // set by a key; acts like a held grab button
    Vec3 push_hand_m_per_s{0.0};  // velocity that the person requests by keys, device frame
    // The middle of the workspace must stay in this box. If the middle is already outside, it must not move farther
    // out. Empty: no limits.
    Aabb limits_m;
};

inline constexpr double kRimFrom = 0.8;  // share of the workspace radius within which the hand moves freely

enum class WorkspaceMotion : std::uint8_t { Still, Pushed, Scrolled, Grabbed };

// The rim of a device: a ridge that pushes the hand inwards, then a nearly free zone in which the depth determines the
// speed of scrolling. Distances are hand metres from the middle of the device.
//
//    force      /\        top_n
//              /  \______ beyond_n    scrolls
//         ____/                       -> distance
//          from  top past  end
struct Rim {
    double from_m = 0.0, top_m = 0.0, past_m = 0.0, end_m = 0.0;
    double top_n = 0.0, beyond_n = 0.0;

    // Returns the force towards the middle. The force is never negative, and it is continuous.
    double force_n(double distance_m) const noexcept;
    // Returns the speed of the workspace in hand metres per second. The speed is zero up to past_m, and greatest from
    // end_m on.
    double speed(double distance_m) const noexcept;
};
Rim rim_of(const device::DeviceSpec& spec) noexcept;

class WorkspaceMover {
public:
    static constexpr double kMovingForceN = 0.2;  // limit for the force on the hand while the workspace moves

    explicit WorkspaceMover(const device::DeviceSpec& spec) : rim_(rim_of(spec)) {}

    // Position of the hand, and the force on it in the last tick.
    struct Hand {
        Vec3 at_m{0.0};  // position of the hand in the device frame
        std::uint32_t buttons = 0;
        double wanted_n = 0.0;   // size of the force that the renderer requested, before the limiter
        double ceiling_n = 0.0;  // the lower of the person's ceiling and the device's peak force
        const render::ContactSet* contacts = nullptr;
    };
    // Call it for a good sample, before the touch is computed. Moves the workspace and applies the shift to the
    // walker's frame.
    void move(WorkspaceFrame& frame, const WorkspaceTuning& tuning, const Hand& hand, double world_m_per_hand_m,
              double dt_s) noexcept;
    // Call it after the touch is computed. The workspace yields if the contacts push harder than is permitted while it
    // moves.
    void give_way(const Vec3& hip_m, const Vec3& proxy_m, double contact_n) noexcept;

    // Returns the rim's force on the hand at its last position, device frame.
    Vec3 rim_force_n() const noexcept;
    // Returns the greatest force that the hand may feel now. It is infinite if the workspace is not moving and has not
    // moved lately.
    double ceiling_n() const noexcept;
    // Ends any grab, push or scrolling. The shift stays.
    void let_go() noexcept;
    // Drops the shift, because the workspace was placed somewhere else.
    void recentre() noexcept {
        let_go();
        shift_m_ = Vec3(0.0);
    }
    // Moves the workspace by `by_m`, in world metres.
    void shift(const Vec3& by_m) noexcept { shift_m_ += by_m; }

    WorkspaceMotion motion() const noexcept { return motion_; }
    const Vec3& shift_m() const noexcept { return shift_m_; }
    bool at_limit() const noexcept { return at_limit_; }  // the limits stopped a requested motion

private:
    Vec3 wanted_m(const WorkspaceFrame& frame, const WorkspaceTuning& tuning, const Hand& hand,
                  double world_m_per_hand_m, double dt_s) const noexcept;

    Rim rim_;
    Vec3 shift_m_{0.0};
    WorkspaceMotion motion_ = WorkspaceMotion::Still;
    bool at_limit_ = false;
    bool hand_known_ = false;
    bool rim_on_ = false;
    Vec3 hand_m_{0.0};  // position of the hand, device frame
    // Vector to the hand from the middle of the device. If the rim is open towards the person's body, the vector starts
    // at the line in that direction.
    Vec3 out_m_{0.0};
    double distance_m_ = 0.0;  // length of out_m_
    // Factor on the rim's force. It falls while a grab or a key moves the workspace, and returns to 1 only where the
    // rim gives no force.
    double rim_gain_ = 1.0;
    double contact_ceiling_n_ = std::numeric_limits<double>::infinity();
};

}  // namespace handrail::servo
