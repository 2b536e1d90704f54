// Moves the hand's workspace through the world by the hand itself: pressed past the rim of its reach it scrolls, with a
// button held the world goes along with the hand, and keys push it. What is added to the walking body's pose is the
// shift. The hand is never pushed by this. While the workspace moves, the hand feels less than kMovingForceN: a pressed
// workspace gives way like a slipping clutch, towards where the ball rests, so that springs are only ever relaxed; and
// it does not move into what the ball touches. The rim is a potential over the hand's place. So neither gives the hand
// energy. Giving way may lead over the limits, by no more than the hand pressed. Plain state, servo thread only;
// real-time safe; arithmetic of + - x / and square root only. World metres, unless a name says hand.
#pragma once

#include <cstdint>
#include <limits>

#include "haptic/device/device_spec.h"
#include "haptic/render/touch.h"
#include "haptic/servo/workspace_map.h"
#include "worlds/geometry/convex.h"

namespace handrail {

// What the person has chosen and, by keys, asks for.
struct WorkspaceTuning {
    bool rim = false;  // press past the rim of the reach to scroll
    // Towards the body there is no rim: something else is there. Beside that way it is a tube round it.
    bool rim_open_behind = false;
    std::uint32_t grab_buttons = 0;  // while one of these is held the world goes along with the hand; 0: none does
    bool grab_key = false;           // as if a button were held
    Vec3 push_hand_m_per_s{0.0};     // by keys, device frame
    Aabb limits_m;  // the middle of the workspace leaves this no farther than it is already outside; empty: no limits
};

inline constexpr double kRimFrom = 0.8;  // of the reach: inside, a hand moves freely

enum class WorkspaceMotion : std::uint8_t { Still, Pushed, Scrolled, Grabbed };

// The rim of a device: a ridge of force inwards, then a nearly free zone in which depth is speed. Hand metres from the
// middle of the device.
//
//    force      /\        top_n
//              /  \______ beyond_n    scrolls
//         ____/                       -> distance
//          from  top past  end
struct Rim {
    double from_m = 0.0, top_m = 0.0, past_m = 0.0, end_m = 0.0;
    double top_n = 0.0, beyond_n = 0.0;

    // Towards the middle, never negative, continuous.
    double force_n(double distance_m) const noexcept;
    // Of the workspace in hand metres per second: zero up to past_m, most from end_m on.
    double speed(double distance_m) const noexcept;
};
Rim rim_of(const DeviceSpec& spec) noexcept;

class WorkspaceMover {
public:
    static constexpr double kMovingForceN = 0.2;  // while the workspace moves, the hand feels less

    explicit WorkspaceMover(const DeviceSpec& spec) : rim_(rim_of(spec)) {}

    // Where the hand is and what it felt on the last tick.
    struct Hand {
        Vec3 at_m{0.0};  // device frame
        std::uint32_t buttons = 0;
        double wanted_n = 0.0;   // size of the force before the limiter
        double ceiling_n = 0.0;  // of the person and the device
        const ContactSet* contacts = nullptr;
    };
    // Of a good sample, before touching: moves the workspace and lays the shift on the body's frame.
    void move(WorkspaceFrame& frame, const WorkspaceTuning& tuning, const Hand& hand, double world_m_per_hand_m,
              double dt_s) noexcept;
    // After touching: the workspace gives way where the contacts push harder than they may while it moves.
    void give_way(const Vec3& hip_m, const Vec3& proxy_m, double contact_n) noexcept;

    // On the hand at its last place, device frame.
    Vec3 rim_force_n() const noexcept;
    // Most that the hand may feel now; infinity when nothing moves and nothing has moved lately.
    double ceiling_n() const noexcept;
    // The same place, a new start: whatever was held is let go, the shift stays.
    void let_go() noexcept;
    // The workspace was put somewhere else: no shift.
    void recentre() noexcept {
        let_go();
        shift_m_ = Vec3(0.0);
    }
    // The workspace is put aside by so much, world metres.
    void shift(const Vec3& by_m) noexcept { shift_m_ += by_m; }

    WorkspaceMotion motion() const noexcept { return motion_; }
    const Vec3& shift_m() const noexcept { return shift_m_; }
    bool at_limit() const noexcept { return at_limit_; }  // wants to move farther than its limits let it

private:
    Vec3 wish_m(const WorkspaceFrame& frame, const WorkspaceTuning& tuning, const Hand& hand, double world_m_per_hand_m,
                double dt_s) const noexcept;

    Rim rim_;
    Vec3 shift_m_{0.0};
    WorkspaceMotion motion_ = WorkspaceMotion::Still;
    bool at_limit_ = false;
    bool hand_known_ = false;
    bool rim_on_ = false;
    Vec3 hand_m_{0.0};         // device frame
    Vec3 out_m_{0.0};          // of the hand from the middle of the device, or from the way towards the body
    double distance_m_ = 0.0;  // its length
    // Falls when something else moves the workspace; comes back only where the rim gives no force.
    double rim_gain_ = 1.0;
    double contact_ceiling_n_ = std::numeric_limits<double>::infinity();
};

}  // namespace handrail
