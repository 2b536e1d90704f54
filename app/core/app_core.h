// The session: where one is in the world, what a command does, what is published to servo, ears and window. No window, device or sound
// library, no thread, no clock of its own: the caller ticks it about 60 times a second and carries its outputs. App thread only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/core/command.h"
#include "app/core/key_map.h"
#include "app/core/placed_things.h"
#include "app/core/surroundings.h"
#include "app/core/view.h"
#include "app/core/walker.h"
#include "app/core/words.h"
#include "audio-cues/plan/cue_planner.h"
#include "haptic/compile/compile_haptic.h"
#include "haptic/servo/servo_tick.h"
#include "settings/settings.h"

namespace handrail {

// What the hand has: none, or a device of which the workspace size, force and stiffness count.
struct HandFacts {
    bool present = false;
    bool simulated = false;
    DeviceSpec spec{};
};

class AppCore {
public:
    AppCore(const Settings& settings, const HandFacts& hand);

    // Puts the body at the base (or first) start of the scene and says where one is.
    void enter_world(std::shared_ptr<const Scene> scene, double now_s);
    // The same, at a place and heading of the caller's choice.
    void enter_world_at(std::shared_ptr<const Scene> scene, const Vec3& feet_m, double heading_rad, double now_s);

    // Puts the body somewhere else in this world; the workspace jumps with it.
    void place(const Vec3& feet_m, double heading_rad, double now_s);
    // Sets a thing down, takes it away or sends it elsewhere while everything goes on: touched, it neither knocks nor leaks. Each fails with a
    // sentence and changes nothing: see worlds/scene/models.h; too many things at once; a speed that is not above zero. Walking meets a thing where it
    // last stood still.
    Result<void> add_thing(const std::string& name, std::shared_ptr<const Scene> model, const Placement& at, const std::string& material, double now_s);
    Result<void> remove_thing(const std::string& name, double now_s);
    Result<void> send_thing(const std::string& name, const Placement& to, double speed_m_per_s);
    // Where the thing of that name is now; none of that name: nothing.
    std::optional<Placement> thing_at(const std::string& name) const;

    // New settings from outside; the world stays. Force ramps in again where the workspace changes.
    void change_settings(const Settings& settings, double now_s);

    void press(Command command, double now_s);
    void release(Command command);
    // The window lost or regained the keyboard: nothing stays held and force fades away while it is lost.
    void set_focus(bool focused);
    // Moves the simulated hand's target, device frame; clamped to its reach.
    void move_hand(const Vec3& by_device_m);
    // A sentence from outside (problems while loading, device news).
    void say(std::string text, SpeechClass speech_class, double now_s);

    // now_s never goes back; steps over 0.1 s are cut to 0.1 s of walking.
    void tick(double now_s, const ToolState& tool);

    // What others take after each tick.
    std::shared_ptr<const Scene> scene() const { return scene_; }
    std::shared_ptr<const HapticScene> haptic_scene() const { return haptic_scene_; }
    // Rises when another world was entered; scene() may be another one without that, when something was added, moved or removed.
    int worlds_entered() const { return worlds_entered_; }
    const WorkspacePose& pose() const { return pose_; }
    const BodyFrame& bodies() const { return things_.frame(); }
    const ServoTuning& tuning() const { return tuning_; }
    const Vec3& hand_target_m() const { return hand_target_m_; }  // device frame
    Listener listener() const;
    std::vector<CueRequest> take_cues() { return std::exchange(cues_, {}); }
    // Settings the person changed by a command, to be stored and saved: key and value.
    std::vector<std::pair<std::string, std::string>> take_setting_changes() { return std::exchange(setting_changes_, {}); }
    const Settings& settings() const { return settings_; }
    ViewState view(const ToolState& tool, const std::string& last_spoken) const;
    const KeyMap& keys() const { return keys_; }
    // Nothing is on its way any more: no steps pending, no turn unfinished, nothing held.
    bool idle() const;
    bool wants_to_leave() const { return wants_to_leave_; }
    const Vec3& feet_m() const { return walker_->state().feet_m; }
    bool standing() const { return walker_->state().on_ground; }
    double heading_rad() const { return heading_rad_; }

    // The answer to "where am I", also used on entering.
    std::string where_am_i() const;

private:
    void lay_device_overrides();
    void retune();
    void act(Command command, double now_s);
    void walk(double now_s, double dt_s);
    void turn(double dt_s);
    void move_hand_by_keys(double dt_s);
    void notice_volumes(double now_s);
    void tone_of_walls(double now_s);
    void publish_pose(double now_s, bool jump);
    void cue(CueRequest request) { cues_.push_back(std::move(request)); }
    void answer(std::string text, double now_s);
    void toggle_forces(double now_s);
    void describe_touched(double now_s);
    void go_home(double now_s);
    void bring_out(double now_s);
    void change_world(Scene scene, double now_s);
    void rebuild_body_world();
    Scene world_now() const;
    std::string help_text() const;
    std::string entering_text() const;
    std::string name_of(FeatureId feature) const;
    DistanceWords distances() const { return {settings_.speech.distances_in_steps, settings_.walk.step_length_m}; }
    bool held(Command command) const { return held_[static_cast<std::size_t>(command)]; }

    Settings settings_;
    HandFacts hand_;
    KeyMap keys_;
    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const HapticScene> haptic_scene_;
    int worlds_entered_ = 0;
    PlacedThings things_;
    std::unique_ptr<BodyWorld> body_world_;
    std::unique_ptr<Walker> walker_;
    Vec3 home_feet_m_{0.0};
    double home_heading_rad_ = 0.0;

    double heading_rad_ = 0.0;       // where the body faces now
    double heading_goal_rad_ = 0.0;  // where the last turn key leads; reached at a bounded rate, so that the hand is not thrown
    double tilt_rad_ = 0.0;
    double pending_way_m_ = 0.0;  // of taps, positive ahead; walked even when the key is up again
    double since_footstep_m_ = 0.0;
    bool blocked_ = false;  // a bump was told and the body has not got away since
    std::vector<bool> held_;
    double last_turn_repeat_s_ = 0.0;
    Vec3 hand_shift_m_{0.0};  // of the workspace, world metres: brought out of something; until one is put elsewhere
    WorkspacePose pose_;
    ServoTuning tuning_;
    Vec3 hand_target_m_{0.0};
    std::vector<CueRequest> cues_;
    std::vector<std::pair<std::string, std::string>> setting_changes_;
    std::vector<FeatureId> inside_;         // volumes the body is in
    std::vector<FeatureId> told_triggers_;  // each trigger speaks once
    std::vector<Vec3> path_m_;
    ToolState tool_;
    double last_tick_s_ = -1.0;
    double leave_asked_s_ = -1e9;
    double breaks_told_ = 0.0;
    double tone_loudness_ = 0.0;
    FeatureId described_ = kNoFeature;  // what "what is this" last told of
    bool plan_view_ = false;
    bool wants_to_leave_ = false;
    bool forces_wanted_ = true;  // the f key; tuning_.forces_on is this and the focus
    bool focused_ = true;
};

}  // namespace handrail
