// Where the hand's workspace is in the world, how large it is and which direction it faces. Also the simulated hand,
// which keys move in it. App thread only; world metres, unless a name says device or hand.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/dialogue/held_keys.h"
#include "app/core/hand/touch_view.h"

namespace handrail::core {

// Why the pose changed.
// - Walked: the walker may have moved a little.
// - Moved: the workspace jumps from where the hand had moved it.
// - Placed: the workspace returns to where it belongs.
enum class PoseChange { Walked, Moved, Placed };

class Workspace : SessionPart {
public:
    // Sets the pose of `hands`, and changes the settings that determine it.
    Workspace(const SessionContext& context, HandsState& hands, const HeldKeys& keys, TouchView& touch)
        : SessionPart(context), hands_(hands), keys_(keys), touch_(touch) {}

    // Poses for the only or right hand, and for the left one. Each servo adds its own hand's shift to its pose; the
    // other hand's shift is already included.
    servo::WorkspacePose pose() const { return pose_beside(shift_of(hands_.left_tool)); }
    servo::WorkspacePose left_pose() const { return pose_beside(shift_of(hands_.tool)); }
    // The present middle, with the shifts of both hands.
    Vec3 middle_m() const { return hands_.pose.origin_m + shift_by_hand_m(); }

    // Handles the frame, named scales, pushing, turning, grabbing, and the keys of the simulated hand. Returns false if
    // the command belongs to another feature.
    bool act(Command command, double now_s);
    void publish(double now_s, PoseChange change);
    // The grab key is no longer down.
    void let_go() { hands_.tuning.workspace.grab_key = false; }
    // Another device is used: shifts by the old one are dropped.
    void take_hand();
    // The person's settings have changed.
    void take_settings(double now_s);
    // Changes scale, heading or the rendered scene through `change`. If that returns true, the place under the hand
    // stays there. A hand that would then be inside a solid is moved out.
    void change_under_hand(const std::function<bool()>& change, double now_s);

    // True while keys push it.
    bool pushed(double now_s) const { return push_way(now_s) != Vec3(0.0); }
    // Moves the workspace as the keys say; otherwise by carried_hand_m_per_s (device frame), if the hand is being
    // guided beyond its reach.
    void push(const Vec3& carried_hand_m_per_s, double now_s);
    // True if no tap of a pushing key is still acting.
    bool idle() const { return context_.tick_s >= push_until_s_; }
    // Call it once a tick, after walking. If a solid keeps the hand from following the walker, the hand is brought to
    // the walker with an announcement, and force ramps up from zero. Until then HandsState::left_behind is set. It does
    // nothing if the workspace is meant to be elsewhere: around the whole building, or at a fixed place.
    void stay_with_body(double now_s);
    // Announces when it has come to rest; plays a sound when it cannot move farther.
    void tell_motion(double now_s);
    // The hand feels what was made or found since, and is moved out of any solid that has appeared at its place.
    // quietly: simplifications are not announced.
    void take_touch(bool rooms_known, bool quietly, double now_s);
    // Another command was given, so the answer to the previous one is not continued.
    void note_command() { scale_asked_s_.reset(); }
    // Moves the workspace, because the device's hand itself cannot be moved, to the nearest place where the proxy fits.
    // Returns the distance in words; empty: the proxy fits already. middle_was_m: the workspace's middle when the
    // hand's position was measured. with_body: the walker has just been brought out of a solid too, which also frees a
    // hand that passes through its solid.
    std::string bring_out(const Vec3& middle_was_m, bool with_body, double now_s);

    // Moves the simulated hand's target, device frame; clamped to its reach.
    void move_hand(const Vec3& by_device_m);
    void move_hand_by_keys(double dt_s);
    const Vec3& hand_target_m() const { return hand_target_m_; }  // device frame

    // Set by the session; called once for each rest. Returns true if the workspace came to rest where the hand was
    // guided, so that nothing is announced.
    std::function<bool()> rests_untold;
    // Set by the session. True if that place is in the walker's room, as far as rooms are known.
    std::function<bool(const Vec3& place_m)> in_room_of_body;

private:
    Vec3 shift_of(const servo::ToolState& tool) const {
        return tool.workspace_jump == hands_.pose.jump ? tool.workspace_shift_m : Vec3(0.0);
    }
    // How far the hands themselves have moved the workspace since the last jump of the pose.
    Vec3 shift_by_hand_m() const { return shift_of(hands_.tool) + shift_of(hands_.left_tool); }
    servo::WorkspacePose pose_beside(const Vec3& others_shift_m) const;
    Vec3 origin_m() const;
    bool goes_with_body() const;
    bool body_sees(const Vec3& place_m) const;
    Vec3 hand_in_m(const Vec3& origin_m) const;
    Vec3 way_to_body_m() const;
    std::string bring_to_body(double now_s);
    void switch_frame(double now_s);
    void zoom(NamedScale scale, double now_s);
    void turn(double by_deg, double now_s);
    Vec3 push_way(double now_s) const;
    void bring_hands_out(double now_s);
    Vec3 hands_out_of_solids_m(const Vec3& origin_m) const;
    std::string words() const;

    HandsState& hands_;
    const HeldKeys& keys_;
    TouchView& touch_;
    Vec3 anchor_feet_m_{0.0};  // its place while it does not follow the walker
    // Shift since the workspace was last placed: by moving out of a solid, scrolling, or zooming under the hand. The
    // servo adds its own shift since the last jump.
    Vec3 shift_m_{0.0};
    Vec3 push_tap_{0.0};  // by a tap of a key: direction and end
    double push_until_s_ = -1.0;
    servo::WorkspaceMotion motion_told_ = servo::WorkspaceMotion::Still;
    std::optional<double> scale_asked_s_;  // the answer continues once the hand feels the new scale
    bool limit_told_ = false;
    Vec3 seen_from_m_{0.0};  // the feet when the walker last saw the hand
    double left_behind_s_ = 0.0;
    Vec3 hand_target_m_{0.0};
};

}  // namespace handrail::core
