// Where the hand's workspace lies in the world, how large it is and which way it looks; and the simulated hand that
// keys move in it. App thread only; world metres, unless a name says device or hand.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/dialogue/held_keys.h"
#include "app/core/hand/touch_view.h"

namespace handrail {

// Walked: the body may have gone a little way. Moved: the workspace jumps, from where the hand had moved it to. Placed:
// it is where it belongs again.
enum class PoseChange { Walked, Moved, Placed };

class Workspace : SessionPart {
public:
    // It lays the pose of `hands`, and changes the person's settings by which it lies.
    Workspace(const SessionContext& context, HandsState& hands, const HeldKeys& keys, TouchView& touch)
        : SessionPart(context), hands_(hands), keys_(keys), touch_(touch) {}

    // Of the only or right hand, and of the left one: each servo lays its own hand's shift on its pose; the other
    // hand's comes with it.
    WorkspacePose pose() const { return pose_beside(shift_of(hands_.left_tool)); }
    WorkspacePose left_pose() const { return pose_beside(shift_of(hands_.tool)); }
    // Its middle now, with what the hands have moved it by.
    Vec3 middle_m() const { return hands_.pose.origin_m + shift_by_hand_m(); }

    // Its frame, named scales, pushing, turning, grabbing, and the keys of the simulated hand. False: it is another's.
    bool act(Command command, double now_s);
    void publish(double now_s, PoseChange change);
    // The grab key is not down any more.
    void let_go() { hands_.tuning.workspace.grab_key = false; }
    // Another device: what moved the old one counts for nothing.
    void take_hand();
    // The person's settings are others.
    void take_settings(double now_s);
    // Changes scale, heading or what is felt so that the place under the hand stays there, where `change` says that it
    // shall; out of whatever the hand would be inside.
    void change_under_hand(const std::function<bool()>& change, double now_s);

    // Keys push it now.
    bool pushed(double now_s) const { return push_way(now_s) != Vec3(0.0); }
    // As the keys say; else by carried_hand_m_per_s (device frame), where the hand is led out of its reach.
    void push(const Vec3& carried_hand_m_per_s, double now_s);
    // No tap of a key that pushes it is still at work.
    bool idle() const { return context_.tick_s >= push_until_s_; }
    // Once a tick, after the body has walked: a hand that something solid keeps from going with the body is brought to
    // it, with a word and force that ramps in from zero. Until then HandsState::left_behind says so. Not where the
    // workspace is meant to be elsewhere: round the whole building, or staying where it is.
    void stay_with_body(double now_s);
    // Tells when it has come to rest, and when it can go no farther.
    void tell_motion(double now_s);
    // The hand feels what was made or found out since, and is brought out of what has come to be where it is.
    // quietly: without a word about what is simplified.
    void take_touch(bool rooms_known, bool quietly, double now_s);
    // Another command: the answer to the one before does not go on any more.
    void note_command() { scale_asked_s_.reset(); }
    // The hand cannot be moved, so the workspace is: to where the ball fits, as near as there is room. Says how far;
    // empty: it fits already. middle_was_m: of the workspace when the hand told where it is. with_body: the body has
    // just been brought out of something too, which brings out a hand that goes through what it is in.
    std::string bring_out(const Vec3& middle_was_m, bool with_body, double now_s);

    // Moves the simulated hand's target, device frame; clamped to its reach.
    void move_hand(const Vec3& by_device_m);
    void move_hand_by_keys(double dt_s);
    const Vec3& hand_target_m() const { return hand_target_m_; }  // device frame

    // Set by the session: it has come to rest where the hand was led, so nothing is told of it; asked once for each
    // rest.
    std::function<bool()> rests_untold;
    // Set by the session: that place is in the room that the body is in, as far as rooms are known.
    std::function<bool(const Vec3& place_m)> in_room_of_body;

private:
    Vec3 shift_of(const ToolState& tool) const {
        return tool.workspace_jump == hands_.pose.jump ? tool.workspace_shift_m : Vec3(0.0);
    }
    // How the hands themselves have moved the workspace since the pose's last jump.
    Vec3 shift_by_hand_m() const { return shift_of(hands_.tool) + shift_of(hands_.left_tool); }
    WorkspacePose pose_beside(const Vec3& others_shift_m) const;
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
    Vec3 anchor_feet_m_{0.0};  // where it stays while it does not follow the body
    // On top of which the servo lays its own since the last jump: brought out of something, scrolled, zoomed under the
    // hand; until it is put elsewhere.
    Vec3 shift_m_{0.0};
    Vec3 push_tap_{0.0};  // by a tap of a key: which way and until when
    double push_until_s_ = -1.0;
    WorkspaceMotion motion_told_ = WorkspaceMotion::Still;
    std::optional<double> scale_asked_s_;  // its answer goes on once the hand feels the scale
    bool limit_told_ = false;
    Vec3 seen_from_m_{0.0};  // the feet, when the body was in sight of the hand last
    double left_behind_s_ = 0.0;
    Vec3 hand_target_m_{0.0};
};

}  // namespace handrail
