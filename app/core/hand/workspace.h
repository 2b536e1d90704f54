// Controls the workspace of the hand in the world: its position, its scale and its orientation. This class also moves
// the simulated hand by keys. Use it on the app thread only. Lengths are in world metres, unless a name contains
// "device" or "hand".
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
// - Moved: the workspace jumps, beginning from where the hand had moved it.
// - Placed: the workspace returns to its place without shifts.
enum class PoseChange { Walked, Moved, Placed };

class Workspace : SessionPart {
public:
    // Writes the pose to `hands`, and changes the settings that determine the pose.
    Workspace(const SessionContext& context, HandsState& hands, const HeldKeys& keys, TouchView& touch)
        : SessionPart(context), hands_(hands), keys_(keys), touch_(touch) {}

    // Return the poses for the only or right hand, and for the left hand. Each servo adds the shift by its own hand.
    // These poses already contain the shift by the other hand.
    servo::WorkspacePose pose() const { return pose_next_to(shift_of(hands_.left_tool)); }
    servo::WorkspacePose left_pose() const { return pose_next_to(shift_of(hands_.tool)); }
    // Returns the present middle of the workspace, including the shifts by both hands.
    Vec3 middle_m() const { return hands_.pose.origin_m + shift_by_hand_m(); }

    // Carries out the commands for the frame, the named scales, pushing, turning and grabbing, and the keys of the
    // simulated hand. Returns false if the command belongs to another feature.
    bool act(Command command, double now_s);
    void publish(double now_s, PoseChange change);
    // Call it when the grab key is released.
    void let_go() { hands_.tuning.workspace.grab_key = false; }
    // Drops the shifts by the previous device. Call it when another device is used.
    void take_hand();
    // Applies the person's settings. Call it when they have changed.
    void take_settings(double now_s);
    // Calls `change`, which changes scale, heading or the rendered scene. If `change` returns true, the point of the
    // world under the hand stays under the hand. If the hand would then be inside a solid, it is moved out.
    void change_under_hand(const std::function<bool()>& change, double now_s);

    // Returns true while keys push the workspace.
    bool pushed(double now_s) const { return push_way(now_s) != Vec3(0.0); }
    // Moves the workspace while keys push it. If no key pushes it, moves it by the velocity `carried_hand_m_per_s` in
    // the device frame. That velocity is not zero if the guided hand must go beyond its reach.
    void push(const Vec3& carried_hand_m_per_s, double now_s);
    // Returns true if no tap of a pushing key is still moving the workspace.
    bool idle() const { return context_.tick_s >= push_until_s_; }
    // If a solid keeps the hand from following the walker, brings the workspace to the walker, announces that, and lets
    // the force rise from zero. Until then, HandsState::left_behind is set. Does nothing if the workspace does not
    // follow the walker: around the whole building, or at a fixed place. Call this function once a tick, after walking.
    void stay_with_walker(double now_s);
    // Announces where the workspace has come to rest. Plays a sound when the workspace cannot move farther.
    void announce_motion(double now_s);
    // Renders the scene that a background task has made, and moves the hand out of any solid that has appeared at its
    // place. `quietly`: simplifications are not announced.
    void take_touch(bool rooms_known, bool quietly, double now_s);
    // Ends the announcement of the last change of scale, so that the answer is not continued. Call this function for
    // each command that other features carry out.
    void note_command() { scale_requested_s_.reset(); }
    // Moves the workspace to the nearest place where the proxy fits, because nothing can move the hand on the device.
    // Returns the distance in words, or an empty text if the proxy already fits. `middle_was_m` is the middle of the
    // workspace when the hand's position was measured. `with_walker` is true if the walker has just been brought out of
    // a solid too. The hand is then freed even if it began inside a solid.
    std::string bring_out(const Vec3& middle_was_m, bool with_walker, double now_s);

    // Moves the target of the simulated hand by a vector in the device frame. The target stays within the hand's reach.
    void move_hand(const Vec3& by_device_m);
    void move_hand_by_keys(double dt_s);
    // Returns the target of the simulated hand in the device frame.
    const Vec3& hand_target_m() const { return hand_target_m_; }

    // The session sets this function. It is called once each time the workspace comes to rest. It returns true if
    // guidance of the hand has brought the workspace there, so that nothing is announced.
    std::function<bool()> rests_silently;
    // The session sets this function. It returns true if the place is in the walker's room, as far as the rooms are
    // known.
    std::function<bool(const Vec3& place_m)> in_room_of_walker;

private:
    Vec3 shift_of(const servo::ToolState& tool) const {
        return tool.workspace_jump == hands_.pose.jump ? tool.workspace_shift_m : Vec3(0.0);
    }
    // Returns how far the hands themselves have moved the workspace since the last jump of the pose.
    Vec3 shift_by_hand_m() const { return shift_of(hands_.tool) + shift_of(hands_.left_tool); }
    servo::WorkspacePose pose_next_to(const Vec3& others_shift_m) const;
    Vec3 origin_m() const;
    bool goes_with_walker() const;
    bool walker_sees(const Vec3& place_m) const;
    Vec3 hand_in_m(const Vec3& origin_m) const;
    Vec3 shift_to_walker_m() const;
    std::string bring_to_walker(double now_s);
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
    // Position of the workspace while it does not follow the walker; like the position of a walker's feet, at floor
    // level.
    Vec3 anchor_feet_m_{0.0};
    // Shift of the workspace since it was last placed, caused by moving out of a solid, by pushing, or by zooming under
    // the hand. The servo adds its own shift since the last jump.
    Vec3 shift_m_{0.0};
    Vec3 push_tap_{0.0};  // direction in which the last tap of a key pushes the workspace, until push_until_s_
    double push_until_s_ = -1.0;
    servo::WorkspaceMotion motion_announced_ = servo::WorkspaceMotion::Still;
    // Time of the last change of scale. Its announcement continues once the hand feels the new scale.
    std::optional<double> scale_requested_s_;
    bool limit_announced_ = false;
    Vec3 seen_from_m_{0.0};  // position of the walker's feet when the walker last saw the hand
    double left_behind_s_ = 0.0;
    Vec3 hand_target_m_{0.0};
};

}  // namespace handrail::core
