#include "app/core/walking/walking.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/dialogue/words.h"
#include "app/core/world/holding_place.h"
#include "app/core/world/questions.h"
#include "app/core/world/surroundings.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/scene/surfaces.h"

namespace handrail::core {
namespace {

// 150 degrees a second. At scale 60, a hand at the rim of the workspace then moves relative to the world as if at 10
// cm/s.
constexpr double kTurnRate_rad_per_s = 2.6;
constexpr double kStickTurnRate_rad_per_s = 1.6;  // 90 degrees a second at full deflection of the stick
constexpr double kTurnRepeat_s = 0.4;
constexpr double kFreeTurn_rad = 5.0 * kPi / 180.0;
constexpr double kTiltRate_rad_per_s = 0.8;
constexpr double kMostTilt_rad = 1.2;
constexpr double kToneRange_m = 2.0;
// If a person has stood this long without moving more than kStands_m, the wall tone is silent, because the person knows
// the wall.
constexpr double kToneStanding_s = 3.0, kStands_m = 0.01;
// Delay between a turn and the announcement of the heading. A further turn starts the delay again, so that one heading
// is announced for several turns.
constexpr double kHeadingAnnounced_s = 0.1;
constexpr double kRests_s = 0.1;  // the walker is at rest once it has not moved for this long
constexpr double kSameBase_m = 0.5;
constexpr double kPathPoint_m = 0.25;
constexpr std::size_t kMostPathPoints = 4000;

}  // namespace

void Walking::stand() {
    halt();
    hovers_ = false;
    since_footstep_m_ = 0.0;
    gait_.begin();
    blocked_ = false;
    brushed_ = {};  // The last contact may belong to another world, so it is forgotten.
    heading_due_s_.reset();
    paces_.begin();
}

void Walking::enter_world() {
    path_m_.assign(1, avatar_.feet_m());
    by_ear_.enter_world();
    footing_.enter_world();
    stand();
}

void Walking::set_down(const Vec3& feet_m, double heading_rad) {
    contract_pre(is_finite(feet_m) && std::isfinite(heading_rad));
    avatar_.walker->place(feet_m);
    avatar_.heading_rad = avatar_.heading_goal_rad = wrap_angle(heading_rad);
    stand();
    path_m_.push_back(avatar_.feet_m());
    by_ear_.set_down();
    footing_.set_down();
}

void Walking::go_home(double now_s) {
    context_.session_requests.place(context_.world.home_feet_m, context_.world.home_heading_rad, now_s);
    context_.answer(phrase("session.home", {{"compass", fine_compass_word(avatar_.heading_rad)}}), now_s);
}

std::string Walking::bring_out(double now_s) {
    const WalkerWorld& solids = *context_.world.solids;
    if (!solids.blocked(avatar_.feet_m(), avatar_.walker->shape())) return {};
    const auto free = nearest_free_feet(solids, avatar_.feet_m(), avatar_.walker->shape());
    if (!free) return phrase("session.no_place_to_stand");
    const double way_m = glm::length(*free - avatar_.feet_m());
    by_ear_.keep_place();
    context_.session_requests.place(*free, avatar_.heading_rad, now_s);
    return phrase("session.body_out", {{"distance", how_far_words(context_, way_m)}});
}

void Walking::steer(const Steering& steering) {
    const auto share = [](double value) { return std::isfinite(value) ? std::clamp(value, -1.0, 1.0) : 0.0; };
    steering_ = {share(steering.ahead), share(steering.right), share(steering.turn_right)};
}

void Walking::fall_silent() {
    halt();
    tone_.loudness = 0.0;
}

bool Walking::idle() const {
    return pending_.ahead_m == 0.0 && pending_.right_m == 0.0 && gait_.aside_left_m() == 0.0 &&
           (!avatar_.walker || avatar_.walker->state().on_ground || hovers_) && !by_ear_.leads() &&
           avatar_.heading_rad == avatar_.heading_goal_rad;
}

double Walking::passage_width_m() const {
    return context_.world.scene
               ? free_space(*context_.world.solids, avatar_.feet_m(), kLookHeight_m, avatar_.heading_rad).width_m
               : 0.0;
}

void Walking::notice(Command command, double now_s) {
    by_ear_.notice(command);
    footing_.notice(command, now_s);
}

bool Walking::act(Command command, double now_s, int times) {
    notice(command, now_s);
    if (by_ear_.act(command, now_s, times)) return true;
    const double notch_rad = radians_from_degrees(context_.settings.walk.turn_deg);
    switch (command) {
        case Command::Forward:
        case Command::Back:
            step(pending_.ahead_m, command == Command::Forward ? 1.0 : -1.0, times);
            return true;
        case Command::SideRight:
        case Command::SideLeft:
            step(pending_.right_m, command == Command::SideRight ? 1.0 : -1.0, times);
            return true;
        case Command::TurnLeft:
        case Command::TurnRight:
            turn_by(command == Command::TurnRight ? notch_rad : -notch_rad, times, now_s);
            return true;
        case Command::FreeLeft:
        case Command::FreeRight:
            avatar_.heading_goal_rad =
                wrap_angle(avatar_.heading_goal_rad + (command == Command::FreeLeft ? -kFreeTurn_rad : kFreeTurn_rad));
            return true;
        case Command::TiltUp:  // These keys act while they are held, so nothing is done when they are pressed.
        case Command::TiltDown:
            return true;
        case Command::Home:
            by_ear_.keep_place();
            go_home(now_s);
            return true;
        default:
            return false;
    }
}

void Walking::step(double& pending_m, double sign, int times) {
    const double left_m = std::max(0.0, pending_m * sign);
    halt();
    pending_m = sign * more_to_go_m(left_m, context_.settings.walk.step_length_m, times);
    if (left_m == 0.0) gait_.begin();
    blocked_ = false;
}

void Walking::face(double heading_rad, double now_s) {
    avatar_.heading_goal_rad = wrap_angle(heading_rad);
    context_.play(cues::SoundKind::TurnTick, now_s);
    heading_due_s_.reset();
    context_.answer(sentence_case(fine_compass_word(avatar_.heading_goal_rad)), now_s);
}

// Turns to the next notch in the direction of `by_rad`, or by `times` notches.
void Walking::turn_by(double by_rad, int times, double now_s) {
    const double notch_rad = std::abs(by_rad);
    const double goal_rad = std::round((avatar_.heading_goal_rad + by_rad) / notch_rad) * notch_rad;
    avatar_.heading_goal_rad = wrap_angle(goal_rad + (times - 1) * by_rad);
    last_turn_repeat_s_ = now_s;
    context_.cues.cue(
        sound_at(cues::SoundKind::TurnTick, avatar_.ears_m() + forward_of_heading(avatar_.heading_goal_rad), now_s));
    heading_due_s_ = now_s + kHeadingAnnounced_s;
}

void Walking::announce_heading(double now_s) {
    if (!heading_due_s_ || now_s < *heading_due_s_) return;
    heading_due_s_.reset();
    context_.announce(cues::SpeechTopic::Heading, sentence_case(fine_compass_word(avatar_.heading_goal_rad)), now_s);
}

void Walking::tick(double now_s, double dt_s) {
    contract_pre(std::isfinite(now_s) && dt_s >= 0.0);
    turn(now_s, dt_s);
    announce_heading(now_s);
    if (keys_.held(Command::TurnLeft) != keys_.held(Command::TurnRight) && now_s - last_turn_repeat_s_ >= kTurnRepeat_s)
        act(keys_.held(Command::TurnLeft) ? Command::TurnLeft : Command::TurnRight, now_s);
    const double tilt = keys_.sign(Command::TiltUp, Command::TiltDown);
    tilt_rad_ = std::clamp(tilt_rad_ + tilt * kTiltRate_rad_per_s * dt_s, -kMostTilt_rad, kMostTilt_rad);
    walk(now_s, dt_s);
}

// Turns by keys and stick. The rate is in proportion to the deflection of the stick, and the heading is announced when
// the stick is at rest again.
void Walking::turn(double now_s, double dt_s) {
    const double free_keys = 0.5 * keys_.sign(Command::FreeRight, Command::FreeLeft);
    const double free_turn = steering_.turn_right + free_keys;
    if (free_turn != 0.0)
        avatar_.heading_goal_rad = wrap_angle(avatar_.heading_goal_rad + free_turn * kStickTurnRate_rad_per_s * dt_s);
    const double left = wrap_angle(avatar_.heading_goal_rad - avatar_.heading_rad);
    const double most = kTurnRate_rad_per_s * dt_s;
    avatar_.heading_rad =
        std::abs(left) <= most ? avatar_.heading_goal_rad : wrap_angle(avatar_.heading_rad + std::copysign(most, left));
    if (std::exchange(stick_turns_, free_turn != 0.0) && !stick_turns_)
        context_.announce(cues::SpeechTopic::Heading,
                          free_keys_announced_
                              ? phrase("session.compass_degrees",
                                       {{"compass", sentence_case(fine_compass_word(avatar_.heading_goal_rad))},
                                        {"degrees", whole_degrees(avatar_.heading_goal_rad)}})
                              : sentence_case(fine_compass_word(avatar_.heading_goal_rad)),
                          now_s);
    free_keys_announced_ = free_keys != 0.0;
}

// Returns the velocity in metres per second that keys, taps and sticks request for this tick. `way_m` receives the
// distance of the tick.
Vec3 Walking::own_velocity(double& way_m, double dt_s) {
    const double speed = context_.settings.walk.speed_m_per_s, stride = speed * dt_s;
    const Vec3 ahead = forward_of_heading(avatar_.heading_rad), right = right_of_heading(avatar_.heading_rad);
    const double keys = keys_.sign(Command::Forward, Command::Back),
                 side_keys = keys_.sign(Command::SideRight, Command::SideLeft);
    const auto by = [&](const Vec3& towards, double signed_m) {
        way_m = std::abs(signed_m);
        return towards * (signed_m / dt_s);
    };
    if (keys != 0.0) return by(ahead, keys * stride);
    if (pending_.ahead_m != 0.0) return by(ahead, std::clamp(pending_.ahead_m, -stride, stride));
    if (side_keys != 0.0) return by(right, side_keys * stride);
    if (pending_.right_m != 0.0) return by(right, std::clamp(pending_.right_m, -stride, stride));
    if (steering_.ahead == 0.0 && steering_.right == 0.0) return Vec3(0.0);
    // The speed is in proportion to the deflection of the stick, also sideways, but never higher than the speed of a
    // key.
    const Vec3 pushed = ahead * steering_.ahead + right * steering_.right;
    const Vec3 intended = pushed * (speed / std::max(1.0, glm::length(pushed)));
    way_m = glm::length(intended) * dt_s;
    return intended;
}

void Walking::take_from_pending(double way_m) {
    for (double* pending_m : {&pending_.ahead_m, &pending_.right_m}) {
        const double left_m = std::abs(*pending_m) - way_m;
        *pending_m = left_m > 1e-9 ? std::copysign(left_m, *pending_m) : 0.0;
    }
}

void Walking::walk(double now_s, double dt_s) {
    double way = 0.0;  // distance of this tick
    Vec3 intended = own_velocity(way, dt_s);
    if (hovers_) return hover(way != 0.0, now_s);
    const bool by_itself = by_ear_.leads();
    if (way == 0.0) gait_.stand();
    if (way != 0.0 && !went_ && pending_.ahead_m == 0.0 && pending_.right_m == 0.0) gait_.begin();
    went_ = way != 0.0;
    // If the walker has met the frame of a doorway, it first slides sideways into the doorway.
    const double aside_m = by_itself || way == 0.0 ? 0.0 : gait_.aside_left_m();
    const Vec3 own = intended;
    if (aside_m != 0.0) {
        way = std::min(std::abs(aside_m), context_.settings.walk.speed_m_per_s * dt_s);
        intended = right_of_heading(std::atan2(own.x, own.y)) * std::copysign(way / dt_s, aside_m);
    }
    if (const auto lead = by_ear_.lead(now_s, dt_s)) {
        intended = *lead;
        way = glm::length(intended) * dt_s;
    }
    const bool gives_way = push_ahead && push_ahead(intended, now_s);
    const WalkerMotion stood = avatar_.walker->state();
    WalkResult walked = avatar_.walker->tick(intended, dt_s);
    const bool at_edge = footing_.held_at_edge(stood, paces_, now_s);
    if (at_edge) {
        halt();
        by_ear_.halt();
        walked.walked_m = 0.0;
        walked.ground = avatar_.ground;
        walked.bump.reset();
        walked.met.reset();
        walked.held_at_edge = true;
    }
    if (walked.met) brushed_.met = walked.met;
    if (avatar_.walker->state().on_ground && !context_.hands.tuning.panic) {
        by_ear_.lay_crumb();
        footing_.tick(stood.feet_m, walked, now_s);
    }
    if (on_walked) on_walked(walked, now_s);
    const Vec3 feet = avatar_.feet_m();
    if (glm::length(feet - path_m_.back()) > kPathPoint_m) {
        if (path_m_.size() >= kMostPathPoints) path_m_.erase(path_m_.begin(), path_m_.begin() + kMostPathPoints / 4);
        path_m_.push_back(feet);
    }
    announce_step(stood, walked, now_s);
    avatar_.ground = walked.ground;
    if (walked.landed)
        context_.say(phrase("session.fell", {{"metres", walked.fell_m}}), cues::SpeechClass::Answer, now_s);
    if (way != 0.0) paces_.walked(walked.walked_m);
    if (!by_itself && aside_m == 0.0) take_from_pending(stood.on_ground ? walked.walked_m : way);

    const bool stopped = by_itself ? walked.bump && !gives_way && !(by_ear_.leads() && walked.walked_m > 0.0)
                                   : aside_m == 0.0 && !at_edge && !go_on(walked, intended, way, now_s) && !gives_way;
    if (aside_m != 0.0) gait_.went_aside(way, walked.walked_m);
    if (stopped) {
        halt();
        if (!blocked_ && brushed_.met) announce_bump(*brushed_.met, std::atan2(intended.x, intended.y), now_s);
        blocked_ = true;
    } else if (way != 0.0 && walked.walked_m > 0.9 * std::abs(way)) {
        blocked_ = false;
    }
    announce_rest(way != 0.0 || by_ear_.leads(), now_s);
    const Aabb& bounds_m = context_.world.scene->bounds_m;
    if (!bounds_m.empty() && feet.z < bounds_m.min_m.z - kOutOfWorld_m) end_fall(now_s);
}

// Returns a walker that has fallen out of the world to the base. If no ground holds the walker there, moves the base to
// a place that does. Otherwise the walker would fall again and again.
void Walking::end_fall(double now_s) {
    std::vector<Vec3> preferred_m{context_.world.home_feet_m};
    for (const Start& start : context_.world.scene->starts) preferred_m.push_back(start.feet_m);
    const std::optional<Vec3> holds =
        place_that_holds(*context_.world.scene, *context_.world.solids, avatar_.walker->size(), preferred_m);
    if (!holds) {
        context_.say(phrase("session.nothing_holds"), cues::SpeechClass::Answer, now_s);
        context_.session_requests.place(context_.world.home_feet_m, context_.world.home_heading_rad, now_s);
        hovers_ = true;
        return;
    }
    const Vec3 way_m = *holds - context_.world.home_feet_m;
    const bool base_holds = glm::length(Vec2(way_m)) < kSameBase_m;
    context_.say(phrase(base_holds ? "session.fell_out" : "session.fell_from_base"), cues::SpeechClass::Answer, now_s);
    if (!base_holds) context_.session_requests.move_base(*holds, context_.world.home_heading_rad);
    go_home(now_s);
}

void Walking::hover(bool wants_to_go, double now_s) {
    halt();
    by_ear_.halt();
    if (wants_to_go && !blocked_) context_.answer(phrase("session.nothing_holds"), now_s);
    blocked_ = wants_to_go;
}

// Decides how the walk continues after a contact. Returns false if the contact stops the walk.
bool Walking::go_on(const WalkResult& walked, const Vec3& intended, double way_m, double now_s) {
    if (way_m == 0.0) return true;
    const double way_rad = std::atan2(intended.x, intended.y);
    const auto line_up = [&]() -> std::optional<double> {
        if (!line_up_m || !avatar_.walker->state().on_ground) return std::nullopt;
        return line_up_m(avatar_.feet_m(), way_rad);
    };
    switch (gait_.went(way_m, walked.walked_m, walked.met.has_value(), line_up)) {
        case Gait::Course::On:
            brushed_.slid_m = 0.0;
            return true;
        case Gait::Course::Along:
            announce_slide(*walked.met, walked.walked_m, now_s);
            return true;
        case Gait::Course::Aside:
            announce_frame(now_s);
            return true;
        case Gait::Course::Stopped:
            break;
    }
    return false;
}

// Announces which shoulder met the frame of a doorway: the shoulder away from the doorway.
void Walking::announce_frame(double now_s) {
    if (blocked_) return;
    const bool left = gait_.aside_left_m() > 0.0;
    context_.say(
        phrase("walking.frame", {{"shoulder", phrase(left ? "walking.left_shoulder" : "walking.right_shoulder")}}),
        cues::SpeechClass::Contact, now_s);
}

// Softly plays the sound of the surface along which the walker slides.
void Walking::announce_slide(const TraceHit& met, double way_m, double now_s) {
    constexpr double kHeardEvery_m = 0.3, kLoudness = 0.35;
    const bool begins = brushed_.slid_m == 0.0;
    brushed_.slid_m += way_m;
    if (!begins && brushed_.slid_m < kHeardEvery_m) return;
    brushed_.slid_m = std::max(1e-9, brushed_.slid_m - (begins ? 0.0 : kHeardEvery_m));
    cues::CueRequest brush = sound_at(
        cues::SoundKind::Contact,
        avatar_.feet_m() + Vec3(0.0, 0.0, kLookHeight_m) - met.normal * avatar_.walker->size().radius_m, now_s);
    brush.material = context_.world.scene->material(met.material).sound;
    brush.loudness = kLoudness;
    context_.cues.cue(std::move(brush));
}

void Walking::announce_step(const WalkerMotion& before, const WalkResult& walked, double now_s) {
    const double step_m = context_.settings.walk.step_length_m;
    since_footstep_m_ += walked.walked_m;
    // Each riser plays a footstep, both up and down.
    const bool riser =
        walked.landed || walked.climbed_m > 0.1 ||
        (before.on_ground && avatar_.walker->state().on_ground && before.feet_m.z - avatar_.feet_m().z > 0.1);
    if (since_footstep_m_ < step_m - 1e-6 && !riser) return;
    since_footstep_m_ = riser ? 0.0 : std::max(0.0, since_footstep_m_ - step_m);
    cues::CueRequest cue;
    cue.kind = cues::CueRequestKind::Footstep;
    cue.time_s = now_s;
    cue.material = context_.world.scene->material(walked.ground_material).sound;
    cue.feature = walked.ground;
    cue.pitch = footing_.step_pitch();
    cue.position_m = avatar_.feet_m();
    context_.cues.cue(std::move(cue));
}

// Announces the number of steps once the walker rests. Only a person who types hears the announcement, because a typist
// may hear no footsteps.
void Walking::announce_rest(bool goes, double now_s) {
    if (goes) walked_s_ = now_s;
    if (goes || now_s - walked_s_ < kRests_s) return;
    std::string steps = paces_.take(context_);
    if (!steps.empty() && announces_steps(context_))
        context_.announce(cues::SpeechTopic::Steps, std::move(steps), now_s);
}

void Walking::announce_bump(const TraceHit& met, double way_rad, double now_s) {
    since_footstep_m_ = 0.0;
    cues::CueRequest bump;
    bump.kind = cues::CueRequestKind::Bump;
    bump.time_s = now_s;
    bump.feature = met.feature;
    bump.material = context_.world.scene->material(met.material).sound;
    bump.position_m = avatar_.feet_m() + Vec3(0.0, 0.0, kLookHeight_m) - met.normal * avatar_.walker->size().radius_m;
    const std::string what = met_words(context_, met, way_rad);
    bump.text = paces_.take_blocked(context_, what);
    if (!what.empty()) bump.written = blocked_words(what);
    context_.cues.cue(std::move(bump));
    if (on_bumped) on_bumped(met.feature, now_s);
}

void Walking::announce_walls(double now_s) {
    double loudness = 0.0;
    Vec3 place = avatar_.feet_m();
    if (glm::length(place - tone_.feet_m) > kStands_m || avatar_.heading_rad != tone_.heading_rad)
        tone_ = {tone_.loudness, place, avatar_.heading_rad, now_s};
    const bool stands = now_s - tone_.since_s > kToneStanding_s;
    if (context_.settings.sound.wall_tone && !context_.hands.tuning.panic && !stands) {
        const double radius = avatar_.walker->size().radius_m;
        const auto wall = nearest_ahead(*context_.world.solids, avatar_.feet_m(), kLookHeight_m, avatar_.heading_rad,
                                        radius + kToneRange_m);
        if (wall) {
            loudness = std::clamp(1.0 - (wall->distance_m - radius) / kToneRange_m, 0.0, 1.0);
            place = wall->point_m;
        }
    }
    if (loudness == tone_.loudness) return;
    tone_.loudness = loudness;
    cues::CueRequest tone;
    tone.kind = cues::CueRequestKind::WallTone;
    tone.time_s = now_s;
    tone.loudness = loudness;
    tone.position_m = place;
    context_.cues.cue(std::move(tone));
}

}  // namespace handrail::core
