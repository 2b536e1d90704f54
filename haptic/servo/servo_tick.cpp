#include "haptic/servo/servo_tick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptic/servo/vectors.h"

namespace handrail::servo {
namespace {

constexpr double kNominalPeriodS = 1e-3;
constexpr double kShortestPeriodS = 1e-6;
// Greatest distance of the hand's goal from the origin; farther away, doubles are too coarse for touch.
constexpr double kFarthestGoalM = 1e6;
// Greatest speed of a hand. After a gap, the permitted distance between two samples grows at this speed.
constexpr double kFastestHandMPerS = 5.0;
constexpr double kMeanPeriodPoleS = 1.0;
constexpr double kVelocityPoleS = 1.0 / (2.0 * kPi * 50.0);
constexpr double kRateWindowS = 1.0;
// Time from the first slow period to the end of the fade-out. The force must be zero 100 ms after the rate became too
// slow, and one tick of 5 ms is subtracted.
constexpr double kZeroAfterSlowS = 0.095;
constexpr double kLongestTouchStepS = 0.1;
// Proxy radius at the desk; its diameter of 4 mm feels the same as in a room.
constexpr double kDeskProxyRadiusM = 0.002;
// Greatest depth of a push that presses an object, as a share of the workspace radius. It limits the push on a device
// with low stiffness.
constexpr double kDeskPressDepth = 0.15;

Fault fault_of(device::DeviceLoss loss) noexcept {
    return loss == device::DeviceLoss::MayPush    ? Fault::MayPush
           : loss == device::DeviceLoss::ForceOff ? Fault::ForceOff
                                                  : Fault::Unplugged;
}

// Returns true for faults after which the hand's position may have jumped, or the renderer's state cannot be trusted.
bool loses_place(Fault fault) noexcept {
    return is_lost(fault) || fault == Fault::Jump || fault == Fault::BadSample || fault == Fault::BadForce;
}

}  // namespace

ServoState::ServoState(const device::DeviceSpec& spec) : spec_(spec), mover_(spec) {}

void ServoState::measure_rate(double dt_s) noexcept {
    counters_.periods.add(dt_s);
    ++window_ticks_;
    const double window_s = tool_.time_s - window_start_s_;
    if (window_s >= kRateWindowS) {
        tool_.rate_hz = static_cast<double>(window_ticks_) / window_s;
        window_start_s_ = tool_.time_s;
        window_ticks_ = 0;
    }
}

// A latched fault stays until the person confirms it; only the loss of the device replaces it.
void ServoState::raise(Fault fault, bool latched) noexcept {
    if (fault == fault_) {
        fault_latched_ = fault_latched_ || latched;
        return;
    }
    if (fault_latched_ && !is_lost(fault)) return;
    fault_ = fault;
    fault_latched_ = latched;
    events_.push(
        {ContactEventKind::FaultRaised, tool_.time_s, kNoFeature, kDefaultMaterial, tool_.proxy_m, 0.0, 0.0, fault});
    if (loses_place(fault)) {
        place_lost_ = true;
        touch_.reset_filters();
        desk_touch_.reset_filters();
        velocity_m_per_s_ = Vec3(0.0);
    }
}

// Makes the hand touch and hold nothing. When the device is back, the hand must move before it feels force.
void ServoState::lose_device() noexcept {
    place_lost_ = true;
    touch_.reset_filters();
    desk_touch_.reset_filters();
    velocity_m_per_s_ = Vec3(0.0);
    tracker_.clear(tool_.time_s, events_);
    tool_.touch_nothing();
    tool_.liquid = kNoFeature;
    tool_.buttons = 0;
    tool_.waiting_for_hand = true;
    has_first_ = false;
    trusts_last_ = false;
    mover_.let_go();
    leftover_.clear();
    space_.reset();
    pull_through_.reset();
    held_n_ = Vec3(0.0);
    press_.let_go();
}

void ServoState::clear_fault() noexcept {
    events_.push(
        {ContactEventKind::FaultCleared, tool_.time_s, kNoFeature, kDefaultMaterial, tool_.proxy_m, 0.0, 0.0, fault_});
    fault_ = Fault::None;
    fault_latched_ = false;
    place_lost_ = false;
    rate_watch_ = {};
}

bool ServoState::cause_lasts(const device::DeviceSample& sample) const noexcept {
    return !sample.connected || sample.hot || sample.failed || (fault_ == Fault::TooHot && heat_.too_warm());
}

// Reports a pause only if it takes a force away. The end of a pause is reported only if its start was.
void ServoState::watch_pauses(const ServoTuning& tuning) noexcept {
    const Fault pause = !tuning.focused                               ? Fault::FocusLost
                        : tuning.button_to_feel && tool_.buttons == 0 ? Fault::ButtonReleased
                                                                      : Fault::None;
    if (pause == tool_.pause) return;
    const Fault before = tool_.pause;
    tool_.pause = pause;
    const auto report = [&](ContactEventKind kind, Fault fault) {
        events_.push({kind, tool_.time_s, kNoFeature, kDefaultMaterial, tool_.proxy_m, 0.0, 0.0, fault});
    };
    if (pause != Fault::None && limiter_.gain() > 0.0 && fault_ == Fault::None) {
        report(ContactEventKind::FaultRaised, pause);
        pause_reported_ = true;
    } else if (pause == Fault::None && pause_reported_) {
        if (fault_ == Fault::None) report(ContactEventKind::FaultCleared, before);
        pause_reported_ = false;
    }
}

void ServoState::confirm(const device::DeviceSample& sample, std::uint32_t number) noexcept {
    if (number == confirm_seen_) return;
    confirm_seen_ = number;
    if (!fault_latched_ || cause_lasts(sample)) return;
    if (place_lost_) start_over();
    clear_fault();
    limiter_.restart();
}

// Discards the state of the touch, because the hand is now at another place in the world or in another world.
void ServoState::start_over() noexcept {
    space_.reset();
    pull_through_.reset();
    held_n_ = Vec3(0.0);
    leftover_.clear();
    met_ = false;
    if (tool_.desk.open) stand_up();
    touch_.reset();
    tracker_.clear(tool_.time_s, events_);
    limiter_.restart();
    mover_.let_go();
    guidance_.stop();
    goal_known_ = false;
    velocity_m_per_s_ = Vec3(0.0);
    wanted_n_ = Vec3(0.0);
    tool_.touch_nothing();
    tool_.liquid = kNoFeature;
}

// Called for a long gap. If the force was still ramping in, it stays off until a whole ramp's time has passed without
// another gap. Otherwise a device with a gap every 400 ms would gain energy for ever, because a wall that gets stiffer
// while the hand presses it gives the hand energy.
void ServoState::lose_time() noexcept { keep_off_s_ = limiter_.gain() < 1.0 ? render::ForceLimiter::kRampS : 0.0; }

ServoState::Answer ServoState::judge(const device::DeviceSample& sample, const WorkspaceFrame& frame, double scale,
                                     double dt_s) noexcept {
    since_answer_s_ += dt_s;
    if (!sample.connected) {
        // If a driver disconnects its device because of heat or an error, the fault states this reason.
        raise(sample.hot ? Fault::TooHot : sample.failed ? Fault::DriverError : fault_of(sample.loss), true);
        if (connected_) lose_device();
        connected_ = false;
        return Answer::None;
    }
    connected_ = true;
    if (sample.hot) raise(Fault::TooHot, true);
    if (sample.failed) raise(Fault::DriverError, true);
    if (!sample.fresh) {
        if (since_answer_s_ > kLongGapS) {
            if (fault_ != Fault::DeviceSilent) lose_time();
            raise(Fault::DeviceSilent, false);
        }
        if (bad_run_ > 0) limiter_.drop_out();
        return Answer::None;
    }
    const double period_s = since_answer_s_;
    since_answer_s_ = 0.0;
    tool_.homed_legs = sample.homed_legs;
    if (!sample.homed) {
        if (fault_ != Fault::Unhomed) start_over();
        raise(Fault::Unhomed, false);
        tool_.buttons = sample.buttons;
        tool_.waiting_for_hand = true;  // Wherever the hand is, it must move before it feels force.
        has_first_ = false;
        trusts_last_ = false;
        bad_run_ = 0;
        return Answer::None;
    }

    const double allowed_m = kJumpM + kFastestHandMPerS * std::max(0.0, period_s - 2.0 * kNominalPeriodS);
    const bool finite = is_finite(sample.position_m);
    const Vec3 goal_m =
        finite ? frame.to_world(sample.position_m, scale) : Vec3(std::numeric_limits<double>::infinity());
    const bool in_reach = std::abs(goal_m.x) <= kFarthestGoalM && std::abs(goal_m.y) <= kFarthestGoalM &&
                          std::abs(goal_m.z) <= kFarthestGoalM;
    const bool jumped = in_reach && trusts_last_ && !(length(sample.position_m - tool_.hand_m) <= allowed_m);
    if (!in_reach || jumped) {
        ++counters_.bad_samples;
        bad_kind_ = jumped ? Fault::Jump : Fault::BadSample;
        limiter_.drop_out();
        if (++bad_run_ >= kBadSamplesLatch) {
            raise(bad_kind_, true);
            // The next position is accepted wherever it is, and later jumps are judged from the accepted position.
            trusts_last_ = false;
        }
        return Answer::Bad;
    }
    bad_run_ = 0;
    trusts_last_ = true;
    tool_.hand_m = sample.position_m;
    tool_.hip_m = goal_m;
    tool_.buttons = sample.buttons;
    tool_.gimbal_rad = sample.gimbal_rad;
    if (!has_first_) {
        has_first_ = true;
        first_m_ = sample.position_m;
    } else if (tool_.waiting_for_hand && length(sample.position_m - first_m_) > kFirstMovementM) {
        tool_.waiting_for_hand = false;
    }

    if (tool_.ticks > 0) {
        const double counted_s = std::min(period_s, kLongGapS);
        mean_period_s_ += (counted_s - mean_period_s_) * (counted_s / (kMeanPeriodPoleS + counted_s));
        if (period_s >= kShortGapS && period_s <= kLongGapS) {
            ++counters_.held_gaps;
            limiter_.resume_after_gap();
        }
        if (too_slow(rate_watch_, period_s, spec_.min_rate_hz)) {
            hurry_s_ = std::clamp(kZeroAfterSlowS - rate_watch_.elapsed_s, kShortGapS, render::ForceLimiter::kFadeS);
            raise(Fault::LateLoop, true);
        }
    }
    return Answer::Good;
}

// Moves the workspace by rim, grab or keys, and reports when such a movement begins and ends.
void ServoState::move_workspace(WorkspaceFrame& frame, const ServoTuning& tuning, std::uint32_t buttons, double scale,
                                double dt_s) noexcept {
    const WorkspaceMotion before = mover_.motion();
    // While the hand's position is in doubt, the hand moves no workspace.
    const bool sound = fault_ == Fault::None && tool_.pause == Fault::None && !tool_.waiting_for_hand;
    mover_.move(frame, sound ? tuning.workspace : WorkspaceTuning{},
                {tool_.hand_m, buttons, length(wanted_n_), ceiling_n(tuning), &tool_.contacts}, scale, dt_s);
    tool_.hip_m = frame.to_world(tool_.hand_m, scale);
    const WorkspaceMotion now = mover_.motion();
    if (now == before) return;
    const auto report = [&](ContactEventKind kind) {
        events_.push({kind, tool_.time_s, kNoFeature, kDefaultMaterial, tool_.proxy_m, 0.0, 0.0, Fault::None});
    };
    if (before == WorkspaceMotion::Scrolled) report(ContactEventKind::RimLeft);
    if (before == WorkspaceMotion::Grabbed) report(ContactEventKind::LetGo);
    if (now == WorkspaceMotion::Scrolled) report(ContactEventKind::RimPassed);
    if (now == WorkspaceMotion::Grabbed) report(ContactEventKind::Grabbed);
}

// Returns the touch tuning, with the stiffness reduced to what the device can render at its measured rate.
render::TouchTuning ServoState::tuned(const ServoTuning& tuning) const noexcept {
    render::TouchTuning touch = tuning.touch;
    const double damping =
        touch.override_damping_ns_per_m >= 0.0 ? touch.override_damping_ns_per_m : touch.damping_ns_per_m;
    const double stiffest = device::effective_stiffness_n_per_m(spec_, mean_period_s_, damping);
    touch.rated_stiffness_n_per_m = std::min(touch.rated_stiffness_n_per_m, stiffest);
    touch.override_stiffness_n_per_m = std::min(touch.override_stiffness_n_per_m, stiffest);
    touch.force_delay_s = spec_.delay_s;
    touch.held = !tool_.waiting_for_hand;
    return touch;
}

double ServoState::ceiling_n(const ServoTuning& tuning) const noexcept {
    return std::min(tuning.force_ceiling_n, spec_.peak_force_n);
}

// Handles the wall towards the person's body, whether the hand reaches it from the world or from the desk.
void ServoState::meet_wall(const render::HapticScene* desk, const ServoTuning& tuning, WorkspaceFrame& frame,
                           double scale, double dt_s) noexcept {
    const bool was_at_desk = tool_.desk.open;
    if (was_at_desk) frame.origin_m += mover_.shift_m();
    const render::TouchTuning touch = tuned(tuning);
    const PersonalWall wall =
        personal_wall_of(spec_, ceiling_n(tuning), touch.rated_stiffness_n_per_m * touch.default_stiffness_fraction);
    leftover_.tick(met_ ? tool_.hand_m - met_m_ : Vec3(0.0), dt_s);
    met_m_ = tool_.hand_m;
    met_ = true;
    const bool there = desk && tuning.personal_space;
    // The wall is absent while the hand's position is in doubt. It is also absent while the hand moves its workspace,
    // or shortly after.
    const bool whole = there && fault_ == Fault::None && !tool_.waiting_for_hand &&
                       mover_.ceiling_n() == std::numeric_limits<double>::infinity();
    const Vec3 wall_was_n = space_.force_n();
    // A surface that blocks the path to the desk lets the hand through after a sustained pull.
    const bool pulled = pull_through_.tick(tool_.hand_m, held_n_, spec_.workspace_radius_m,
                                           whole && !was_at_desk && tool_.pause == Fault::None, dt_s);
    const bool through = space_.tick(tool_.hand_m, wall, whole, dt_s) || pulled;
    if (!through && !(was_at_desk && !there)) return;
    // When the hand passes the wall, all other forces on the old side disappear with this tick. They decay like the
    // wall's own force.
    const double gain = limiter_.gain();
    leftover_.begin(gain > 0.0 ? limiter_.last_n() / gain - wall_was_n : Vec3(0.0), touch.rated_stiffness_n_per_m);
    if (!was_at_desk) return sit_down();
    // The proxy is still at its old place in the world. The workspace is shifted so that the hand coincides with the
    // proxy and presses nothing.
    stand_up();
    const Vec3 way_m = tool_.proxy_m - frame.to_world(tool_.hand_m, scale);
    mover_.shift(way_m);
    frame.origin_m += way_m;
    tool_.hip_m = frame.to_world(tool_.hand_m, scale);
    touch_.reset_filters();
    goal_known_ = false;
    velocity_m_per_s_ = Vec3(0.0);
}

void ServoState::sit_down() noexcept {
    tracker_.clear(tool_.time_s, events_);
    tool_.touch_nothing();
    tool_.liquid = kNoFeature;
    mover_.let_go();
    guidance_.stop();
    tool_.guidance = guidance_.state();
    desk_touch_.reset();
    pull_through_.reset();
    held_n_ = Vec3(0.0);
    press_.let_go();
    tool_.desk.open = true;
    ++tool_.desk.visits;
    events_.push({ContactEventKind::DeskEntered, tool_.time_s, kNoFeature, kDefaultMaterial, tool_.proxy_m, 0.0, 0.0,
                  Fault::None});
}

void ServoState::stand_up() noexcept {
    press_.let_go();
    tool_.desk.open = false;
    tool_.desk.touched = tool_.desk.held = kNoFeature;
    tool_.desk.press_n = 0.0;
    events_.push(
        {ContactEventKind::DeskLeft, tool_.time_s, kNoFeature, kDefaultMaterial, tool_.proxy_m, 0.0, 0.0, Fault::None});
}

// Computes the forces of the desk at scale 1, in the device's own frame. The hand's state in the world stays unchanged.
void ServoState::touch_desk(const render::HapticScene& desk, const ServoTuning& tuning, double dt_s) noexcept {
    render::TouchTuning touch = tuned(tuning);
    touch.world_m_per_hand_m = 1.0;
    touch.radius_m = kDeskProxyRadiusM;
    const render::TouchResult result = render::touch_tick(desk_touch_, desk, touch, tool_.hand_m, dt_s);
    tool_.hip_m = tool_.proxy_m;
    if (!is_finite(result.proxy_m)) {
        wanted_n_ = Vec3(std::numeric_limits<double>::quiet_NaN());  // the limiter turns the NaN into a fault
        return;
    }
    wanted_n_ = result.force_n;
    DeskTouch& at = tool_.desk;
    at.hip_m = tool_.hand_m;
    at.proxy_m = result.proxy_m;
    at.press_n = length(result.contact_force_n);
    at.touched = result.contacts.count > 0 ? result.contacts.contacts[result.contacts.strongest].feature : kNoFeature;
    if (result.contacts.count > 0) tool_.contact_s += dt_s;
    counters_.waits += result.contacts.waits;
    const double needed_n = std::min({DeskPress::kPressN, DeskPress::kPressShare * ceiling_n(tuning),
                                      kDeskPressDepth * spec_.workspace_radius_m * touch.rated_stiffness_n_per_m *
                                          touch.default_stiffness_fraction});
    press_.tick(at.touched, at.press_n, (tool_.buttons & 1U) != 0 && !tuning.button_to_feel, needed_n);
    at.held = press_.held();
    at.presses = press_.presses();
}

template <bool kFree>
void ServoState::touch(const render::HapticScene& scene, const ServoTuning& tuning, const WorkspaceFrame& frame,
                       const Vec3& goal_m, double dt_s, const render::BodyPoses& bodies,
                       HandBodyServo* engine) noexcept {
    const render::TouchTuning touch = tuned(tuning);
    const double scale = touch.world_m_per_hand_m;
    Vec3 carried_m{0.0};
    if (goal_known_) {
        // If the hand drags the world along, it does not move through the world, so its whole motion is carried.
        carried_m = mover_.motion() == WorkspaceMotion::Grabbed ? goal_m - goal_m_
                                                                : frame.to_world(hand_at_goal_m_, scale) - goal_m_;
        const Vec3 velocity = (goal_m - goal_m_) / (scale * dt_s);
        velocity_m_per_s_ += (velocity - velocity_m_per_s_) * (dt_s / (kVelocityPoleS + dt_s));
    }
    goal_m_ = goal_m;
    hand_at_goal_m_ = tool_.hand_m;
    goal_known_ = true;

    render::BodyPoses mine;
    if constexpr (kFree) {
        mine = engine->place(bodies, scene, tool_.time_s, goal_m, body_feel(tuning, touch));
        carried_m += engine->carried_m();
    }
    const render::TouchResult result =
        render::touch_tick(touch_, scene, touch, goal_m, dt_s, carried_m, kFree ? mine : bodies);
    wanted_n_ = frame.turn_to_device(result.force_n) + mover_.rim_force_n();
    if constexpr (kFree) {
        wanted_n_ += frame.turn_to_device(engine->grip_force_n(goal_m, dt_s));
        engine->felt(result);
    }
    held_n_ = frame.turn_to_device(result.contact_force_n);
    if (is_finite(result.proxy_m)) mover_.give_way(goal_m, result.proxy_m, length(result.contact_force_n));
    if (!is_finite(result.proxy_m)) {
        wanted_n_ = Vec3(std::numeric_limits<double>::quiet_NaN());  // the limiter turns the NaN into a fault
        return;
    }
    tool_.proxy_m = result.proxy_m;
    tool_.proxy_radius_m = result.radius_m;
    tool_.contacts = result.contacts;
    tool_.soft = result.soft;
    tool_.soft_n = length(result.soft_force_n);
    tool_.contact_n = length(result.contact_force_n);
    tool_.liquid = result.liquid;
    if (result.contacts.count > 0) tool_.contact_s += dt_s;
    tracker_.update(result, velocity_m_per_s_, scale, tool_.time_s, dt_s, events_);
}

// Returns the tuning of the free bodies, which depends on the person's strength in the world and on what the device can
// render.
BodyFeel ServoState::body_feel(const ServoTuning& tuning, const render::TouchTuning& touch) const noexcept {
    BodyFeel feel;
    feel.world_m_per_hand_m = touch.world_m_per_hand_m;
    feel.ceiling_n = ceiling_n(tuning);
    feel.felt_gain = felt_gain(feel.ceiling_n, tuning.bodies.strength_n);
    feel.proxy_radius_m = touch.radius_m;
    feel.grip_n_per_m = std::min(feel.grip_n_per_m, touch.rated_stiffness_n_per_m * touch.default_stiffness_fraction);
    return feel;
}

// Moves the free bodies by the share of the force that the limiter passed. If the device is silent for a moment,
// nothing changes.
void ServoState::move_bodies(HandBodyServo& engine, bool met, bool silent, const Vec3& force_n, double dt_s) noexcept {
    if (met) {
        const double wanted_n = length(wanted_n_);
        engine.react(wanted_n > 0.0 ? std::min(1.0, length(force_n) / wanted_n) : 0.0, tool_.time_s, dt_s);
    } else if (!silent) {
        engine.leave();
    }
    tool_.holds = engine.holds();
    if (const std::uint32_t heavy = engine.heavy(); heavy != render::kNoBody) {
        tool_.heavy = heavy;
        ++tool_.heavies;
    }
}

// Adds the guidance to the touch force. Guidance acts only while force may act at all.
void ServoState::guide(const GuidancePath& path, const WorkspaceFrame& frame, double scale, bool allowed,
                       double dt_s) noexcept {
    wanted_n_ += frame.turn_to_device(guidance_.tick(path, tool_.hip_m, scale, spec_.peak_force_n, allowed, dt_s));
    tool_.guidance = guidance_.state();
}

render::ForceFlow ServoState::flow(const ServoTuning& tuning, bool scene_present, bool long_gap,
                                   double& fade_s) const noexcept {
    fade_s = render::ForceLimiter::kFadeS;
    if (tuning.panic || long_gap || keep_off_s_ > 0.0 || !scene_present || tool_.waiting_for_hand)
        return render::ForceFlow::Cut;
    if (fault_ == Fault::LateLoop) {
        fade_s = hurry_s_;
        return render::ForceFlow::Fade;
    }
    if (fault_ == Fault::TooHot && connected_) return render::ForceFlow::Fade;
    if (fault_ != Fault::None) return render::ForceFlow::Cut;
    return tuning.forces_on && tool_.pause == Fault::None ? render::ForceFlow::Run : render::ForceFlow::Fade;
}

device::ForceCommand servo_tick(ServoState& state, const TickInputs& given) noexcept {
    const auto& [scene, tuning, pose, sample, now_s, bodies, desk, guidance, engine] = given;
    ServoState& s = state;
    s.events_.count = 0;
    s.events_.lost = 0;

    // 1. Measures the time since the last tick.
    const bool first = s.tool_.ticks == 0;
    const double dt_s = first ? kNominalPeriodS : std::max(now_s - s.tool_.time_s, kShortestPeriodS);
    s.tool_.time_s = now_s;
    if (first) {
        s.window_start_s_ = now_s;
        s.confirm_seen_ = tuning.confirm;
        s.scale_ = tuning.touch.world_m_per_hand_m;
    } else {
        s.measure_rate(dt_s);
    }
    const bool long_gap = dt_s > ServoState::kLongGapS;
    s.keep_off_s_ -= dt_s;
    if (long_gap) {
        ++s.counters_.long_gaps;
        s.lose_time();
    }
    s.confirm(sample, tuning.confirm);

    // 2. Computes the workspace's pose in the world, and handles changes that make everything felt before invalid.
    const bool jumped = s.playback_.give(pose, now_s);
    WorkspaceFrame frame = s.playback_.at(now_s, dt_s);
    const double scale = tuning.touch.world_m_per_hand_m;
    const std::uint32_t generation = scene ? scene->generation : 0;
    if (jumped || scale != s.scale_ || (!scene && s.tool_.scene_generation != 0)) s.start_over();
    if (jumped) s.mover_.recentre();
    // A held body stays where it is when the workspace jumps to another place or scale.
    if (engine && (jumped || scale != s.scale_ || long_gap)) engine->leave();
    // In another world the force ramps in. In the same world with things added or removed, the proxy prevents a knock.
    const std::uint32_t world = scene ? scene->world : 0;
    if (world != s.tool_.scene_world) {
        s.limiter_.restart();
        s.tool_.holds = render::kNoBody;
    }
    s.tool_.scene_world = world;
    s.scale_ = scale;
    s.tool_.scene_generation = generation;

    // 3. Checks the sample.
    const ServoState::Answer answer = s.judge(sample, frame, scale, dt_s);
    if (long_gap) {
        s.raise(Fault::Stalled, false);
    } else if (answer == ServoState::Answer::Good && s.fault_ != Fault::None && !s.fault_latched_) {
        s.clear_fault();
    }
    s.watch_pauses(tuning);

    // 4. Computes the touch.
    s.since_touch_s_ = std::min(s.since_touch_s_ + dt_s, kLongestTouchStepS);
    bool meets_bodies = false;
    const double touched_for_s = s.since_touch_s_;
    if (answer == ServoState::Answer::Good) {
        std::uint32_t buttons = s.tool_.buttons;
        // A button that holds a body must not move the workspace.
        if (engine && engine->grip(tuning.bodies, buttons, now_s, s.tool_.hip_m))
            buttons &= ~tuning.bodies.grip_buttons;
        if (!s.tool_.desk.open) s.move_workspace(frame, tuning, buttons, scale, s.since_touch_s_);
        const bool wall = tuning.personal_space | s.tool_.desk.open;
        if (wall) s.meet_wall(desk, tuning, frame, scale, s.since_touch_s_);
        if (s.tool_.desk.open) {
            // While the hand is at the desk, its state in the world is frozen.
            s.touch_desk(*desk, tuning, s.since_touch_s_);
        } else if (scene) {
            render::BodyPoses poses;
            if (bodies && !scene->bodies.empty()) poses = s.bodies_.at(*bodies, *scene, s.playback_.played_s(), jumped);
            if (engine) {
                meets_bodies = true;
                s.touch<true>(*scene, tuning, frame, s.tool_.hip_m, s.since_touch_s_, poses, engine);
            } else {
                s.touch<false>(*scene, tuning, frame, s.tool_.hip_m, s.since_touch_s_, poses, nullptr);
            }
            if (guidance && !s.guidance_.idle(*guidance)) {
                double unused_s = 0.0;
                s.guide(*guidance, frame, scale, s.flow(tuning, true, long_gap, unused_s) == render::ForceFlow::Run,
                        s.since_touch_s_);
            }
        } else {
            s.tool_.proxy_m = s.tool_.hip_m;
            s.wanted_n_ = s.mover_.rim_force_n();
        }
        if (wall) s.wanted_n_ += s.space_.force_n() + s.leftover_.force_n();
        s.since_touch_s_ = 0.0;
    }

    // 5. Applies the limiter, the only path by which force reaches the device.
    double fade_s = 0.0;
    const render::ForceFlow flow = s.flow(tuning, scene != nullptr, long_gap, fade_s);
    const double ceiling_n = std::min({tuning.force_ceiling_n, s.spec_.peak_force_n, s.mover_.ceiling_n()});
    const Vec3 force_n = s.limiter_.limit(s.wanted_n_, ceiling_n, flow, dt_s, fade_s);
    if (s.limiter_.broken()) s.raise(Fault::BadForce, true);
    if (engine) s.move_bodies(*engine, meets_bodies, answer == ServoState::Answer::None, force_n, touched_for_s);
    s.heat_.add(length(force_n), s.spec_.sustained_share * s.spec_.peak_force_n, dt_s);
    if (s.heat_.too_warm()) s.raise(Fault::TooHot, true);

    // 6. Updates the published state.
    ToolState& tool = s.tool_;
    tool.force_n = frame.turn_to_world(force_n);
    tool.force_gain = s.limiter_.gain();
    tool.fault = s.fault_ != Fault::None ? s.fault_ : answer == ServoState::Answer::Bad ? s.bad_kind_ : Fault::None;
    tool.fault_latched = s.fault_latched_;
    tool.fault_lasts = s.fault_latched_ && s.cause_lasts(sample);
    tool.warmth = s.heat_.warmth();
    tool.workspace_motion = s.mover_.motion();
    tool.workspace_at_limit = s.mover_.at_limit();
    tool.workspace_shift_m = s.mover_.shift_m();
    tool.workspace_jump = pose.jump;
    ++tool.ticks;
    s.counters_.lost_events += s.events_.lost;
    return {force_n};
}

}  // namespace handrail::servo
