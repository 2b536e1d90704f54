// One millisecond of the hand: sample checks, workspace map, touch, faults, ForceLimiter. Plain function over plain
// state, the same in the servo thread, in scenarios and in tests. Never allocates, locks, throws, logs or reads a
// clock.
#pragma once

#include <cstdint>

#include "haptic/device/haptic_device.h"
#include "haptic/render/force_limiter.h"
#include "haptic/render/touch.h"
#include "haptic/servo/body_playback.h"
#include "haptic/servo/contact_tracker.h"
#include "haptic/servo/guidance.h"
#include "haptic/servo/hand_engine.h"
#include "haptic/servo/heat_budget.h"
#include "haptic/servo/personal_space.h"
#include "haptic/servo/rate_watch.h"
#include "haptic/servo/workspace_map.h"
#include "haptic/servo/workspace_mover.h"
#include "worlds/base/vec.h"

namespace handrail {

struct ServoTuning {
    // touch.rated_stiffness_n_per_m is what is asked for; the servo lowers it to effective_stiffness_n_per_m at the
    // measured rate. A change of touch.world_m_per_hand_m is met like a jump of the workspace.
    TouchTuning touch;
    double force_ceiling_n = 2.5;  // chosen by the person; the device's peak always holds too
    bool forces_on = true;         // f key: ramps up over 1 s, fades away over 75 ms
    bool panic = false;            // F12: zero on this very tick, until cleared
    bool focused = true;  // the window has the keyboard; without it the force fades over 75 ms and ramps up with it
    // Dead-man mode: force only while a button of the device is held; released, it fades over 75 ms.
    bool button_to_feel = false;
    std::uint32_t stops_let_go = 0;  // the count of ServoSwitches::stops up to which the person wants the force back
    std::uint32_t confirm = 0;       // a new number lets a latched fault go (ramp of 1 s), if its cause is gone
    WorkspaceTuning workspace;
    // The wall towards the body is there, and the desk behind it; without it the tick pays one comparison.
    bool personal_space = false;
    BodyTuning bodies;  // counts only where the world has free ones
};

// At the desk: what the hand does there. Device frame, since the desk stands still before the person.
struct DeskTouch {
    // The hand is at the desk; hip_m and proxy_m of ToolState then tell where in the world it comes back to.
    bool open = false;
    std::uint32_t visits = 0;  // how often it went there
    Vec3 hip_m{0.0}, proxy_m{0.0};
    FeatureId touched = kNoFeature;  // of the desk's scene
    FeatureId held = kNoFeature;     // pressed, by a push or the device's button
    std::uint32_t presses = 0;       // begun since the start
    double press_n = 0.0;            // of the contact, before any ceiling
};

// What the app and ears may know of the hand; published each tick.
struct ToolState {
    double time_s = 0.0;
    Vec3 hip_m{0.0}, proxy_m{0.0};  // world
    Vec3 hand_m{0.0};               // device frame, the last good sample
    double ball_radius_m = 0.0;
    Vec3 force_n{0.0};        // commanded, world axes, after the limiter
    double force_gain = 0.0;  // ramp, 0 to 1
    ContactSet contacts;
    FeatureId soft = kNoFeature;  // what gives way under the hand
    double soft_n = 0.0;          // with that force, before any ceiling; 0: nothing does
    double contact_n = 0.0;       // of the contacts, likewise
    FeatureId liquid = kNoFeature;
    std::uint32_t buttons = 0;
    Vec3 gimbal_rad{0.0};         // of the grip, where the device has them
    std::uint8_t homed_legs = 0;  // as DeviceSample has it
    Fault fault = Fault::None;    // latched or present
    bool fault_latched = false;   // needs a new ServoTuning::confirm
    bool fault_lasts = false;     // its cause is still there: a confirmation would be in vain
    Fault pause = Fault::None;    // FocusLost or ButtonReleased: why the force waits though nothing is wrong
    double warmth = 0.0;          // of the motors by the heat budget; at 1 the force is taken away
    // No force until the hand has moved by 3 mm (since the start, or since it was plugged in again).
    bool waiting_for_hand = true;
    double contact_s = 0.0;  // contact time since start (break hint)
    std::uint64_t ticks = 0;
    double rate_hz = 0.0;  // measured over the last second; 0 during the first
    std::uint32_t scene_generation = 0, scene_world = 0;
    // How the hand has moved its workspace since the pose's last jump, and that jump's number.
    WorkspaceMotion workspace_motion = WorkspaceMotion::Still;
    bool workspace_at_limit = false;
    Vec3 workspace_shift_m{0.0};
    std::uint32_t workspace_jump = 0;
    DeskTouch desk;
    GuidanceState guidance;
    std::uint32_t holds = kNoBody;  // a free body that the hand holds; place in DynamicsScene::bodies
    std::uint32_t heavy = kNoBody;  // one that was pushed or lifted with all there is and did not move, the last
    std::uint32_t heavies = 0;      // how often that was so since the start

    // Something holds the hand, or gives way under it.
    bool touches() const noexcept { return contacts.count > 0 || soft_n > 0.0; }
    // What pushes back hardest; kNoFeature where nothing does, or what does has no name.
    FeatureId touched() const noexcept {
        if (soft_n > 0.0 && (contacts.count == 0 || soft_n > contact_n)) return soft;
        return contacts.count > 0 ? contacts.contacts[contacts.strongest].feature : kNoFeature;
    }
    void touch_nothing() noexcept {
        contacts = {};
        soft_n = contact_n = 0.0;
    }
};

// Counted since the start.
struct ServoCounters {
    PeriodHistogram periods;
    std::uint64_t bad_samples = 0;  // not finite, out of reach, or jumped
    std::uint64_t held_gaps = 0;    // 5 to 25 ms without a tick or an answer: the force was held and resumed
    std::uint64_t long_gaps = 0;    // longer: zero and a ramp
    std::uint64_t lost_events = 0;
    std::uint64_t waits = 0;  // ticks that had more to do than their budget of work (ContactSet::waits)
};

// What one tick is given. Nothing is kept beyond the tick.
struct TickInputs {
    const HapticScene* scene = nullptr;  // null: there is none yet, so no contact and no force
    const ServoTuning& tuning;
    const WorkspacePose& pose;  // the newest that is known; the same as before is fine
    const DeviceSample& sample;
    double now_s = 0.0;                 // by the clock of WorkspacePose::time_s; ticks come in rising time
    const BodyFrame* bodies = nullptr;  // the newest that is known; null: the scene's bodies stand where it has them
    const HapticScene* desk = nullptr;  // behind the wall of ServoTuning::personal_space, device frame; null: none
    const GuidancePath* guidance = nullptr;  // the newest that is known; null or number 0: none
    HandEngine* engine = nullptr;            // this hand's side of the scene's free bodies; null: there are none
};

// Everything that lives from tick to tick. Allocates when created; then owned by one thread.
class ServoState {
public:
    static constexpr double kJumpM = 0.020;  // farthest hand travel from one tick to the next
    static constexpr int kBadSamplesLatch = 3;
    static constexpr double kFirstMovementM = 0.003;
    static constexpr double kShortGapS = 0.005;  // below: ordinary jitter of a thread
    static constexpr double kLongGapS = 0.025;

    explicit ServoState(const DeviceSpec& spec);

    const DeviceSpec& spec() const noexcept { return spec_; }
    const ToolState& tool() const noexcept { return tool_; }
    const TickEvents& events() const noexcept { return events_; }  // of the last tick
    const ServoCounters& counters() const noexcept { return counters_; }

private:
    friend ForceCommand servo_tick(ServoState& state, const TickInputs& given) noexcept;

    enum class Answer { None, Bad, Good };

    void measure_rate(double dt_s) noexcept;
    void raise(Fault fault, bool latched) noexcept;
    void lose_device() noexcept;
    void watch_pauses(const ServoTuning& tuning) noexcept;
    bool cause_lasts(const DeviceSample& sample) const noexcept;
    void clear_fault() noexcept;
    void confirm(const DeviceSample& sample, std::uint32_t number) noexcept;
    void start_over() noexcept;
    void lose_time() noexcept;
    void move_workspace(WorkspaceFrame& frame, const ServoTuning& tuning, std::uint32_t buttons, double scale,
                        double dt_s) noexcept;
    Answer judge(const DeviceSample& sample, const WorkspaceFrame& frame, double scale, double dt_s) noexcept;
    // Twice, so that a world in which nothing is free pays nothing.
    template <bool kFree>
    void touch(const HapticScene& scene, const ServoTuning& tuning, const WorkspaceFrame& frame, const Vec3& goal_m,
               double dt_s, const BodyPoses& bodies, HandEngine* engine) noexcept;
    void move_bodies(HandEngine& engine, bool met, bool silent, const Vec3& force_n, double dt_s) noexcept;
    BodyFeel body_feel(const ServoTuning& tuning, const TouchTuning& touch) const noexcept;
    double ceiling_n(const ServoTuning& tuning) const noexcept;
    TouchTuning tuned(const ServoTuning& tuning) const noexcept;
    void meet_wall(const HapticScene* desk, const ServoTuning& tuning, WorkspaceFrame& frame, double scale,
                   double dt_s) noexcept;
    void sit_down() noexcept;
    void stand_up() noexcept;
    void touch_desk(const HapticScene& desk, const ServoTuning& tuning, double dt_s) noexcept;
    void guide(const GuidancePath& path, const WorkspaceFrame& frame, double scale, bool allowed, double dt_s) noexcept;
    ForceFlow flow(const ServoTuning& tuning, bool scene_present, bool long_gap, double& fade_s) const noexcept;

    DeviceSpec spec_;
    TouchState touch_;
    ForceLimiter limiter_;
    PosePlayback playback_;
    WorkspaceMover mover_;
    PersonalSpace space_;
    PullThrough pull_through_;
    Vec3 held_n_{0.0};  // device frame, by what the hand touches in the world
    LeftoverForce leftover_;
    DeskPress press_;
    TouchState desk_touch_;
    Vec3 met_m_{0.0};  // device frame, where the hand was when the wall was met last
    bool met_ = false;
    BodyPlayback bodies_;
    ContactTracker tracker_;
    Guidance guidance_;
    RateWatch rate_watch_;
    HeatBudget heat_;
    TickEvents events_;
    ToolState tool_;
    ServoCounters counters_;

    Fault fault_ = Fault::None;
    bool fault_latched_ = false;
    bool place_lost_ = false;      // by the fault: what was felt before it does not hold any more
    bool pause_told_ = false;      // tool_.pause took a force away, so its end is told too
    double window_start_s_ = 0.0;  // of the rate measurement
    std::uint64_t window_ticks_ = 0;
    double mean_period_s_ = 1e-3;  // between device answers, one pole of 1 s
    double since_answer_s_ = 0.0;
    double since_touch_s_ = 0.0;
    double keep_off_s_ = 0.0;  // no force for so long yet: stalls came again during the ramp
    double scale_ = 0.0;       // world metres per hand metre of the last tick
    std::uint32_t confirm_seen_ = 0;
    int bad_run_ = 0;  // bad answers in a row
    Fault bad_kind_ = Fault::None;
    bool connected_ = false;
    bool trusts_last_ = false;  // tool_.hand_m is a place the next sample must be near
    bool has_first_ = false;
    Vec3 first_m_{0.0};  // where the hand was when it was first seen
    double hurry_s_ = ForceLimiter::kFadeS;
    Vec3 wanted_n_{0.0};  // device frame, before the limiter; held while the device is silent
    bool goal_known_ = false;
    Vec3 goal_m_{0.0};
    Vec3 hand_at_goal_m_{0.0};    // device frame, where the hand was when the goal was goal_m_
    Vec3 velocity_m_per_s_{0.0};  // hand metres, world axes, one pole at 50 Hz
};

// One tick. Numbered stages stand in the source. Servo thread; never allocates, locks, throws or reads a clock.
ForceCommand servo_tick(ServoState& state, const TickInputs& given) noexcept;

}  // namespace handrail
