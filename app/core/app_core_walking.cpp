// AppCore's part on moving by ear: trailing, squaring up, leaping, going back, and what is told of the ground ahead. App thread only.
#include <algorithm>
#include <cmath>

#include "app/core/app_core.h"
#include "worlds/base/language.h"
#include "worlds/scene/surfaces.h"

namespace handrail {
namespace {

constexpr double kRayHeight_m = 1.0;  // of what looks for doors and walls
constexpr double kCrumb_m = 0.25;
constexpr std::size_t kMostCrumbs = 4000, kMostUndo = 16, kMostPlaces = 64, kMostTold = 16;
constexpr double kSquareReach_m = 3.0;
constexpr double kMarkHeight_m = 1.5;  // of a mark, above or below the waist, to count as on this floor
constexpr double kFreeTurn_rad = 5.0 * kPi / 180.0;
constexpr double kLookEvery_s = 0.25, kLookEvery_m = 0.15, kLookEvery_rad = 0.1;
constexpr double kEdgeConfirm_s = 2.0;
constexpr double kTellAgain_s = 30.0, kSamePlace_m = 1.5;
constexpr double kDoorNear_m = 3.0;
constexpr double kStill_s = 1.5;  // after which nothing beats any more
constexpr double kRiser_m = 0.08;
constexpr double kLanding_m = 0.6;  // level, after the last riser
constexpr double kRamp = 0.03, kRampSure_m = 0.4;

}  // namespace

CueRequest AppCore::sound_at(SoundKind kind, const Vec3& place_m, double now_s) const {
    CueRequest sound;
    sound.kind = CueRequestKind::Play;
    sound.sound = kind;
    sound.time_s = now_s;
    sound.position_m = place_m;
    return sound;
}

void AppCore::keep_place_for_undo() {
    if (walking_.undo.size() == kMostUndo) walking_.undo.erase(walking_.undo.begin());
    walking_.undo.push_back({feet_m(), heading_goal_rad_});
}

std::string AppCore::where_words(double distance_m, double bearing_rad) const {
    return place_words(distance_m, bearing_rad, heading_goal_rad_, settings_.speech.directions, distances());
}

// Keys of this topic. False: it is another's.
bool AppCore::act_walking(Command command, double now_s) {
    const double step_m = settings_.walk.step_length_m;
    switch (command) {
        case Command::TrailLeft:
        case Command::TrailRight: {
            const TrailSide side = command == Command::TrailLeft ? TrailSide::Left : TrailSide::Right;
            if (!start_trail(side, now_s)) return true;
            walking_.trail_to_event = false;
            walking_.trail_left_m = std::min(walking_.trail_left_m + step_m, 8.0 * step_m);
            return true;
        }
        case Command::TrailOn:
        case Command::TrailBack:
            if (command == Command::TrailBack && walking_.trail.active()) walking_.trail.turn_round();
            else if (!walking_.trail.active() && !start_trail(TrailSide::Left, now_s)) return true;
            walking_.trail_to_event = true;
            return true;
        case Command::SquareUp:
            square_up(now_s);
            return true;
        case Command::LeapNext:
        case Command::LeapLast:
            leap(command == Command::LeapNext ? 1 : -1, now_s);
            return true;
        case Command::UndoLeap: {
            if (walking_.undo.empty()) {
                play(SoundKind::Denied, now_s);
                answer(phrase("walking.nothing_to_undo"), now_s);
                return true;
            }
            const Walking::Place back = walking_.undo.back();
            walking_.undo.pop_back();
            place(back.feet_m, back.heading_rad, now_s);
            answer(phrase("walking.undone") + " " + where_am_i(), now_s);
            return true;
        }
        case Command::Retrace:
            walking_.trail.stop();
            if (walking_.crumbs_m.size() <= 1) {
                play(SoundKind::Denied, now_s);
                answer(phrase("walking.at_beginning"), now_s);
                return true;
            }
            if (!walking_.retracing) answer(phrase("walking.going_back"), now_s);
            walking_.retracing = true;
            walking_.retrace_left_m = std::min(walking_.retrace_left_m + step_m, 8.0 * step_m);
            return true;
        case Command::FreeLeft:
        case Command::FreeRight:
            heading_goal_rad_ = wrap_angle(heading_goal_rad_ + (command == Command::FreeLeft ? -kFreeTurn_rad : kFreeTurn_rad));
            return true;
        case Command::Callouts:
            settings_.walk.callouts = !settings_.walk.callouts;
            setting_changes_.emplace_back("walk.callouts", settings_.walk.callouts ? "true" : "false");
            answer(phrase(settings_.walk.callouts ? "walking.callouts_on" : "walking.callouts_off"), now_s);
            return true;
        default:
            return false;
    }
}

// Whatever else the person does ends trailing and going back.
void AppCore::notice_walk_key(Command command, double now_s) {
    const bool walks = command == Command::Forward || command == Command::Back;
    const bool turns = command == Command::TurnLeft || command == Command::TurnRight || command == Command::FreeLeft || command == Command::FreeRight ||
                       command == Command::SquareUp;
    const bool trails = command == Command::TrailLeft || command == Command::TrailRight || command == Command::TrailOn || command == Command::TrailBack;
    if (walks || turns || command == Command::Retrace) {
        walking_.trail.stop();
        walking_.trail_left_m = 0.0;
        walking_.trail_to_event = false;
    }
    if (walks || turns || trails) {
        walking_.retracing = false;
        walking_.retrace_left_m = 0.0;
    }
    if (walks || trails || command == Command::Retrace) confirm_edge(now_s);
}

void AppCore::confirm_edge(double now_s) {
    if (walking_.edge_held && now_s - walking_.edge_s <= kEdgeConfirm_s) walking_.edge_confirmed = true;
    walking_.edge_held = false;
}

bool AppCore::start_trail(TrailSide side, double now_s) {
    if (walking_.trail.active() && walking_.trail.side() == side) return true;
    if (walking_.trail.start(*body_world_, feet_m(), heading_goal_rad_, walker_->size(), side)) return true;
    play(SoundKind::Denied, now_s);
    answer(phrase("walking.no_wall"), now_s);
    return false;
}

bool AppCore::led() const {
    const bool keys = held(Command::TrailLeft) || held(Command::TrailRight);
    return (walking_.trail.active() && (keys || walking_.trail_left_m > 0.0 || walking_.trail_to_event)) ||
           (walking_.retracing && (held(Command::Retrace) || walking_.retrace_left_m > 0.0));
}

// Where trailing or going back wants the body to go; none: the person's own keys count.
std::optional<Vec3> AppCore::lead_walk(double now_s, double dt_s) {
    if (!led() || !walker_->state().on_ground) return std::nullopt;
    if (walking_.retracing) return retrace_wish(now_s, dt_s);
    std::vector<TrailEvent> events;
    const TrailWay way = walking_.trail.tick(*body_world_, feet_m(), heading_rad_, walker_->size(), settings_.walk.speed_m_per_s, dt_s, events);
    heading_goal_rad_ = wrap_angle(way.heading_rad);
    for (const TrailEvent& event : events) tell_trail(event, now_s);
    const bool keys = held(Command::TrailLeft) || held(Command::TrailRight);
    if (!keys) walking_.trail_left_m = std::max(0.0, walking_.trail_left_m - glm::length(way.wish_m_per_s) * dt_s);
    if (!events.empty() && walking_.trail_to_event) {
        walking_.trail_to_event = false;
        walking_.trail_left_m = 0.0;
    }
    return way.wish_m_per_s;
}

void AppCore::tell_trail(const TrailEvent& event, double now_s) {
    const std::string name = describe_feature(*scene_, event.feature, std::max(1, settings_.speech.verbosity));
    switch (event.kind) {
        case TrailEvent::Kind::Corner:
            cue(sound_at(SoundKind::Corner, event.place_m, now_s));
            say(phrase("walking.corner", {{"name", name}}), SpeechClass::Contact, now_s);
            return;
        case TrailEvent::Kind::Meets: {
            CueRequest touched = sound_at(SoundKind::Contact, event.place_m, now_s);
            if (const Feature* feature = scene_->find(event.feature)) touched.material = scene_->material(feature->material).sound;
            touched.loudness = 0.6;
            cue(std::move(touched));
            if (!name.empty()) say(name, SpeechClass::Contact, now_s);
            return;
        }
        case TrailEvent::Kind::Opening: {
            cue(sound_at(SoundKind::Opening, event.place_m, now_s));
            if (!settings_.walk.callouts) return;
            // An open door goes by its name.
            std::string text = phrase("walking.opening", {{"metres", std::round(event.width_m * 10.0) / 10.0}});
            for (const Feature& feature : scene_->features)
                if (feature.kind == FeatureKind::Door && !feature.bounds_m.empty() &&
                    glm::length(glm::clamp(event.place_m, feature.bounds_m.min_m, feature.bounds_m.max_m) - event.place_m) < 0.5)
                    text = phrase("walking.open", {{"door", sentence_case(spoken_name(feature))}});
            say(text, SpeechClass::Contact, now_s);
            return;
        }
        case TrailEvent::Kind::Ends:
            say(phrase("walking.wall_ends"), SpeechClass::Contact, now_s);
            return;
    }
}

std::optional<Vec3> AppCore::retrace_wish(double now_s, double dt_s) {
    std::vector<Vec3>& crumbs = walking_.crumbs_m;
    const auto level_to = [&](const Vec3& place) { return Vec3(place.x - feet_m().x, place.y - feet_m().y, 0.0); };
    const double stride = settings_.walk.speed_m_per_s * dt_s;
    while (crumbs.size() > 1 && glm::length(level_to(crumbs.back())) <= std::max(stride, 0.02)) crumbs.pop_back();
    const Vec3 left = level_to(crumbs.back());
    const double way_m = glm::length(left);
    if (way_m <= std::max(stride, 0.02)) {
        walking_.retracing = false;
        walking_.retrace_left_m = 0.0;
        play(SoundKind::Arrived, now_s);
        answer(phrase("walking.at_beginning"), now_s);
        return std::nullopt;
    }
    heading_goal_rad_ = std::atan2(left.x, left.y);
    if (std::abs(wrap_angle(heading_goal_rad_ - heading_rad_)) > 0.5) return Vec3(0.0);
    if (!held(Command::Retrace)) walking_.retrace_left_m = std::max(0.0, walking_.retrace_left_m - stride);
    return left * (settings_.walk.speed_m_per_s / way_m);
}

// Square to the nearest wall, or to the nearest quarter of the compass where none is near.
void AppCore::square_up(double now_s) {
    std::optional<TraceHit> nearest;
    double nearest_m = kSquareReach_m;
    const Vec3 eye = feet_m() + Vec3(0.0, 0.0, kRayHeight_m);
    for (int i = 0; i < 32; ++i) {
        const TraceHit hit = body_world_->trace(eye, eye + forward_of_heading(i * kPi / 16.0) * kSquareReach_m, BodyShape{}, true);
        if (!hit.hit || std::abs(hit.normal.z) > 0.3 || hit.fraction * kSquareReach_m >= nearest_m) continue;
        nearest = hit;
        nearest_m = hit.fraction * kSquareReach_m;
    }
    const double quarter = 0.5 * kPi;
    const double origin = nearest ? std::atan2(-nearest->normal.x, -nearest->normal.y) : 0.0;
    heading_goal_rad_ = wrap_angle(origin + std::round(wrap_angle(heading_goal_rad_ - origin) / quarter) * quarter);
    const std::string compass = compass_word(heading_goal_rad_);
    play(SoundKind::TurnTick, now_s);
    if (!nearest) return answer(phrase("walking.square", {{"compass", compass}}), now_s);
    const std::string wall = sentence_case(name_of(nearest->feature)), where = where_words(nearest_m, origin);
    answer(phrase("walking.square_to", {{"compass", compass}, {"wall", wall}, {"where", where}}), now_s);
}

// To the next door, landmark, clue or own mark in sight, in the order of the file, and to a place before it where there is room. Marks come last, in the
// order in which they were set; one leaps right onto them where that is free.
void AppCore::leap(int by, double now_s) {
    struct Target {
        std::uint32_t order = 0;
        double bearing_rad = 0.0, distance_m = 0.0;
        bool mark = false;
    };
    std::vector<Target> places;
    for (const Seen& seen : things_in_sight(*body_world_, feet_m(), kRayHeight_m, kMostPlaces)) {
        const Feature& feature = scene_->features[seen.feature.value];
        if (feature.kind == FeatureKind::Door || feature.landmark || feature.clue)
            places.push_back({seen.feature.value, seen.bearing_rad, seen.distance_m, false});
    }
    const Vec3 eye = feet_m() + Vec3(0.0, 0.0, kRayHeight_m);
    for (std::size_t i = 0; i < guiding_.marks.size() && places.size() < kMostPlaces; ++i) {
        const Vec3 way = guiding_.marks[i].place_m - eye;
        const double level_m = std::hypot(way.x, way.y);
        if (level_m < 0.5 * settings_.walk.step_length_m || level_m > kSightRange_m || std::abs(way.z) > kMarkHeight_m) continue;
        if (body_world_->trace(eye, eye + Vec3(way.x, way.y, 0.0), BodyShape{}, true).hit) continue;
        places.push_back({static_cast<std::uint32_t>(scene_->features.size() + i), std::atan2(way.x, way.y), level_m, true});
    }
    std::sort(places.begin(), places.end(), [](const Target& a, const Target& b) { return a.order < b.order; });
    const std::size_t count = places.size();
    std::size_t first = by > 0 || count == 0 ? 0 : count - 1;  // the first after the last one, either way
    if (walking_.leapt_to) {
        if (by > 0)
            while (first < count && places[first].order <= walking_.leapt_to.value) ++first;
        else {
            first = count;
            while (first > 0 && places[first - 1].order >= walking_.leapt_to.value) --first;
            first = (first + count - 1) % std::max<std::size_t>(count, 1);
        }
    }
    const BodyShape shape = walker_->shape();
    for (std::size_t i = 0; i < count; ++i) {
        const Target& to = places[(first + (by > 0 ? i : count - i)) % count];
        const Vec3 way = forward_of_heading(to.bearing_rad);
        for (double before = to.mark ? 0.0 : shape.radius_m + 0.15; before < shape.radius_m + 1.0; before += 0.1) {
            if (before > to.distance_m) break;
            const Vec3 feet = feet_m() + way * (to.distance_m - before);
            const TraceHit ground = body_world_->trace(feet + Vec3(0.0, 0.0, 0.5), feet - Vec3(0.0, 0.0, 1.0), shape);
            if (!ground.hit || ground.normal.z < 0.7 || body_world_->blocked(ground.end_m, shape)) continue;
            const std::string where = where_words(to.distance_m - before, to.bearing_rad);
            const std::string name = to.mark ? guiding_.marks[to.order - scene_->features.size()].name
                                             : describe_feature(*scene_, FeatureId{to.order}, std::max(2, settings_.speech.verbosity));
            const FeatureId order{to.order};
            const double bearing = to.bearing_rad;
            keep_place_for_undo();
            place(ground.end_m, bearing, now_s);
            walking_.leapt_to = order;
            play(SoundKind::Arrived, now_s);
            answer(phrase("walking.leapt", {{"name", name}, {"where", sentence_case(where)}, {"compass", compass_word(bearing)}}), now_s);
            return;
        }
    }
    play(SoundKind::Denied, now_s);
    answer(phrase("leap.none"), now_s);
}

// Takes the body back to `before` when it stands over a drop that was not asked for twice. True: it was.
bool AppCore::held_at_edge(const WalkerState& before, double now_s) {
    if (!settings_.walk.stop_at_drops || !before.on_ground) return false;
    const Vec3 moved = feet_m() - before.feet_m;
    if (moved.x * moved.x + moved.y * moved.y < 1e-12) return false;
    const GroundRules rules = ground_rules(*scene_, walker_->size());
    const auto drop = over_drop(*body_world_, feet_m(), std::atan2(moved.x, moved.y), rules);
    if (!drop) {
        if (walking_.edge_confirmed && now_s - walking_.edge_s > kEdgeConfirm_s + 1.0) walking_.edge_confirmed = false;
        return false;
    }
    if (walking_.edge_confirmed) return false;
    walker_->resume(before);
    pending_way_m_ = walking_.trail_left_m = walking_.retrace_left_m = 0.0;
    walking_.trail_to_event = false;
    if (std::exchange(walking_.edge_held, true)) return true;
    walking_.edge_s = now_s;
    play(SoundKind::Denied, now_s);
    answer(drop->depth_m ? phrase("walking.edge", {{"metres", *drop->depth_m}}) : phrase("walking.edge_very_deep"), now_s);
    return true;
}

// True, and noted, where nothing was told of this place lately.
bool AppCore::tell_place_once(const Vec3& place_m, bool drop, double now_s) {
    std::erase_if(walking_.told, [&](const Walking::Told& told) { return now_s - told.time_s > kTellAgain_s; });
    for (Walking::Told& told : walking_.told)
        if (told.drop == drop && glm::length(told.place_m - place_m) < kSamePlace_m) {
            told.time_s = now_s;  // while it is before one, it is not told again
            return false;
        }
    if (walking_.told.size() == kMostTold) walking_.told.erase(walking_.told.begin());
    walking_.told.push_back({place_m, now_s, drop});
    return true;
}

// What the ground does under and before the body. `before`: where it stood a tick ago.
void AppCore::notice_ground(const Vec3& before_m, const WalkResult& walked, double now_s) {
    if (!walker_->state().on_ground || tuning_.panic) return;
    const Vec3 feet = feet_m();
    const Vec3 moved = feet - before_m;
    if (walked.walked_m > 1e-6 || heading_rad_ != walking_.looked_heading_rad) walking_.moved_s = now_s;
    if (glm::length(feet - walking_.crumbs_m.back()) > kCrumb_m && !walking_.retracing) {
        if (walking_.crumbs_m.size() >= kMostCrumbs) walking_.crumbs_m.erase(walking_.crumbs_m.begin(), walking_.crumbs_m.begin() + kMostCrumbs / 4);
        walking_.crumbs_m.push_back(feet);
    }

    if (walked.landed) walking_.edge_confirmed = false;

    // 1. Risers, landings, ramps.
    if (std::abs(moved.z) >= kRiser_m && !walked.landed) {
        const int sign = moved.z > 0.0 ? 1 : -1;
        walking_.risers = walking_.risers * sign >= 0 ? walking_.risers + sign : sign;
        walking_.since_riser_m = 0.0;
    } else {
        walking_.since_riser_m += walked.walked_m;
    }
    if (walking_.risers != 0 && walking_.since_riser_m > kLanding_m) {
        const int risers = std::exchange(walking_.risers, 0);
        if (std::abs(risers) >= 3 && settings_.walk.callouts)
            say(phrase(risers > 0 ? "walking.landing" : "walking.foot_of_stairs", {{"steps", std::abs(risers)}}), SpeechClass::Contact, now_s);
    }
    if (walked.walked_m > 1e-6 && walking_.risers == 0) {
        const double slope = ground_slope(*body_world_, feet, std::atan2(moved.x, moved.y));
        walking_.step_pitch = std::exp2(2.0 * std::clamp(slope, -0.5, 0.5));
        const int sign = slope > kRamp ? 1 : slope < -kRamp ? -1 : 0;
        walking_.ramp_m = sign == 0 || walking_.ramp_m * sign < 0.0 ? 0.0 : walking_.ramp_m + sign * walked.walked_m;
        if (std::abs(walking_.ramp_m) >= kRampSure_m && walking_.ramp_told != sign) {
            walking_.ramp_told = sign;
            if (settings_.walk.callouts) say(phrase(sign > 0 ? "walking.ramp_up" : "walking.ramp_down"), SpeechClass::Contact, now_s);
        }
        if (sign == 0) walking_.ramp_told = 0;
    }

    // 2. Ahead.
    const bool turned = std::abs(wrap_angle(heading_rad_ - walking_.looked_heading_rad)) > kLookEvery_rad;
    const bool went = glm::length(feet - walking_.looked_from_m) > kLookEvery_m;
    if ((turned || went) && now_s - walking_.looked_s >= (turned ? 0.1 : kLookEvery_s * 0.5)) {
        walking_.ahead = ground_ahead(*body_world_, feet, heading_rad_, ground_rules(*scene_, walker_->size()), kStairsCallout_m + 0.3);
        walking_.looked_from_m = feet;
        walking_.looked_heading_rad = heading_rad_;
        walking_.looked_s = now_s;
        tell_ahead(now_s);
    }
    beat_ahead(now_s);
}

void AppCore::tell_ahead(double now_s) {
    const GroundAhead& ahead = walking_.ahead;
    if (ahead.stairs && ahead.stairs->distance_m <= kStairsCallout_m && walking_.risers == 0 && tell_place_once(ahead.stairs->place_m, false, now_s)) {
        const bool up = ahead.stairs->up;
        cue(sound_at(up ? SoundKind::StairsUp : SoundKind::StairsDown, ahead.stairs->place_m, now_s));
        if (settings_.walk.callouts) {
            const std::string distance = distance_words(ahead.stairs->distance_m, distances());
            say(ahead.stairs->whole ? phrase(up ? "walking.stairs_up" : "walking.stairs_down", {{"steps", ahead.stairs->risers}, {"distance", distance}})
                                    : phrase(up ? "walking.stairs_up_on" : "walking.stairs_down_on", {{"distance", distance}}),
                SpeechClass::Contact, now_s);
        }
    }
    if (ahead.drop && ahead.drop->distance_m <= kDropWarning_m && settings_.walk.callouts && tell_place_once(ahead.drop->place_m, true, now_s))
        say(phrase("walking.drop", {{"distance", distance_words(ahead.drop->distance_m, distances())}}), SpeechClass::Contact, now_s);
}

// The beat before an edge, and knocks from a door that is faced; silent for one who stands still.
void AppCore::beat_ahead(double now_s) {
    if (now_s - walking_.moved_s > kStill_s) return;
    if (walking_.ahead.drop) {
        const Vec3 place = walking_.ahead.drop->place_m;
        const double distance = glm::dot(place - feet_m(), forward_of_heading(heading_rad_));
        if (distance > -0.3 && distance <= kDropWarning_m && now_s - walking_.beat_s >= drop_beat_s(distance)) {
            walking_.beat_s = now_s;
            cue(sound_at(SoundKind::DropNear, place, now_s));
        }
    }
    if (now_s - walking_.door_s < 0.25) return;
    const auto seen = look(*body_world_, feet_m(), kRayHeight_m, heading_rad_, kDoorNear_m);
    if (!seen || !seen->feature || scene_->features[seen->feature.value].kind != FeatureKind::Door) return;
    if (now_s - walking_.door_s < 0.3 + 0.4 * seen->distance_m) return;
    walking_.door_s = now_s;
    cue(sound_at(SoundKind::DoorNear, seen->point_m, now_s));
}

// The door that stands nearest to where one starts is the base's.
void AppCore::mark_base_door(Scene& scene, const Vec3& feet_m) {
    Feature* nearest = nullptr;
    double nearest_m = 1.2;
    for (Feature& feature : scene.features) {
        feature.base = false;
        if (feature.kind != FeatureKind::Door || feature.bounds_m.empty()) continue;
        const double distance = glm::length(glm::clamp(feet_m, feature.bounds_m.min_m, feature.bounds_m.max_m) - feet_m);
        if (distance >= nearest_m) continue;
        nearest_m = distance;
        nearest = &feature;
    }
    if (nearest) nearest->base = true;
}

}  // namespace handrail
