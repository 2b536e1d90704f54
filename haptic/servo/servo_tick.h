// Computes one millisecond of the hand: sample checks, workspace map, touch, faults, ForceLimiter. servo_tick() is a
// plain function over plain state, which the servo thread, scenarios and tests all use. Never allocates, locks, throws,
// logs or reads a clock.
#pragma once

#include <cstdint>

#include "haptic/device/haptic_device.h"
#include "haptic/render/force_limiter.h"
#include "haptic/render/touch.h"
#include "haptic/servo/body_playback.h"
#include "haptic/servo/contact_tracker.h"
#include "haptic/servo/guidance.h"
#include "haptic/servo/hand_body_servo.h"
#include "haptic/servo/heat_budget.h"
#include "haptic/servo/personal_space.h"
#include "haptic/servo/rate_watch.h"
#include "haptic/servo/workspace_map.h"
#include "haptic/servo/workspace_mover.h"
#include "worlds/base/vec.h"

namespace handrail::servo {

struct ServoTuning {
    // Settings of the renderer. touch.rated_stiffness_n_per_m is the requested stiffness; the servo reduces it to
    // effective_stiffness_n_per_m() at the measured rate. A change of touch.world_m_per_hand_m has the effect of a jump
    // of the workspace.
    render::TouchTuning touch;
    double force_ceiling_n = 2.5;  // ceiling that the person chose; the device's peak force is a limit too
    bool forces_on = true;         // set by the f key: true ramps the force in over 1 s, false fades it out over 75 ms
    bool panic = false;            // set by F12: zero force in this very tick, until cleared
    // True while the window has the keyboard focus. When the window loses the focus, the force fades out over 75 ms;
    // when the focus returns, the force ramps in.
    bool focused = true;
    // Dead-man mode: there is force only while a button of the device is held. When the button is released, the force
    // fades out over 75 ms.
    bool button_to_feel = false;
    // The number of stops (ServoSwitches::stops) up to which the person has restored the force.
    std::uint32_t stops_let_go = 0;
    // A new number clears a latched fault if its cause has ended. The force then ramps in over 1 s.
    std::uint32_t confirm = 0;
    WorkspaceTuning workspace;
    // Enables the wall towards the person's body and the desk behind it. If it is false, the tick costs one comparison.
    bool personal_space = false;
    BodyTuning bodies;  // used only in a world with free bodies
};

// State of the hand at the desk, in the device frame, because the desk does not move relative to the person.
struct DeskTouch {
    // True if the hand is at the desk. The hip_m and proxy_m of ToolState are then the places in the world to which the
    // hand returns.
    bool open = false;
    std::uint32_t visits = 0;  // number of visits to the desk
    Vec3 hip_m{0.0}, proxy_m{0.0};
    FeatureId touched = kNoFeature;  // touched feature of the desk's scene
    FeatureId held = kNoFeature;     // the feature that the hand presses, by a push or the device's button
    std::uint32_t presses = 0;       // number of presses since the start
    double press_n = 0.0;            // force of the hand against the touched object, before any ceiling
};

// State of the hand for the app and the audio thread, published in each tick.
struct ToolState {
    double time_s = 0.0;
    Vec3 hip_m{0.0}, proxy_m{0.0};  // positions in the world
    Vec3 hand_m{0.0};               // position of the hand in the last good sample, device frame
    double proxy_radius_m = 0.0;
    Vec3 force_n{0.0};        // commanded force after the limiter, world axes
    double force_gain = 0.0;  // gain of the ramp, 0 to 1
    render::ContactSet contacts;
    FeatureId soft = kNoFeature;  // the soft feature that yields to the hand
    double soft_n = 0.0;          // force of that soft feature, before any ceiling; 0 if there is none
    double contact_n = 0.0;       // force of the surfaces on the hand, before any ceiling
    FeatureId liquid = kNoFeature;
    std::uint32_t buttons = 0;
    Vec3 gimbal_rad{0.0};         // angles of the grip, if the device measures them
    std::uint8_t homed_legs = 0;  // see DeviceSample::homed_legs
    Fault fault = Fault::None;    // the fault that is latched or present now
    bool fault_latched = false;   // the fault is cleared only by a new ServoTuning::confirm
    bool fault_lasts = false;     // the cause of the fault persists, so a confirmation would have no effect
    Fault pause = Fault::None;    // FocusLost or ButtonReleased if the force pauses although nothing is wrong
    double warmth = 0.0;          // warmth of the motors by the heat budget; at 1 the force fades out
    // There is no force until the hand has moved by 3 mm, after the start or after the device was plugged in again.
    bool waiting_for_hand = true;
    double contact_s = 0.0;  // total time of contact since the start; used for the hint to take a break
    std::uint64_t ticks = 0;
    double rate_hz = 0.0;  // ticks per second, measured over the last second; 0 during the first second
    std::uint32_t scene_generation = 0, scene_world = 0;
    // How the hand has moved its workspace since the last jump of the pose, and the number of that jump.
    WorkspaceMotion workspace_motion = WorkspaceMotion::Still;
    bool workspace_at_limit = false;
    Vec3 workspace_shift_m{0.0};
    std::uint32_t workspace_jump = 0;
    DeskTouch desk;
    GuidanceState guidance;
    std::uint32_t holds = render::kNoBody;  // the free body that the hand holds; index in DynamicsScene::bodies
    std::uint32_t heavy =
        // The last body that did not move although the hand pushed or lifted it with all available force.
        render::kNoBody;
    std::uint32_t heavies = 0;  // number of bodies that were reported in this way since the start

    // Returns true if a surface resists the hand or yields to it.
    bool touches() const noexcept { return contacts.count > 0 || soft_n > 0.0; }
    // Returns the feature that pushes back hardest. Returns kNoFeature if nothing pushes back, or if that surface has
    // no name.
    FeatureId touched() const noexcept {
        if (soft_n > 0.0 && (contacts.count == 0 || soft_n > contact_n)) return soft;
        return contacts.count > 0 ? contacts.contacts[contacts.strongest].feature : kNoFeature;
    }
    void touch_nothing() noexcept {
        contacts = {};
        soft_n = contact_n = 0.0;
    }
};

// Counts since the start.
struct ServoCounters {
    PeriodHistogram periods;
    std::uint64_t bad_samples = 0;  // samples that were not finite, were out of reach or had jumped
    // Number of gaps of 5 to 25 ms without a tick or an answer, over which the motors held the force.
    std::uint64_t held_gaps = 0;
    std::uint64_t long_gaps = 0;  // number of longer gaps, after which the force was zero and then ramped in
    std::uint64_t lost_events = 0;
    std::uint64_t waits = 0;  // ticks with more work than their budget (ContactSet::waits)
};

// The inputs of one tick. The servo keeps no reference to them after the tick.
struct TickInputs {
    const render::HapticScene* scene = nullptr;  // null: no scene yet, so no contact and no force
    const ServoTuning& tuning;
    const WorkspacePose& pose;  // the newest known pose; may be the same as in the last tick
    const device::DeviceSample& sample;
    double now_s = 0.0;  // time of the tick, by the clock of WorkspacePose::time_s; rises from tick to tick
    const BodyFrame* bodies = nullptr;  // the newest known frame; null: each body has its pose from the scene
    const render::HapticScene* desk =
        nullptr;  // scene of the desk, behind the wall of ServoTuning::personal_space; device frame; null: none
    const GuidancePath* guidance = nullptr;  // the newest known path; null or number 0: no guidance
    HandBodyServo* engine = nullptr;         // this hand's data for the scene's free bodies; null: there are none
};

// All state of the servo that lasts from tick to tick. It allocates when it is created; after that one thread owns it.
class ServoState {
public:
    static constexpr double kJumpM = 0.020;  // greatest distance that a hand can move from one tick to the next
    static constexpr int kBadSamplesLatch = 3;
    static constexpr double kFirstMovementM = 0.003;
    static constexpr double kShortGapS = 0.005;  // shorter gaps are treated as thread jitter
    static constexpr double kLongGapS = 0.025;

    explicit ServoState(const device::DeviceSpec& spec);

    const device::DeviceSpec& spec() const noexcept { return spec_; }
    const ToolState& tool() const noexcept { return tool_; }
    const TickEvents& events() const noexcept { return events_; }  // events of the last tick
    const ServoCounters& counters() const noexcept { return counters_; }

private:
    friend device::ForceCommand servo_tick(ServoState& state, const TickInputs& given) noexcept;

    enum class Answer { None, Bad, Good };

    void measure_rate(double dt_s) noexcept;
    void raise(Fault fault, bool latched) noexcept;
    void lose_device() noexcept;
    void watch_pauses(const ServoTuning& tuning) noexcept;
    bool cause_lasts(const device::DeviceSample& sample) const noexcept;
    void clear_fault() noexcept;
    void confirm(const device::DeviceSample& sample, std::uint32_t number) noexcept;
    void start_over() noexcept;
    void lose_time() noexcept;
    void move_workspace(WorkspaceFrame& frame, const ServoTuning& tuning, std::uint32_t buttons, double scale,
                        double dt_s) noexcept;
    Answer judge(const device::DeviceSample& sample, const WorkspaceFrame& frame, double scale, double dt_s) noexcept;
    // Compiled in two versions, so that a world without free bodies has no cost for them.
    template <bool kFree>
    void touch(const render::HapticScene& scene, const ServoTuning& tuning, const WorkspaceFrame& frame,
               const Vec3& goal_m, double dt_s, const render::BodyPoses& bodies, HandBodyServo* engine) noexcept;
    void move_bodies(HandBodyServo& engine, bool met, bool silent, const Vec3& force_n, double dt_s) noexcept;
    BodyFeel body_feel(const ServoTuning& tuning, const render::TouchTuning& touch) const noexcept;
    double ceiling_n(const ServoTuning& tuning) const noexcept;
    render::TouchTuning tuned(const ServoTuning& tuning) const noexcept;
    void meet_wall(const render::HapticScene* desk, const ServoTuning& tuning, WorkspaceFrame& frame, double scale,
                   double dt_s) noexcept;
    void sit_down() noexcept;
    void stand_up() noexcept;
    void touch_desk(const render::HapticScene& desk, const ServoTuning& tuning, double dt_s) noexcept;
    void guide(const GuidancePath& path, const WorkspaceFrame& frame, double scale, bool allowed, double dt_s) noexcept;
    render::ForceFlow flow(const ServoTuning& tuning, bool scene_present, bool long_gap, double& fade_s) const noexcept;

    device::DeviceSpec spec_;
    render::TouchState touch_;
    render::ForceLimiter limiter_;
    PosePlayback playback_;
    WorkspaceMover mover_;
    PersonalSpace space_;
    PullThrough pull_through_;
    Vec3 held_n_{0.0};  // force of the touched surfaces of the world, device frame
    LeftoverForce leftover_;
    DeskPress press_;
    render::TouchState desk_touch_;
    Vec3 met_m_{0.0};  // position of the hand when meet_wall() last ran, device frame
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
    bool place_lost_ = false;      // the fault has made everything felt before invalid
    bool pause_reported_ = false;  // tool_.pause took a force away and was reported, so its end must be reported too
    double window_start_s_ = 0.0;  // start of the period over which the rate is measured
    std::uint64_t window_ticks_ = 0;
    double mean_period_s_ = 1e-3;  // mean time between answers of the device, filtered with one pole of 1 s
    double since_answer_s_ = 0.0;
    double since_touch_s_ = 0.0;
    double keep_off_s_ = 0.0;  // remaining time without force, because a second stall came during the ramp
    double scale_ = 0.0;       // world metres per hand metre in the last tick
    std::uint32_t confirm_seen_ = 0;
    int bad_run_ = 0;  // number of bad samples in a row
    Fault bad_kind_ = Fault::None;
    bool connected_ = false;
    bool trusts_last_ = false;  // the next sample must be near tool_.hand_m; otherwise it is treated as a jump
    bool has_first_ = false;
    Vec3 first_m_{0.0};  // first known position of the hand
    double hurry_s_ = render::ForceLimiter::kFadeS;
    Vec3 wanted_n_{0.0};  // force before the limiter, device frame; held while the device is silent
    bool goal_known_ = false;
    Vec3 goal_m_{0.0};
    Vec3 hand_at_goal_m_{0.0};    // position of the hand when the goal was goal_m_, device frame
    Vec3 velocity_m_per_s_{0.0};  // velocity of the hand, hand metres, world axes, filtered with one pole at 50 Hz
};

// Runs one tick. The stages are numbered in the source. Servo thread; never allocates, locks, throws or reads a clock.
device::ForceCommand servo_tick(ServoState& state, const TickInputs& given) noexcept;

}  // namespace handrail::servo
