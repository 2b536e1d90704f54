#include "app/core/app_core.h"
#include "app/core/spoken_language.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "haptic/render/free_place.h"
#include "worlds/base/language.h"
#include "worlds/scene/lint.h"
#include "worlds/scene/models.h"
#include "worlds/scene/surfaces.h"

namespace handrail {
namespace {

constexpr double kTurnRate_rad_per_s = 2.6;       // 150 degrees a second: at scale 60 a hand at the rim moves 10 cm/s through the world
constexpr double kStickTurnRate_rad_per_s = 1.6;  // 90 degrees a second with the stick all the way
constexpr double kTurnRepeat_s = 0.4;
constexpr double kTiltRate_rad_per_s = 0.8;
constexpr double kMostTilt_rad = 1.2;
constexpr double kHandKeySpeed_m_per_s = 0.06;
constexpr double kHandTap_m = 0.005;              // one tap of a hand key
constexpr double kPushSpeed_hand_m_per_s = 0.03;  // of the workspace by keys
constexpr double kPushTap_s = 0.2;
constexpr double kLeaveWindow_s = 5.0;
constexpr double kSamePress_s = 0.25;
constexpr double kToneRange_m = 2.0;
constexpr double kBreakEvery_s = 15.0 * 60.0;
constexpr double kMostPendingSteps = 8.0;
constexpr std::size_t kMostPathPoints = 4000;
std::string no_hand() { return phrase("session.no_hand"); }

constexpr int kTellName = 2, kTellAll = 4;  // verbosity

// Which way the keys push the workspace, device frame; `held`: which of them count.
template <class Held>
Vec3 push_way(Held held) {
    const auto sign = [&](Command plus, Command minus) { return (held(plus) ? 1.0 : 0.0) - (held(minus) ? 1.0 : 0.0); };
    return {sign(Command::WorkspaceRight, Command::WorkspaceLeft), sign(Command::WorkspaceForward, Command::WorkspaceBack),
            sign(Command::WorkspaceUp, Command::WorkspaceDown)};
}

}  // namespace

AppCore::AppCore(const Settings& settings, const HandFacts& hand)
    : settings_(settings),
      hand_(hand),
      keys_(settings.keys, settings.keyboard.hand),
      who_speaks_(phrase("session.your_voice")),
      held_(command_table().size(), false) {
    lay_device_overrides();
    furnish_desk();
    lay_desk(0);
    for (const std::string& problem : keys_.problems()) say(problem, SpeechClass::Answer, 0.0);
}

void AppCore::lay_device_overrides() {
    // On top of the general workspace lies what the person wrote for devices of this name, on top of that what was measured with this very one.
    const auto found = settings_.workspace.devices.find(std::string(hand_.spec.name));
    if (hand_.present && found != settings_.workspace.devices.end()) {
        const Settings::Workspace::Override& own = found->second;
        settings_.workspace.scale = own.scale.value_or(settings_.workspace.scale);
        settings_.workspace.offset_ahead_m = own.offset_ahead_m.value_or(settings_.workspace.offset_ahead_m);
        settings_.workspace.offset_up_m = own.offset_up_m.value_or(settings_.workspace.offset_up_m);
        settings_.workspace.hand_height_m = own.hand_height_m.value_or(settings_.workspace.hand_height_m);
    }
    if (const DeviceProfile* own = profile_of(hand_)) {
        settings_.workspace.scale = own->scale.value_or(settings_.workspace.scale);
        settings_.workspace.offset_ahead_m = own->offset_ahead_m.value_or(settings_.workspace.offset_ahead_m);
        settings_.workspace.offset_up_m = own->offset_up_m.value_or(settings_.workspace.offset_up_m);
    }
}

const DeviceProfile* AppCore::profile_of(const HandFacts& hand) const {
    const auto found = settings_.profiles.find(profile_key(hand.spec.name, hand.serial));
    return hand.present && found != settings_.profiles.end() ? &found->second : nullptr;
}

void AppCore::enter_world(std::shared_ptr<const Scene> scene, double now_s) {
    Vec3 feet{0.0};
    double heading = 0.0;
    const auto base = std::find_if(scene->starts.begin(), scene->starts.end(), [](const Start& s) { return s.base; });
    if (base != scene->starts.end()) {
        feet = base->feet_m;
        heading = base->heading_rad;
    } else if (!scene->starts.empty()) {
        feet = scene->starts.front().feet_m;
        heading = scene->starts.front().heading_rad;
    } else if (!scene->bounds_m.empty()) {
        // No start in the file: in front of the south side's middle, on the ground, looking in.
        const Vec3 centre = scene->bounds_m.centre_m();
        feet = Vec3(centre.x, scene->bounds_m.min_m.y - 1.0, scene->bounds_m.min_m.z);
    }
    enter_world_at(std::move(scene), feet, heading, now_s);
}

void AppCore::enter_world_at(std::shared_ptr<const Scene> scene, const Vec3& feet_m, double heading_rad, double now_s) {
    Scene entered = with_movers_apart(*scene, HapticScene::kMostBodies, thing_of_mover_);
    mark_base_door(entered, feet_m);
    scene_ = std::make_shared<const Scene>(std::move(entered));
    begin_rooms(scene);
    const std::vector<Error> mark_faults = take_additions();  // before the hand's scene is made: what bears a mark is not simplified
    retune();
    compile(0);
    things_.enter(*scene_, *haptic_scene_, compiled_plan_, now_s);
    movers_.enter(scene_->movers);
    hand_shift_m_ = Vec3(0.0);
    walker_.reset();
    body_world_ = std::make_unique<BodyWorld>(scene_);
    walker_ = std::make_unique<Walker>(*body_world_, body_size(*scene_, settings_.walk.body_radius_m));
    walker_->place(feet_m);
    home_feet_m_ = walker_->state().feet_m;
    home_heading_rad_ = heading_rad_ = heading_goal_rad_ = wrap_angle(heading_rad);
    soundscape_.enter(*scene_);
    enter_learning(now_s);
    dialogue_.close_all();  // what it was about may be gone
    inside_.clear();
    told_triggers_.clear();
    path_m_.assign(1, home_feet_m_);
    walking_ = {};
    walking_.crumbs_m.assign(1, home_feet_m_);
    pending_way_m_ = since_footstep_m_ = 0.0;
    blocked_ = false;
    last_tick_s_ = now_s;
    ++worlds_entered_;

    publish_pose(now_s, PoseChange::Placed);
    if (!greeting_waits()) say(entering_text(), SpeechClass::Answer, now_s);
    if (settings_.speech.crowding_hint)
        if (std::string crowded = crowded_view(*scene_); !crowded.empty()) say(std::move(crowded), SpeechClass::Answer, now_s);
    tell_additions(mark_faults, now_s);
    simplified_told_.clear();
    if (std::string news = greeting_waits() ? std::string() : simplified_news(); !news.empty()) say(std::move(news), SpeechClass::Ambient, now_s);
    if (std::exchange(hunt_awaits_, false)) hunt_key(now_s);
}

// Never more than the ball's radius: see round_edges.h about inner corners.
double AppCore::rounding_m() const {
    return std::min(edge_rounding_m(settings_.haptic.edge_rounding_mm, tuning_.touch.world_m_per_hand_m), tuning_.touch.radius_m);
}

// After retune(). True where the hand feels another scene from now on.
bool AppCore::adapt_touch(double now_s) {
    if (rounding_m() == compiled_rounding_m_ && touch_plan_ == compiled_plan_) return false;
    scene_ = std::make_shared<const Scene>(world_now());
    feel_scene(now_s);
    return true;
}

// What of the scene a hand can touch, by the plan of retune(). world: see HapticScene::world.
void AppCore::compile(std::uint32_t world) {
    compiled_rounding_m_ = rounding_m();
    compiled_plan_ = touch_plan_;
    const CompileOptions options = exploring(compiled_rounding_m_, world);
    haptic_scene_ = compiled_plan_.changes_nothing() ? compile_haptic(*scene_, options) : compile_haptic(simplified(*scene_, compiled_plan_), options);
}

void AppCore::retune() {
    tuning_.touch = TouchTuning{};
    tuning_.touch.world_m_per_hand_m = scale();
    touch_plan_ = plan_touch();
    tuning_.touch.radius_m = ball_radius_m(*scene_, settings_.haptic.ball_diameter_mm * 1e-3, scale(), touch_plan_);
    tuning_.touch.default_stiffness_fraction = settings_.haptic.stiffness_fraction;
    tuning_.touch.damping_ns_per_m = settings_.haptic.damping_ns_per_m;
    tuning_.button_to_feel = settings_.haptic.button_to_feel;
    tuning_.touch.passivity_guard = true;  // acts only on surfaces that are damped too little to need none
    tuning_.touch.default_friction_static = tuning_.touch.default_friction_kinetic = settings_.haptic.friction_mu;

    if (hand_.present) tuning_.touch.rated_stiffness_n_per_m = hand_.spec.rated_stiffness_n_per_m;
    tuning_.force_ceiling_n = ceiling_n(hand_);
    tuning_.personal_space = settings_.desk.use && hand_.present;
    tuning_.workspace.rim = settings_.workspace.rim;
    tuning_.workspace.rim_open_behind = tuning_.personal_space;
    // The first button is taken where the hand feels only while a button is held.
    const int button = settings_.workspace.grab_button;
    tuning_.workspace.grab_buttons = button == 0 || (button == 1 && settings_.haptic.button_to_feel) ? 0U : 1U << (button - 1);
    tuning_.workspace.limits_m = scene_->bounds_m;
}

// The lowest of what the person chose for all devices and what was found comfortable with this one.
double AppCore::ceiling_n(const HandFacts& hand) const {
    double ceiling = hand.spec.peak_force_n;
    if (settings_.haptic.ceiling == ForceCeiling::Light) ceiling = kLightCeiling_n;
    if (settings_.haptic.ceiling == ForceCeiling::Normal) ceiling = kNormalCeiling_n;
    if (const DeviceProfile* own = profile_of(hand); own && own->ceiling_n) ceiling = std::min(ceiling, *own->ceiling_n);
    if (settings_.damaged_profiles.contains(profile_key(hand.spec.name, hand.serial))) ceiling = std::min(ceiling, kLightCeiling_n);
    return ceiling;
}

double AppCore::scale() const {
    if (!named_scale_) return settings_.workspace.scale;
    return world_m_per_hand_m(*named_scale_, scene_->bounds_m, hand_.spec.workspace_radius_m);
}

void AppCore::set_hand(const HandFacts& hand, const Settings& settings, double now_s) {
    contact_before_s_ += tool_.contact_s;
    tool_ = ToolState{};
    fault_lasted_ = false;
    hand_ = hand;
    end_guidance();
    hand_target_m_ = Vec3(0.0);
    hand_shift_m_ = Vec3(0.0);
    lay_desk(0);
    change_settings(settings, now_s);
}

void AppCore::offer_hand(const std::string& spoken_name, double now_s) {
    offered_ = true;
    say(found_words(spoken_name) + " " + phrase("session.press_to_use", {{"key", keys_.keys_of(Command::ToggleForces)}}), SpeechClass::Answer, now_s);
}

void AppCore::change_settings(const Settings& settings, double now_s) {
    if (settings.speech.language != settings_.speech.language) {
        for (const Diagnostic& fault : speak_as_set(settings.speech, languages_folder_)) say(fault.sentence(), SpeechClass::Answer, now_s);
        furnish_desk();  // its controls' names
        lay_desk(0);
    }
    settings_ = settings;
    lay_device_overrides();
    keys_ = KeyMap(settings_.keys, settings_.keyboard.hand);
    if (!scene_) return;
    retune();
    if (adapt_touch(now_s) && tool_.ticks > 0) hand_shift_m_ += hands_out_of_solids_m(workspace_origin_m() + hand_shift_m_ + shift_by_hand_m());
    publish_pose(now_s, PoseChange::Moved);
}

std::string AppCore::name_of(FeatureId feature) const {
    const std::string name = spoken_name(*scene_, feature);
    return name.empty() ? spoken_kind("wall") : name;
}

std::string AppCore::entering_text() const {
    const FreeSpace space = free_space(*body_world_, feet_m(), kLookHeight_m, heading_rad_);
    std::string text = sentence_case(spoken_name(*scene_)) + ".";
    if (space.width_m > 0.0 && space.depth_m > 0.0) text += " " + phrase("session.space", {{"size", size_words(space.width_m, space.depth_m, distances())}});
    const Vec3 size = scene_->bounds_m.empty() ? Vec3(0.0) : scene_->bounds_m.size_m();
    if (size.x > 1.5 * space.width_m + 2.0 || size.y > 1.5 * space.depth_m + 2.0)
        text += " " + phrase("session.all_of_it", {{"wide", size.x}, {"deep", size.y}});
    text += " " + where_am_i() + " ";
    if (hand_.present && !hand_.simulated) text += phrase("session.begin_with_hand");
    else if (hand_.present) text += phrase("session.begin_with_simulated_hand");
    else text += phrase("session.begin_with_keys");
    return text + " " + phrase("session.where_help_is");
}

std::string AppCore::help_text() const {
    std::string text;
    for (const CommandInfo& row : command_table()) {
        const std::string keys = keys_.keys_of(row.command);
        if (!keys.empty()) text += phrase("session.key_help", {{"keys", keys}, {"help", row.help()}}) + " ";
    }
    return text;
}

void AppCore::say(std::string text, SpeechClass speech_class, double now_s) {
    CueRequest request;
    request.kind = CueRequestKind::Say;
    request.time_s = now_s;
    request.text = std::move(text);
    request.speech_class = speech_class;
    request.repeatable = speech_class == SpeechClass::Answer;
    cue(std::move(request));
}

void AppCore::answer(std::string text, double now_s) { say(std::move(text), SpeechClass::Answer, now_s); }

void AppCore::press(Command command, double now_s) {
    if (held(command)) return;
    // Any key interrupts what is being said; Repeat wants it again, and Stop says so itself.
    if (command != Command::Repeat && command != Command::HistoryBack && command != Command::HistoryForward && command != Command::StopSpeech &&
        command != Command::StopEverything)
        quiet(now_s);
    if (lesson_takes(command, now_s)) return;
    did_.push_back(command);
    if (info(command).hold) held_[static_cast<std::size_t>(command)] = true;
    act(command, now_s);
}

void AppCore::release(Command command) { held_[static_cast<std::size_t>(command)] = false; }

void AppCore::set_focus(bool focused) {
    if (!focused) steering_ = {};
    tuning_.focused = focused;
    if (!focused) {
        std::fill(held_.begin(), held_.end(), false);
        let_go_of_world();
    }
}

void AppCore::know_stops(std::uint32_t stops, double now_s) {
    if (stops == stops_known_) return;
    stops_known_ = stops;
    if (!tuning_.panic) act(Command::StopEverything, now_s);
}

bool AppCore::idle() const {
    const bool walking = walker_ && (pending_way_m_ != 0.0 || !walker_->state().on_ground);
    const bool pushing = last_tick_s_ < push_until_s_;
    if (!said_later_.empty() || after_lesson_ != AfterLesson::Nothing || calibration_asked_ || (lesson_ && !did_.empty())) return false;
    return !walking && !pushing && !led() && heading_rad_ == heading_goal_rad_ && std::none_of(held_.begin(), held_.end(), [](bool down) { return down; });
}

void AppCore::act(Command command, double now_s) {
    if (!scene_) return;
    if (refused_at_desk(command, now_s)) return;
    notice_walk_key(command, now_s);
    if (act_walking(command, now_s) || act_learning(command, now_s)) return;
    const double notch = radians_from_degrees(settings_.walk.turn_deg);
    const auto step = [&](double sign) {
        if (pending_way_m_ * sign < 0.0) pending_way_m_ = 0.0;
        const double most = kMostPendingSteps * settings_.walk.step_length_m;
        pending_way_m_ = std::clamp(pending_way_m_ + sign * settings_.walk.step_length_m, -most, most);
        blocked_ = false;
    };
    const auto turn_by = [&](double by) {
        heading_goal_rad_ = wrap_angle(std::round((heading_goal_rad_ + by) / notch) * notch);
        last_turn_repeat_s_ = now_s;
        CueRequest tick;
        tick.kind = CueRequestKind::Play;
        tick.sound = SoundKind::TurnTick;
        tick.time_s = now_s;
        tick.position_m = feet_m() + Vec3(0.0, 0.0, walker_->size().eye_height_m) + forward_of_heading(heading_goal_rad_);
        cue(std::move(tick));
        answer(sentence_case(compass_word(heading_goal_rad_)), now_s);
    };
    switch (command) {
        case Command::Forward:
            step(1.0);
            break;
        case Command::Back:
            step(-1.0);
            break;
        case Command::TurnLeft:
            turn_by(-notch);
            break;
        case Command::TurnRight:
            turn_by(notch);
            break;
        case Command::TiltUp:
        case Command::TiltDown:
            break;
        case Command::ToggleForces:
            toggle_forces(now_s);
            break;
        case Command::SwitchFrame: {
            const bool to_walk = settings_.workspace.frame == FrameChoice::Map;
            settings_.workspace.frame = to_walk ? FrameChoice::Walk : FrameChoice::Map;
            setting_changes_.emplace_back("workspace.frame", to_walk ? "walk" : "map");
            publish_pose(now_s, PoseChange::Moved);
            play(SoundKind::FrameSwitch, now_s);
            answer(phrase(to_walk ? "session.frame_walk" : "session.frame_map"), now_s);
            break;
        }
        case Command::ScaleBuilding:
        case Command::ScaleFloor:
        case Command::ScaleRoom:
        case Command::ScaleDetail:
            zoom(static_cast<NamedScale>(static_cast<int>(command) - static_cast<int>(Command::ScaleBuilding)), now_s);
            break;
        case Command::WorkspaceForward:
        case Command::WorkspaceBack:
        case Command::WorkspaceLeft:
        case Command::WorkspaceRight:
        case Command::WorkspaceUp:
        case Command::WorkspaceDown:
            if (!hand_.present) return answer(no_hand(), now_s);
            push_tap_ = push_way([command](Command one) { return one == command; });
            push_until_s_ = now_s + kPushTap_s;
            break;
        case Command::WorkspaceTurnLeft:
            turn_workspace(-settings_.walk.turn_deg, now_s);
            break;
        case Command::WorkspaceTurnRight:
            turn_workspace(settings_.walk.turn_deg, now_s);
            break;
        case Command::WorkspaceCentre:
            if (!hand_.present) return answer(no_hand(), now_s);
            publish_pose(now_s, PoseChange::Placed);
            answer(phrase("session.workspace_back"), now_s);
            break;
        case Command::Grab:
            if (!hand_.present) return answer(no_hand(), now_s);
            tuning_.workspace.grab_key = !tuning_.workspace.grab_key;
            if (tuning_.workspace.grab_key) answer(phrase("session.grabbed"), now_s);
            break;
        case Command::WhereAmI:
            answer(room_words(now_s) + where_am_i(), now_s);
            break;
        case Command::Heading:
            answer(heading_words(), now_s);
            break;
        case Command::AroundMe:
            answer(around_me(), now_s);
            break;
        case Command::AheadOfMe:
            answer(ahead_of_me(), now_s);
            break;
        case Command::LookNext:
            look_round(1, now_s);
            break;
        case Command::LookBefore:
            look_round(-1, now_s);
            break;
        case Command::ScaleBar:
            answer(scale_bar(), now_s);
            break;
        case Command::Simplified:
            list_simplified(now_s);
            break;
        case Command::Coordinates:
            answer(coordinates(), now_s);
            break;
        case Command::WhatIsThis:
            describe_touched(now_s);
            break;
        case Command::Repeat:
        case Command::HistoryBack:
        case Command::HistoryForward:
        case Command::StopSpeech: {
            CueRequest request;
            request.kind = command == Command::Repeat           ? CueRequestKind::Repeat
                           : command == Command::HistoryBack    ? CueRequestKind::HistoryBack
                           : command == Command::HistoryForward ? CueRequestKind::HistoryForward
                                                                : CueRequestKind::StopSpeech;
            request.time_s = now_s;
            cue(std::move(request));
            break;
        }
        case Command::StopEverything: {
            // The switch and the window tell of the same press; the second telling must not silence what the first one says.
            if (tuning_.panic && now_s - stopped_s_ < kSamePress_s) break;
            stopped_s_ = now_s;
            tuning_.panic = true;
            let_go_of_world();
            tone_loudness_ = 0.0;
            pending_way_m_ = 0.0;
            CueRequest request;
            request.kind = CueRequestKind::SilenceAll;
            request.time_s = now_s;
            cue(std::move(request));
            say(phrase("session.stopped"), SpeechClass::Alarm, now_s);
            break;
        }
        case Command::Home:
            keep_place_for_undo();
            go_home(now_s);
            break;
        case Command::BringOut:
            bring_out(now_s);
            break;
        case Command::Use:
            use(now_s);
            break;
        case Command::DropMark:
        case Command::DeleteMark:
        case Command::Marks:
        case Command::SetBeacon:
        case Command::MuteBeacon:
        case Command::TakeMe:
        case Command::Find:
        case Command::CrossLines:
            act_guiding(command, now_s);
            break;
        case Command::Exits:
            tell_exits(false, now_s);
            break;
        case Command::UnvisitedExits:
            tell_exits(true, now_s);
            break;
        case Command::Routes:
            list_routes(now_s);
            break;
        case Command::NameRoom:
            ask_room_name(now_s);
            break;
        case Command::Ways:
            open_ways(now_s);
            break;
        case Command::KeepWay:
            open_keep_way(now_s);
            break;
        case Command::PlanView:
            plan_view_ = !plan_view_;
            answer(phrase(plan_view_ ? "session.plan" : "session.first_person"), now_s);
            break;
        case Command::Menu:
            open_menu(now_s);
            break;
        case Command::Help:
            answer(help_text(), now_s);
            break;
        case Command::InputHelp:
            toggle_input_help(now_s);
            break;
        case Command::Lessons:
            open_lessons(now_s);
            break;
        case Command::Language:
            open_languages(now_s);
            break;
        case Command::FirstMinutes:
            settings_.welcome.step = 0;
            begin_lesson(first_minutes(), 0, now_s);
            break;
        case Command::NextSound:
            cue(dictionary_.step(1, listener(), now_s));
            break;
        case Command::LastSound:
            cue(dictionary_.step(-1, listener(), now_s));
            break;
        case Command::VerbosityCycle:
            settings_.speech.verbosity = (settings_.speech.verbosity + 1) % 5;
            setting_changes_.emplace_back("speech.verbosity", fmt::format("{}", settings_.speech.verbosity));
            answer(phrase("session.verbosity", {{"level", settings_.speech.verbosity}}), now_s);
            break;
        case Command::Calibrate:
            calibration_asked_ = true;
            break;
        case Command::Desk:
            open_desk_list(now_s);
            break;
        case Command::Leave:
            if (at_desk()) {
                leave_desk(now_s);
            } else if (now_s - leave_asked_s_ <= kLeaveWindow_s) {
                wants_to_leave_ = true;
                answer(phrase("session.goodbye"), now_s);
            } else {
                leave_asked_s_ = now_s;
                answer(phrase("session.leave_again"), now_s);
            }
            break;
        case Command::HandCentre:
            hand_target_m_ = Vec3(0.0);
            break;
        case Command::HandForward:
            move_hand({0.0, kHandTap_m, 0.0});
            break;
        case Command::HandBack:
            move_hand({0.0, -kHandTap_m, 0.0});
            break;
        case Command::HandLeft:
            move_hand({-kHandTap_m, 0.0, 0.0});
            break;
        case Command::HandRight:
            move_hand({kHandTap_m, 0.0, 0.0});
            break;
        case Command::HandUp:
            move_hand({0.0, 0.0, kHandTap_m});
            break;
        case Command::HandDown:
            move_hand({0.0, 0.0, -kHandTap_m});
            break;
        default:  // act_walking()
            break;
    }
}

void AppCore::toggle_forces(double now_s) {
    const bool stopped = tuning_.panic || stops_known_ != tuning_.stops_let_go;
    if (offered_ && !stopped) {
        offered_ = false;
        offer_taken_ = true;
        return;
    }
    const bool wake = stopped || tool_.fault != Fault::None || left_tool_.fault != Fault::None || !tuning_.forces_on;
    tuning_.panic = false;
    tuning_.stops_let_go = stops_known_;
    tuning_.forces_on = wake;
    if (wake) ++tuning_.confirm;
    if (wake && tool_.fault_lasts) return answer(why_no_force_yet(), now_s);
    play(wake ? SoundKind::ForcesOn : SoundKind::ForcesOff, now_s);
    answer(phrase(wake ? "session.forces_on" : "session.forces_off"), now_s);
}

// The answer to the force key while what took the force away is still there.
std::string AppCore::why_no_force_yet() const {
    switch (tool_.fault) {
        case Fault::Unplugged:
            return phrase("session.unplugged");
        case Fault::TooHot:
            return phrase("session.too_warm");
        default:
            return fault_sentence(tool_.fault);
    }
}

// A person is told when a confirmation would bring the force back, where that comes by itself.
void AppCore::notice_faults(double now_s) {
    const bool was_waiting = std::exchange(fault_lasted_, tool_.fault_lasts);
    if (!was_waiting || tool_.fault_lasts || !tool_.fault_latched) return;
    const std::string key = keys_.keys_of(Command::ToggleForces);
    if (tool_.fault == Fault::Unplugged) say(phrase("session.plugged_in_again", {{"key", key}}), SpeechClass::Alarm, now_s);
    if (tool_.fault == Fault::TooHot) say(phrase("session.cooled", {{"key", key}}), SpeechClass::Alarm, now_s);
}

void AppCore::describe_touched(double now_s) {
    if (!hand_.present) return answer(phrase("session.no_hand_to_ask"), now_s);
    if (!two_hands()) return answer(touched_words(tool_), now_s);
    answer(phrase("session.both_hands", {{"right", touched_words(tool_)}, {"left", touched_words(left_tool_)}}), now_s);
}

// A person who asks is told the name at every verbosity, and everything there is to tell on asking again.
std::string AppCore::touched_words(const ToolState& tool) {
    FeatureId& described = &tool == &tool_ ? described_ : left_described_;
    if (tool.contacts.count == 0) {
        described = kNoFeature;
        return phrase("session.touches_nothing");
    }
    const FeatureId id = tool.contacts.contacts[tool.contacts.strongest].feature;
    const int verbosity = std::exchange(described, id) == id ? kTellAll : std::max(kTellName, settings_.speech.verbosity);
    std::string text = describe_feature(*scene_, id, verbosity);
    if (verbosity == kTellAll && settings_.speech.distances_in_steps) text += " " + steps_of_size(scene_->features[id.value], distances());
    return text.empty() ? sentence_case(name_of(id)) : text;
}

void AppCore::place(const Vec3& feet_m, double heading_rad, double now_s) {
    walker_->place(feet_m);
    heading_rad_ = heading_goal_rad_ = wrap_angle(heading_rad);
    pending_way_m_ = since_footstep_m_ = 0.0;
    blocked_ = false;
    path_m_.push_back(walker_->state().feet_m);
    walking_.set_down(walker_->state().feet_m);
    publish_pose(now_s, PoseChange::Placed);
}

void AppCore::go_home(double now_s) {
    place(home_feet_m_, home_heading_rad_, now_s);
    answer(phrase("session.home", {{"compass", compass_word(heading_rad_)}}), now_s);
}

// The hand cannot be moved, so the workspace is: to where the ball fits, as near as there is room. The same for a body that stands in something.
void AppCore::bring_out(double now_s) {
    std::string said;
    const auto workspace_m = [&] { return pose_.origin_m + shift_by_hand_m(); };
    const Vec3 workspace_was = workspace_m();
    const auto how_far = [&](double way_m) {
        const std::string words = distance_words(way_m, distances());
        return is_close_by(way_m, distances()) ? words : phrase("session.away", {{"distance", words}});
    };
    if (body_world_->blocked(feet_m(), walker_->shape())) {
        const auto free = nearest_free_feet(*body_world_, feet_m(), walker_->shape());
        if (free) {
            const double way = glm::length(*free - feet_m());
            keep_place_for_undo();
            place(*free, heading_rad_, now_s);
            said = phrase("session.body_out", {{"distance", how_far(way)}});
        } else {
            said = phrase("session.no_place_to_stand");
        }
    }
    if (hand_.present) {
        const double clearance = 1.2 * tuning_.touch.radius_m;
        const auto poses = std::span(things_.frame().poses).first(things_.frame().count);
        const Vec3 hand = tool_.hip_m + (workspace_m() - workspace_was);
        const Surrounding around = surrounding_of(*haptic_scene_, poses, hand, clearance);
        if (around.distance_m <= 0.0 || (tool_.contacts.ghosted && said.empty())) {
            const auto free = nearest_free_place(*haptic_scene_, poses, hand, clearance, farthest_m());
            if (free) {
                const double way = glm::length(*free - hand);
                hand_shift_m_ += *free - hand;
                publish_pose(now_s, PoseChange::Moved);
                if (!said.empty()) said += ' ';
                said += around.feature ? phrase("session.hand_out_of", {{"what", name_of(around.feature)}, {"distance", how_far(way)}})
                                       : phrase("session.hand_out", {{"distance", how_far(way)}});
            } else {
                said += (said.empty() ? "" : " ") + phrase("session.no_place_for_hand");
            }
        }
    }
    answer(said.empty() ? phrase("session.inside_nothing") : said, now_s);
}

// As far as anything can be from a hand in this world.
double AppCore::farthest_m() const { return 10.0 + (scene_->bounds_m.empty() ? 0.0 : glm::length(scene_->bounds_m.size_m())); }

// The same world with something added or removed: everything else goes on.
void AppCore::change_world(Scene scene, double now_s) {
    scene_ = std::make_shared<const Scene>(std::move(scene));
    retune();
    feel_scene(now_s);
}

// Makes anew what is felt and walked of the scene.
void AppCore::feel_scene(double now_s) {
    compile(haptic_scene_->world);
    things_.enter(*scene_, *haptic_scene_, compiled_plan_, now_s);
    movers_.follow(scene_->movers);
    rebuild_body_world();
}

void AppCore::rebuild_body_world() {
    const WalkerState stood = walker_->state();
    walker_.reset();
    body_world_ = std::make_unique<BodyWorld>(scene_, things_.all());
    walker_ = std::make_unique<Walker>(*body_world_, body_size(*scene_, settings_.walk.body_radius_m));
    walker_->resume(stood);
}

// The world with its things where they are now.
Scene AppCore::world_now() const {
    Scene now = *scene_;
    for (std::size_t i = 0; i < things_.size(); ++i) move_placed(now, i, things_.at(i));
    // An open door is still found in its doorway, wherever its leaf is.
    for (std::uint32_t i = 0; i < now.movers.size(); ++i) {
        Feature& feature = now.features[now.movers[i].feature.value];
        if (feature.kind == FeatureKind::Door && thing_of_mover_[i] >= 0)
            feature.bounds_m.include(placed_bounds(now.placed[static_cast<std::size_t>(thing_of_mover_[i])].model->bounds_m, movers_.at_rest(i)));
    }
    return now;
}

Result<void> AppCore::add_thing(const std::string& name, std::shared_ptr<const Scene> model, const Placement& at, const std::string& material, double now_s) {
    if (!scene_) return fail(phrase("session.no_world"));
    if (scene_->placed.size() >= HapticScene::kMostBodies) return fail(phrase("session.too_many_things", {{"count", scene_->placed.size()}}));
    auto changed = with_placed(world_now(), name, std::move(model), at, material);
    if (!changed) return tl::unexpected(changed.error());
    change_world(std::move(*changed), now_s);
    return {};
}

Result<void> AppCore::remove_thing(const std::string& name, double now_s) {
    if (!scene_) return fail(phrase("session.no_world"));
    auto changed = without_placed(world_now(), name);
    if (!changed) return tl::unexpected(changed.error());
    change_world(std::move(*changed), now_s);
    return {};
}

Result<void> AppCore::send_thing(const std::string& name, const Placement& to, double speed_m_per_s) {
    const int thing = scene_ ? find_placed(*scene_, name) : -1;
    if (thing < 0) return fail(phrase("session.none_to_move", {{"name", name}}));
    if (!is_finite(to.position_m) || !std::isfinite(to.scale) || !(to.scale > 0.0) || !(speed_m_per_s > 0.0) || !std::isfinite(speed_m_per_s))
        return fail(phrase("session.way_needs", {{"name", name}}));
    Placement there = to;
    there.rotation = normalized(to.rotation);
    things_.send(static_cast<std::size_t>(thing), there, speed_m_per_s);
    return {};
}

std::optional<Placement> AppCore::thing_at(const std::string& name) const {
    const int thing = scene_ ? find_placed(*scene_, name) : -1;
    if (thing < 0) return std::nullopt;
    return things_.at(static_cast<std::size_t>(thing));
}

void AppCore::move_hand(const Vec3& by_device_m) {
    if (!is_finite(by_device_m)) return;
    hand_target_m_ += by_device_m;
    const double reach = hand_.present ? hand_.spec.workspace_radius_m : 0.0;
    const double length = glm::length(hand_target_m_);
    if (length > reach) hand_target_m_ *= reach / length;
}

void AppCore::move_hand_by_keys(double dt_s) {
    const auto sign = [&](Command plus, Command minus) { return (held(plus) ? 1.0 : 0.0) - (held(minus) ? 1.0 : 0.0); };
    const Vec3 way{sign(Command::HandRight, Command::HandLeft), sign(Command::HandForward, Command::HandBack), sign(Command::HandUp, Command::HandDown)};
    if (way != Vec3(0.0)) move_hand(way * (kHandKeySpeed_m_per_s * dt_s));
}

void AppCore::tick(double now_s, const ToolState& tool, const ToolState& left_tool) {
    tool_ = tool;
    left_tool_ = left_tool;
    if (!scene_) return;
    const double dt_s = std::clamp(now_s - last_tick_s_, 0.0, 0.1);
    last_tick_s_ = now_s;
    tick_desk(now_s);
    if (at_desk()) {
        // The world waits: nothing moves, walks or turns.
        move_hand_by_keys(dt_s);
        notice_faults(now_s);
        publish_pose(now_s, PoseChange::Walked);
        return;
    }
    play_movers(now_s, dt_s);
    if (const bool arrived = things_.tick(now_s, dt_s); arrived || movers_arrived_) {
        movers_arrived_ = false;
        // From now on it is seen where it is, as soon as everything stands still again.
        if (!things_.moving() && !movers_.any_moving()) {
            scene_ = std::make_shared<const Scene>(world_now());
            movers_.follow(scene_->movers);
        }
        rebuild_body_world();
    } else if (things_.moving() || movers_.any_moving()) {
        rebuild_body_world();
    }
    if (dt_s > 0.0) {
        turn(now_s, dt_s);
        if (held(Command::TurnLeft) != held(Command::TurnRight) && now_s - last_turn_repeat_s_ >= kTurnRepeat_s)
            act(held(Command::TurnLeft) ? Command::TurnLeft : Command::TurnRight, now_s);
        const double tilt = (held(Command::TiltUp) ? 1.0 : 0.0) - (held(Command::TiltDown) ? 1.0 : 0.0);
        tilt_rad_ = std::clamp(tilt_rad_ + tilt * kTiltRate_rad_per_s * dt_s, -kMostTilt_rad, kMostTilt_rad);
        move_hand_by_keys(dt_s);
        walk(now_s, dt_s);
    }
    notice_faults(now_s);
    run_lesson(now_s);
    push_workspace(now_s);
    notice_workspace(now_s);
    notice_volumes(now_s);
    if (rooms_ && rooms_->done() && rooms_->found()) say_room_names(rooms_->graph());
    know_leaves();
    notice_room(now_s, false);
    notice_openings(now_s);
    follow_on(now_s);
    tone_of_walls(now_s);
    soundscape_.tick(*body_world_, listener().ears_m, now_s, cues_);
    tick_guiding(now_s);
    publish_pose(now_s, PoseChange::Walked);
    const double contact_s = contact_before_s_ + tool.contact_s;
    if (contact_s >= (breaks_told_ + 1.0) * kBreakEvery_s) {
        breaks_told_ = std::floor(contact_s / kBreakEvery_s);
        say(phrase("session.take_a_break", {{"time", minutes_words(contact_s)}}), SpeechClass::Ambient, now_s);
    }
}

void AppCore::steer(const Steering& steering) {
    const auto share = [](double value) { return std::isfinite(value) ? std::clamp(value, -1.0, 1.0) : 0.0; };
    steering_ = {share(steering.ahead), share(steering.right), share(steering.turn_right)};
}

// A stick turns as far as it is pushed and long; which way one faces is told when it comes to rest.
void AppCore::turn(double now_s, double dt_s) {
    const double free_keys = (held(Command::FreeRight) ? 0.5 : 0.0) - (held(Command::FreeLeft) ? 0.5 : 0.0);
    const double free_turn = steering_.turn_right + free_keys;
    if (free_turn != 0.0) heading_goal_rad_ = wrap_angle(heading_goal_rad_ + free_turn * kStickTurnRate_rad_per_s * dt_s);
    const double left = wrap_angle(heading_goal_rad_ - heading_rad_);
    const double most = kTurnRate_rad_per_s * dt_s;
    heading_rad_ = std::abs(left) <= most ? heading_goal_rad_ : wrap_angle(heading_rad_ + std::copysign(most, left));
    if (std::exchange(stick_turns_, free_turn != 0.0) && !stick_turns_)
        answer(free_keys_told_ ? phrase("session.compass_degrees",
                                        {{"compass", sentence_case(compass_word(heading_goal_rad_))}, {"degrees", whole_degrees(heading_goal_rad_)}})
                               : sentence_case(compass_word(heading_goal_rad_)),
               now_s);
    free_keys_told_ = free_keys != 0.0;
}

double AppCore::passage_width_m() const { return scene_ ? free_space(*body_world_, feet_m(), kLookHeight_m, heading_rad_).width_m : 0.0; }

void AppCore::walk(double now_s, double dt_s) {
    const double keys = (held(Command::Forward) ? 1.0 : 0.0) - (held(Command::Back) ? 1.0 : 0.0);
    double way = 0.0;  // this tick, signed along the heading
    const double stride = settings_.walk.speed_m_per_s * dt_s;
    if (keys != 0.0) way = keys * stride;
    else way = std::clamp(pending_way_m_, -stride, stride);
    if (way * pending_way_m_ > 0.0) pending_way_m_ -= std::copysign(std::min(std::abs(way), std::abs(pending_way_m_)), pending_way_m_);

    Vec3 wish = forward_of_heading(heading_rad_) * (way / dt_s);
    // A stick goes as fast as it is pushed, sideways too, never faster than a key.
    if (way == 0.0 && (steering_.ahead != 0.0 || steering_.right != 0.0)) {
        const Vec3 pushed = forward_of_heading(heading_rad_) * steering_.ahead + forward_of_heading(heading_rad_ + kPi / 2.0) * steering_.right;
        wish = pushed * (settings_.walk.speed_m_per_s / std::max(1.0, glm::length(pushed)));
        way = glm::length(wish) * dt_s;
    }
    if (const auto lead = lead_walk(now_s, dt_s)) {
        wish = *lead;
        way = glm::length(wish) * dt_s;
    }
    const WalkerState stood = walker_->state();
    WalkResult walked = walker_->tick(wish, dt_s);
    if (held_at_edge(stood, now_s)) walked.walked_m = 0.0, walked.ground = ground_, walked.bump.reset();
    notice_ground(stood.feet_m, walked, now_s);
    if (walked.bump) learning_.notes.touched(feet_m() - walked.bump->normal * walker_->size().radius_m, walked.bump->normal, walker_->size().radius_m);
    note_learning(now_s);
    const Vec3 feet = feet_m();
    if (glm::length(feet - path_m_.back()) > 0.25) {
        if (path_m_.size() >= kMostPathPoints) path_m_.erase(path_m_.begin(), path_m_.begin() + kMostPathPoints / 4);
        path_m_.push_back(feet);
    }

    since_footstep_m_ += walked.walked_m;
    // Each riser is a step, up and down.
    const bool riser = walked.landed || walked.climbed_m > 0.1 || (stood.on_ground && walker_->state().on_ground && stood.feet_m.z - feet.z > 0.1);
    if (since_footstep_m_ >= settings_.walk.step_length_m - 1e-6 || riser) {
        since_footstep_m_ = std::max(0.0, since_footstep_m_ - settings_.walk.step_length_m);
        if (riser) since_footstep_m_ = 0.0;
        CueRequest step;
        step.kind = CueRequestKind::Footstep;
        step.time_s = now_s;
        step.material = scene_->material(walked.ground_material).sound;
        step.feature = walked.ground;
        step.pitch = walking_.step_pitch;
        step.position_m = feet;
        cue(std::move(step));
    }
    ground_ = walked.ground;
    if (walked.landed) say(phrase("session.fell", {{"metres", walked.fell_m}}), SpeechClass::Answer, now_s);

    if (walked.bump && !(led() && walked.walked_m > 0.0)) {
        pending_way_m_ = 0.0;
        if (!blocked_) {
            since_footstep_m_ = 0.0;
            CueRequest bump;
            bump.kind = CueRequestKind::Bump;
            bump.time_s = now_s;
            bump.feature = walked.bump->feature;
            bump.material = scene_->material(walked.bump->material).sound;
            bump.position_m = feet + Vec3(0.0, 0.0, kLookHeight_m) - walked.bump->normal * walker_->size().radius_m;
            bumped_.push_back(bump.feature);
            cue(std::move(bump));
            if (const int met = mover_of(walked.bump->feature); met >= 0 && scene_->features[walked.bump->feature.value].kind == FeatureKind::Button)
                press_mover(static_cast<std::uint32_t>(met), false, now_s);  // in games a button is walked against
            if (!lock_words(walked.bump->feature).empty()) tell_shut_door(walked.bump->feature, now_s);
        }
        blocked_ = true;
    } else if (way != 0.0 && walked.walked_m > 0.9 * std::abs(way)) {
        blocked_ = false;
    }
    // Out of the world: back to the base instead of falling for ever.
    if (!scene_->bounds_m.empty() && feet.z < scene_->bounds_m.min_m.z - 20.0) {
        say(phrase("session.fell_out"), SpeechClass::Answer, now_s);
        go_home(now_s);
    }
}

void AppCore::notice_volumes(double now_s) {
    std::vector<FeatureId> now = body_world_->volumes_at(feet_m(), walker_->size().height_m, SolidRole::Trigger);
    for (const FeatureId liquid : body_world_->volumes_at(feet_m(), walker_->size().height_m, SolidRole::Liquid)) now.push_back(liquid);
    for (const FeatureId id : now) {
        const Feature* feature = scene_->find(id);
        if (feature && std::find(inside_.begin(), inside_.end(), id) == inside_.end()) meet_switch(id, now_s);
        if (!feature || std::find(inside_.begin(), inside_.end(), id) != inside_.end()) continue;
        if (feature->kind == FeatureKind::Liquid) {
            CueRequest splash;
            splash.kind = CueRequestKind::Play;
            splash.sound = SoundKind::Splash;
            splash.material = SoundClass::Water;
            splash.time_s = now_s;
            splash.position_m = feet_m();
            cue(std::move(splash));
            say(sentence_case(name_of(id)), SpeechClass::Contact, now_s);
        } else if (!feature->message.empty() && std::find(told_triggers_.begin(), told_triggers_.end(), id) == told_triggers_.end()) {
            told_triggers_.push_back(id);
            say(spoken_message(*feature), SpeechClass::Answer, now_s);
        }
    }
    inside_ = std::move(now);
}

void AppCore::tone_of_walls(double now_s) {
    double loudness = 0.0;
    Vec3 place = feet_m();
    if (settings_.sound.wall_tone && !tuning_.panic) {
        const double radius = walker_->size().radius_m;
        const auto wall = nearest_ahead(*body_world_, feet_m(), kLookHeight_m, heading_rad_, radius + kToneRange_m);
        if (wall) {
            loudness = std::clamp(1.0 - (wall->distance_m - radius) / kToneRange_m, 0.0, 1.0);
            place = wall->point_m;
        }
    }
    if (loudness == tone_loudness_) return;
    tone_loudness_ = loudness;
    CueRequest tone;
    tone.kind = CueRequestKind::WallTone;
    tone.time_s = now_s;
    tone.loudness = loudness;
    tone.position_m = place;
    cue(std::move(tone));
}

// Each servo lays its own hand's shift on the pose; the other hand's comes with it.
WorkspacePose AppCore::pose_beside(const Vec3& others_shift_m) const {
    WorkspacePose pose = pose_;
    pose.origin_m += others_shift_m;
    return pose;
}

void AppCore::set_left_hand(const HandFacts& hand, double now_s) {
    left_hand_ = hand;
    left_tool_ = {};
    if (scene_) publish_pose(now_s, PoseChange::Moved);
}

ServoTuning AppCore::left_tuning() const {
    ServoTuning tuning = tuning_;
    tuning.touch.rated_stiffness_n_per_m = left_hand_.spec.rated_stiffness_n_per_m;
    tuning.force_ceiling_n = ceiling_n(left_hand_);
    tuning.workspace.grab_key = false;  // the key is the right hand's, the button each hand's own
    tuning.workspace.push_hand_m_per_s = Vec3(0.0);
    tuning.personal_space = tuning.workspace.rim_open_behind = false;  // the desk is the right hand's
    return tuning;
}

double AppCore::workspace_heading_rad() const {
    const double frame = settings_.workspace.frame == FrameChoice::Walk ? heading_rad_ : 0.0;
    return frame + radians_from_degrees(settings_.workspace.turn_deg);
}

// Where the middle of the workspace belongs, before anything has moved it.
Vec3 AppCore::workspace_origin_m() const {
    const Settings::Workspace& workspace = settings_.workspace;
    Vec3 origin = workspace.follows_walk ? feet_m() : anchor_feet_m_;
    if (named_scale_ == NamedScale::Building && !scene_->bounds_m.empty()) {
        const Vec3 centre = scene_->bounds_m.centre_m();
        origin = Vec3(centre.x, centre.y, origin.z);
    } else {
        origin += forward_of_heading(workspace_heading_rad()) * (workspace.offset_ahead_m * scale());
    }
    return origin + Vec3(0.0, 0.0, workspace.hand_height_m + workspace.offset_up_m * scale());
}

// Walked: the body may have gone a little way. Moved: the workspace jumps, from where the hand had moved it to. Placed: it is where it belongs again.
void AppCore::publish_pose(double now_s, PoseChange change) {
    if (change == PoseChange::Moved) hand_shift_m_ += shift_by_hand_m();
    if (change == PoseChange::Placed) {
        hand_shift_m_ = Vec3(0.0);
        anchor_feet_m_ = feet_m();
    }
    pose_.heading_rad = workspace_heading_rad();
    pose_.origin_m = workspace_origin_m() + hand_shift_m_;
    pose_.time_s = now_s;
    if (change == PoseChange::Walked) return;
    ++pose_.jump;
    let_go_of_world();
}

// Changes scale or heading of the workspace so that the place under the hand stays there; out of whatever it would be inside.
template <class Change>
void AppCore::change_under_hand(Change change, double now_s) {
    const bool known = tool_.ticks > 0 && tool_.workspace_jump == pose_.jump;
    const Vec3 place_m = tool_.proxy_m;
    const bool keeps_place = change() && known;
    retune();
    adapt_touch(now_s);
    const auto hand_m = [&](const Vec3& origin_m) { return frame_of(origin_m, workspace_heading_rad()).to_world(tool_.hand_m, scale()); };
    Vec3 shift{0.0};
    if (keeps_place) shift = place_m - hand_m(workspace_origin_m());
    shift += hands_out_of_solids_m(workspace_origin_m() + shift);
    hand_shift_m_ = shift - shift_by_hand_m();
    publish_pose(now_s, PoseChange::Moved);
}

void AppCore::zoom(NamedScale scale_name, double now_s) {
    if (!hand_.present) return answer(no_hand(), now_s);
    change_under_hand(
        [&] {
            named_scale_ = scale_name;
            return scale_name != NamedScale::Building;  // that has its own place, round the whole building
        },
        now_s);
    const std::string words = scale_sentence(scale_name, scale(), hand_.spec.workspace_radius_m, distances()), news = simplified_news();
    answer(news.empty() ? words : words + ". " + news, now_s);
}

// Settings with another scale; the place under the hand stays there.
void AppCore::rescale(const Settings& changed, double now_s) {
    const auto change = [&] {
        settings_ = changed;
        named_scale_.reset();
        return true;
    };
    if (scene_) change_under_hand(change, now_s);
    else change();
}

// Settings by which the hand feels the same place otherwise.
void AppCore::feel_otherwise(const Settings& changed, double now_s) {
    const auto change = [&] {
        settings_ = changed;
        return true;
    };
    change_under_hand(change, now_s);
    if (std::string news = simplified_news(); !news.empty()) say(std::move(news), SpeechClass::Ambient, now_s);
}

void AppCore::turn_workspace(double by_deg, double now_s) {
    if (!hand_.present) return answer(no_hand(), now_s);
    change_under_hand(
        [&] {
            const double turned_rad = radians_from_degrees(settings_.workspace.turn_deg + by_deg);
            settings_.workspace.turn_deg = std::round(degrees_from_radians(wrap_angle(turned_rad)) * 1e6) / 1e6;
            return true;
        },
        now_s);
    const double deg = settings_.workspace.turn_deg;
    setting_changes_.emplace_back("workspace.turn_deg", fmt::format("{}", deg));
    play(SoundKind::TurnTick, now_s);
    answer(deg == 0.0 ? phrase("session.workspace_straight")
                      : phrase(deg > 0.0 ? "session.workspace_turned_right" : "session.workspace_turned_left", {{"degrees", std::abs(deg)}}),
           now_s);
}

void AppCore::push_workspace(double now_s) {
    Vec3 way = push_way([&](Command one) { return held(one); });
    if (way == Vec3(0.0) && now_s < push_until_s_) way = push_tap_;
    if (way != Vec3(0.0)) guiding_.moved_s = now_s;
    const Vec3 carried = carry_workspace();  // where the hand is led out of its reach
    tuning_.workspace.push_hand_m_per_s = way == Vec3(0.0) ? carried : way * kPushSpeed_hand_m_per_s;
}

// Tells when the workspace has come to rest, and when it can go no farther.
void AppCore::notice_workspace(double now_s) {
    const WorkspaceMotion now = tool_.workspace_motion != WorkspaceMotion::Still ? tool_.workspace_motion : left_tool_.workspace_motion;
    const WorkspaceMotion before = std::exchange(motion_told_, now);
    if (before != motion_told_ && motion_told_ == WorkspaceMotion::Still && !std::exchange(guiding_.carried, guiding_.carries))
        say(workspace_words(), before == WorkspaceMotion::Scrolled ? SpeechClass::Ambient : SpeechClass::Answer, now_s);
    if (std::exchange(limit_told_, tool_.workspace_at_limit || left_tool_.workspace_at_limit) || !limit_told_) return;
    play(SoundKind::Denied, now_s);
    say(phrase("session.world_ends"), SpeechClass::Ambient, now_s);
}

std::string AppCore::workspace_words() const {
    const Vec3 from_body = hand_shift_m_ + shift_by_hand_m() + workspace_origin_m() - feet_m();
    const Vec3 level(from_body.x, from_body.y, 0.0);
    const double up_m = from_body.z - settings_.workspace.hand_height_m - settings_.workspace.offset_up_m * scale();
    const double away_m = glm::length(level);
    const std::string place = place_words(away_m, std::atan2(level.x, level.y), heading_rad_, settings_.speech.directions, distances());
    const std::string text =
        away_m < 0.5 * settings_.walk.step_length_m ? phrase("session.workspace_round_you") : phrase("session.workspace_at", {{"place", place}});
    if (std::abs(up_m) < 0.25) return text;
    return joined(text, phrase(up_m > 0.0 ? "session.up" : "session.down", {{"distance", distance_words(std::abs(up_m), {false, 1.0})}}));
}

void AppCore::play(SoundKind kind, double now_s) {
    CueRequest sound;
    sound.kind = CueRequestKind::Play;
    sound.sound = kind;
    sound.time_s = now_s;
    sound.position_m = listener().ears_m;
    cue(std::move(sound));
}

Listener AppCore::listener() const {
    return {feet_m() + Vec3(0.0, 0.0, walker_ ? walker_->size().eye_height_m : 1.6), heading_rad_, soundscape_.reverberation_s()};
}

ViewState AppCore::view(const ToolState& tool, const std::string& last_spoken) const {
    ViewState view;
    view.scene = scene_;
    view.feet_m = feet_m();
    view.eyes_m = view.feet_m + Vec3(0.0, 0.0, walker_->size().eye_height_m);
    view.heading_rad = heading_rad_;
    view.tilt_rad = tilt_rad_;
    view.show_hand = hand_.present;
    view.proxy_m = tool.proxy_m;
    view.ball_radius_m = tool.ball_radius_m;
    view.touching = tool.contacts.count > 0;
    view.plan_view = plan_view_;
    view.forces_on = tuning_.forces_on && tuning_.focused && !tuning_.panic;
    view.north_up = settings_.workspace.frame == FrameChoice::Map;
    view.last_spoken = last_spoken;
    view.path_m = path_m_;
    if (plan_view_) view.rooms = drawn_rooms_, view.room = room_;
    view.dialogue = dialogue_.view();
    return view;
}

}  // namespace handrail
