#include "app/core/walking/by_ear.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/dialogue/brief_words.h"
#include "app/core/walking/paces.h"
#include "app/core/world/hazards.h"
#include "app/core/world/nearest_wall.h"
#include "worlds/base/human_measures.h"
#include "worlds/base/language.h"
#include "worlds/scene/surfaces.h"

namespace handrail::core {
namespace {

constexpr double kCrumb_m = 0.25;
constexpr std::size_t kMostCrumbs = 4000;
constexpr double kSquareReach_m = 3.0;
constexpr double kAnnouncedTurn_rad = 0.7;  // a turn by more than this (40 degrees) is announced
constexpr double kAnnouncedClimb_m = 0.3;   // a change of height by more than this is announced
constexpr double kBeforeStairs_m = 0.35;    // following stops when the walker's edge is this far from the first riser
constexpr double kStairsLookedForEvery_m = 0.1;  // the walker's distance between two searches for stairs
constexpr double kStairsSeen_m = 2.0;            // how far ahead the search examines the ground
// if the ground is level for this distance, the stairs are over, or the walker did not take them
constexpr double kLevelAgain_m = 1.5;

}  // namespace

ByEar::ByEar(const SessionContext& context, WalkerState& avatar, const HeldKeys& keys)
    : SessionPart(context), avatar_(avatar), keys_(keys) {}

void ByEar::enter_world() {
    leaping_.enter_world();
    set_down();
}

void ByEar::set_down() {
    trail_ = {};
    stairs_ = {};
    retracing_ = false;
    leaping_.begin_anew();
    halt();
    avatar_.crumbs_m.assign(1, avatar_.feet_m());
}

void ByEar::halt() {
    trail_left_m_ = retrace_left_m_ = 0.0;
    trail_to_event_ = false;
}

void ByEar::lay_crumb() {
    std::vector<Vec3>& crumbs = avatar_.crumbs_m;
    if (retracing_ || glm::length(avatar_.feet_m() - crumbs.back()) <= kCrumb_m) return;
    if (crumbs.size() >= kMostCrumbs) crumbs.erase(crumbs.begin(), crumbs.begin() + kMostCrumbs / 4);
    crumbs.push_back(avatar_.feet_m());
}

std::optional<Vec3> ByEar::wall_at_side() const {
    if (!trail_.touching() || !leads()) return std::nullopt;
    return trail_.wall_normal();
}

void ByEar::notice(Command command) {
    const bool walks = command == Command::Forward || command == Command::Back || command == Command::SideLeft ||
                       command == Command::SideRight;
    const bool turns = command == Command::TurnLeft || command == Command::TurnRight || command == Command::FreeLeft ||
                       command == Command::FreeRight || command == Command::SquareUp || command == Command::Lost;
    const bool trails = command == Command::TrailLeft || command == Command::TrailRight ||
                        command == Command::TrailOn || command == Command::TrailBack;
    if (walks || turns || trails || command == Command::Retrace || command == Command::Home) leaping_.begin_anew();
    if (trails && stairs_.held) {
        stairs_.climbs = true;
        stairs_.level_m = 0.0;
    }
    if (!trails) stairs_ = {};
    stairs_.held = false;
    if (walks || turns || command == Command::Retrace) {
        trail_.stop();
        trail_left_m_ = 0.0;
        trail_to_event_ = false;
    }
    if (walks || turns || trails) {
        retracing_ = false;
        retrace_left_m_ = 0.0;
    }
}

bool ByEar::act(Command command, double now_s, int times) {
    const double step_m = context_.settings.walk.step_length_m;
    switch (command) {
        case Command::TrailLeft:
        case Command::TrailRight: {
            const TrailSide side = command == Command::TrailLeft ? TrailSide::Left : TrailSide::Right;
            if (!start_trail(side, now_s)) return true;
            trail_to_event_ = false;
            trail_left_m_ = more_to_go_m(trail_left_m_, step_m, times);
            return true;
        }
        case Command::TrailOn:
        case Command::TrailBack:
            if (command == Command::TrailBack && trail_.active()) {
                trail_.turn_round();
                announce_start(now_s);
            } else if (!trail_.active() && !start_trail(TrailSide::Left, now_s)) {
                return true;
            }
            trail_to_event_ = true;
            return true;
        case Command::SquareUp:
            square_up(now_s);
            return true;
        case Command::Retrace:
            trail_.stop();
            if (avatar_.crumbs_m.size() <= 1) {
                context_.play(cues::SoundKind::Denied, now_s);
                context_.answer(phrase("walking.at_beginning"), now_s);
                return true;
            }
            if (!retracing_) context_.answer(phrase("walking.going_back"), now_s);
            retracing_ = true;
            retrace_left_m_ = more_to_go_m(retrace_left_m_, step_m, times);
            return true;
        default:
            return leaping_.act(command, now_s);
    }
}

bool ByEar::start_trail(TrailSide side, double now_s) {
    if (trail_.active() && trail_.side() == side) return true;
    if (trail_.start(*context_.world.solids, avatar_.feet_m(), avatar_.heading_goal_rad, avatar_.walker->size(),
                     side)) {
        announced_z_m_ = avatar_.feet_m().z;
        announce_start(now_s);
        return true;
    }
    context_.play(cues::SoundKind::Denied, now_s);
    context_.answer(phrase("walking.no_wall"), now_s);
    return false;
}

// Announces in which direction the walk along the wall leads. Does nothing if the person already faces that direction
// with the wall at the chosen side.
void ByEar::announce_start(double now_s) {
    const double heading_rad = trail_.heading_rad();
    const bool turns = std::abs(wrap_angle(heading_rad - avatar_.heading_goal_rad)) > kAnnouncedTurn_rad;
    announced_heading_rad_ = heading_rad;
    const double away_m = trail_.wall_m();
    if (!turns && away_m <= kAtWall_m) return;
    const std::string compass = fine_compass_word(heading_rad);
    const char* side = trail_.side() == TrailSide::Left ? "left" : "right";
    if (away_m <= kAtWall_m)
        return context_.answer(phrase("walking.trail_turns", {{"compass", compass}, {"side", side}}), now_s);
    const std::string where =
        brief_place_words(away_m + avatar_.walker->size().radius_m, trail_.wall_bearing_rad(), avatar_.heading_goal_rad,
                          context_.settings.speech.directions, distances(context_));
    context_.answer(phrase("walking.trail_to", {{"where", where}, {"compass", compass}, {"side", side}}), now_s);
}

bool ByEar::leads() const {
    const bool keys = keys_.held(Command::TrailLeft) || keys_.held(Command::TrailRight);
    return (trail_.active() && (keys || trail_left_m_ > 0.0 || trail_to_event_)) ||
           (retracing_ && (keys_.held(Command::Retrace) || retrace_left_m_ > 0.0));
}

std::optional<Vec3> ByEar::lead(double now_s, double dt_s) {
    if (!leads() || !avatar_.walker->state().on_ground) return std::nullopt;
    if (retracing_) return retrace(now_s, dt_s);
    std::vector<TrailEvent> events;
    const TrailMotion way = trail_.tick(*context_.world.solids, avatar_.feet_m(), avatar_.heading_rad,
                                        avatar_.walker->size(), context_.settings.walk.speed_m_per_s, dt_s, events);
    avatar_.heading_goal_rad = wrap_angle(way.heading_rad);
    for (const TrailEvent& event : events) announce_trail(event, now_s);
    announce_turn_and_climb(now_s);
    if (trail_.touching() && waits_at_stairs(way.heading_rad, now_s)) {
        halt();
        return Vec3(0.0);
    }
    const bool keys = keys_.held(Command::TrailLeft) || keys_.held(Command::TrailRight);
    if (!keys) trail_left_m_ = std::max(0.0, trail_left_m_ - glm::length(way.intended_m_per_s) * dt_s);
    if (!events.empty() && trail_to_event_) {
        trail_to_event_ = false;
        trail_left_m_ = 0.0;
    }
    return way.intended_m_per_s;
}

// Returns the new direction in words if it differs from the direction announced last. Each change is announced once.
std::string ByEar::going_words() {
    if (std::abs(wrap_angle(avatar_.heading_goal_rad - announced_heading_rad_)) <= kAnnouncedTurn_rad) return {};
    announced_heading_rad_ = avatar_.heading_goal_rad;
    return phrase("walking.going", {{"compass", fine_compass_word(avatar_.heading_goal_rad)}});
}

void ByEar::announce_turn_and_climb(double now_s) {
    if (const std::string going = going_words(); !going.empty()) context_.say(going, cues::SpeechClass::Contact, now_s);
    const double z_m = avatar_.feet_m().z;
    stairs_.level_m =
        std::abs(z_m - stairs_.z_m) > 1e-3 ? 0.0 : stairs_.level_m + glm::length(avatar_.feet_m() - stairs_.from_m);
    stairs_.z_m = z_m;
    stairs_.from_m = avatar_.feet_m();
    if (stairs_.climbs && stairs_.level_m > kLevelAgain_m) {
        stairs_.climbs = false;
        announced_z_m_ = z_m;
    }
    if (stairs_.climbs || std::abs(z_m - announced_z_m_) <= kAnnouncedClimb_m) return;
    context_.warn(
        phrase(z_m > announced_z_m_ ? "walking.higher" : "walking.lower", {{"metres", std::abs(z_m - announced_z_m_)}}),
        now_s);
    announced_z_m_ = z_m;
}

// If stairs are ahead, stops the walk along the wall until the person repeats the command. Returns true while it is
// stopped.
bool ByEar::waits_at_stairs(double heading_rad, double now_s) {
    if (stairs_.held || stairs_.climbs) return stairs_.held;
    if (glm::length(avatar_.feet_m() - stairs_.looked_m) < kStairsLookedForEvery_m) return false;
    stairs_.looked_m = avatar_.feet_m();
    const WalkerSize size = avatar_.walker->size();
    const GroundAhead ahead = ground_ahead(*context_.world.solids, avatar_.feet_m(), heading_rad,
                                           ground_rules(*context_.world.scene, size), kStairsSeen_m);
    if (!ahead.stairs || ahead.stairs->distance_m > size.radius_m + kBeforeStairs_m) return false;
    stairs_.held = true;
    context_.play(cues::SoundKind::Denied, now_s);
    context_.warn(phrase(ahead.stairs->up ? "walking.trail_stairs_up" : "walking.trail_stairs_down"), now_s);
    return true;
}

void ByEar::announce_trail(const TrailEvent& event, double now_s) {
    const std::string name =
        cues::describe_feature(*context_.world.scene, event.feature, std::max(1, context_.settings.speech.verbosity));
    // This joins the direction and `words` into one sentence, because a newer name would replace the previous one.
    const auto with_going = [this](std::string words) {
        if (const std::string going = going_words(); !going.empty())
            words += (words.ends_with('.') ? " " : ". ") + going;
        return words;
    };
    switch (event.kind) {
        case TrailEvent::Kind::Corner:
            context_.cues.cue(sound_at(cues::SoundKind::Corner, event.place_m, now_s));
            context_.say(with_going(phrase("walking.corner", {{"name", name}})), cues::SpeechClass::Contact, now_s);
            return;
        case TrailEvent::Kind::Meets: {
            cues::CueRequest touched = sound_at(cues::SoundKind::Contact, event.place_m, now_s);
            if (const Feature* feature = context_.world.scene->find(event.feature))
                touched.material = context_.world.scene->material(feature->material).sound;
            touched.loudness = 0.6;
            context_.cues.cue(std::move(touched));
            if (name.empty()) return;
            context_.say(with_going(name), cues::SpeechClass::Contact, now_s);
            return;
        }
        case TrailEvent::Kind::Opening: {
            context_.cues.cue(sound_at(cues::SoundKind::Opening, event.place_m, now_s));
            if (!context_.settings.walk.callouts) return;
            // If there is a door, its name replaces the text for an opening.
            std::string text = phrase("walking.opening", {{"metres", std::round(event.width_m * 10.0) / 10.0}});
            for (const Feature& feature : context_.world.scene->features)
                if (feature.kind == FeatureKind::Door && !feature.bounds_m.empty() &&
                    glm::length(glm::clamp(event.place_m, feature.bounds_m.min_m, feature.bounds_m.max_m) -
                                event.place_m) < 0.5)
                    text = phrase("walking.open", {{"door", sentence_case(spoken_name(feature))}});
            context_.say(text, cues::SpeechClass::Contact, now_s);
            return;
        }
        case TrailEvent::Kind::Ends:
            context_.say(phrase("walking.wall_ends"), cues::SpeechClass::Contact, now_s);
            return;
    }
}

std::optional<Vec3> ByEar::retrace(double now_s, double dt_s) {
    std::vector<Vec3>& crumbs = avatar_.crumbs_m;
    const auto level_to = [&](const Vec3& place) {
        return Vec3(place.x - avatar_.feet_m().x, place.y - avatar_.feet_m().y, 0.0);
    };
    const double stride = context_.settings.walk.speed_m_per_s * dt_s;
    while (crumbs.size() > 1 && glm::length(level_to(crumbs.back())) <= std::max(stride, 0.02)) crumbs.pop_back();
    const Vec3 left = level_to(crumbs.back());
    const double way_m = glm::length(left);
    if (way_m <= std::max(stride, 0.02)) {
        retracing_ = false;
        retrace_left_m_ = 0.0;
        context_.play(cues::SoundKind::Arrived, now_s);
        context_.answer(phrase("walking.at_beginning"), now_s);
        return std::nullopt;
    }
    avatar_.heading_goal_rad = std::atan2(left.x, left.y);
    if (std::abs(wrap_angle(avatar_.heading_goal_rad - avatar_.heading_rad)) > 0.5) return Vec3(0.0);
    if (!keys_.held(Command::Retrace)) retrace_left_m_ = std::max(0.0, retrace_left_m_ - stride);
    return left * (context_.settings.walk.speed_m_per_s / way_m);
}

// Turns the walker to face the nearest wall squarely, or to the nearest quarter of the compass if no wall is near.
void ByEar::square_up(double now_s) {
    const auto nearest = nearest_wall(*context_.world.solids, avatar_.feet_m(), kSquareReach_m);
    const double quarter = 0.5 * kPi;
    const double origin = nearest ? nearest->bearing_rad : 0.0;
    avatar_.heading_goal_rad =
        wrap_angle(origin + std::round(wrap_angle(avatar_.heading_goal_rad - origin) / quarter) * quarter);
    const std::string compass = fine_compass_word(avatar_.heading_goal_rad);
    context_.play(cues::SoundKind::TurnTick, now_s);
    if (!nearest) return context_.answer(phrase("walking.square", {{"compass", compass}}), now_s);
    const std::string wall = sentence_case(name_of(context_, nearest->feature)),
                      where = where_words(context_, nearest->distance_m, origin);
    context_.answer(phrase("walking.square_to", {{"compass", compass}, {"wall", wall}, {"where", where}}), now_s);
}

}  // namespace handrail::core
