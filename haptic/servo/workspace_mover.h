// Lets the hand move its workspace through the world. Pressing past the rim of the workspace scrolls it, a held button
// drags the world along with the hand, and keys push it. The shift is added to the walker's pose. The hand is never
// pushed by this. While the workspace moves, the hand feels less than kMovingForceN. A pressed workspace gives way like
// a slipping clutch, towards the place where the proxy rests, so springs only relax. The workspace does not move into
// what the proxy touches. The rim is a potential over the hand's position. So neither gives the hand energy. Giving way
// may cross the limits, but by no more than the hand pressed. Plain state, servo thread only; real-time safe;
// arithmetic of + - x / and square root only. World metres, unless a name says hand.
#pragma once

#include <cstdint>
#include <limits>

#include "haptic/device/device_spec.h"
#include "haptic/render/touch.h"
#include "haptic/servo/workspace_map.h"
#include "worlds/geometry/convex.h"

namespace handrail::servo {

// The person's settings, and what they request by keys.
struct WorkspaceTuning {
    bool rim = false;  // pressing past the rim of the workspace scrolls it
    // No rim on the side of the person's body, because something else is there. Around that direction the rim is a
    // tube.
    bool rim_open_behind = false;
    // While one of these is held, the world moves along with the hand; 0: no button does.
    std::uint32_t grab_buttons = 0;
    bool grab_key = false;        // acts as if such a button were held
    Vec3 push_hand_m_per_s{0.0};  // requested by keys, device frame
    // The middle of the workspace may not leave this box. If it is outside already, it may go no farther out. Empty: no
    // limits.
    Aabb limits_m;
};

inline constexpr double kRimFrom = 0.8;  // share of the workspace radius; within it the hand moves freely

enum class WorkspaceMotion : std::uint8_t { Still, Pushed, Scrolled, Grabbed };

// The rim of a device: a ridge of force inwards, then a nearly free zone in which depth sets the speed. Distances in
// hand metres from the middle of the device.
//
//    force      /\        top_n
//              /  \______ beyond_n    scrolls
//         ____/                       -> distance
//          from  top past  end
struct Rim {
    double from_m = 0.0, top_m = 0.0, past_m = 0.0, end_m = 0.0;
    double top_n = 0.0, beyond_n = 0.0;

    // Force towards the middle; never negative, continuous.
    double force_n(double distance_m) const noexcept;
    // Speed of the workspace in hand metres per second: zero up to past_m, greatest from end_m on.
    double speed(double distance_m) const noexcept;
};
Rim rim_of(const device::DeviceSpec& spec) noexcept;

class WorkspaceMover {
public:
    static constexpr double kMovingForceN = 0.2;  // the hand feels less than this while the workspace moves

    explicit WorkspaceMover(const device::DeviceSpec& spec) : rim_(rim_of(spec)) {}

    // Position of the hand, and what it felt in the last tick.
    struct Hand {
        Vec3 at_m{0.0};  // device frame
        std::uint32_t buttons = 0;
        double wanted_n = 0.0;   // size of the force before the limiter
        double ceiling_n = 0.0;  // the lesser of the person's and the device's
        const render::ContactSet* contacts = nullptr;
    };
    // Call it for a good sample, before touching. Moves the workspace and applies the shift to the walker's frame.
    void move(WorkspaceFrame& frame, const WorkspaceTuning& tuning, const Hand& hand, double world_m_per_hand_m,
              double dt_s) noexcept;
    // Call it after touching: the workspace gives way if the contacts push harder than they may while it moves.
    void give_way(const Vec3& hip_m, const Vec3& proxy_m, double contact_n) noexcept;

    // Force on the hand at its last position, device frame.
    Vec3 rim_force_n() const noexcept;
    // Greatest force that the hand may feel now; infinity if nothing moves and nothing has moved lately.
    double ceiling_n() const noexcept;
    // Releases whatever was held and starts again at the same place; the shift stays.
    void let_go() noexcept;
    // The workspace was placed somewhere else, so the shift is dropped.
    void recentre() noexcept {
        let_go();
        shift_m_ = Vec3(0.0);
    }
    // Moves the workspace by this much, in world metres.
    void shift(const Vec3& by_m) noexcept { shift_m_ += by_m; }

    WorkspaceMotion motion() const noexcept { return motion_; }
    const Vec3& shift_m() const noexcept { return shift_m_; }
    bool at_limit() const noexcept { return at_limit_; }  // the limits stop a requested motion

private:
    Vec3 wish_m(const WorkspaceFrame& frame, const WorkspaceTuning& tuning, const Hand& hand, double world_m_per_hand_m,
                double dt_s) const noexcept;

    Rim rim_;
    Vec3 shift_m_{0.0};
    WorkspaceMotion motion_ = WorkspaceMotion::Still;
    bool at_limit_ = false;
    bool hand_known_ = false;
    bool rim_on_ = false;
    Vec3 hand_m_{0.0};  // device frame
    // From the middle of the device to the hand, or from the line towards the person's body if the rim is open there.
    Vec3 out_m_{0.0};
    double distance_m_ = 0.0;  // its length
    // Falls when a grab or a key moves the workspace; returns to 1 only where the rim gives no force.
    double rim_gain_ = 1.0;
    double contact_ceiling_n_ = std::numeric_limits<double>::infinity();
};

}  // namespace handrail::servo
