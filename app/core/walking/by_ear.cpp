#include "app/core/walking/by_ear.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/context/telling.h"
#include "app/core/walking/paces.h"
#include "app/core/world/body_heights.h"
#include "app/core/world/questions.h"
#include "app/core/world/surroundings.h"
#include "worlds/base/language.h"
#include "worlds/scene/surfaces.h"

namespace handrail {
namespace {

constexpr double kCrumb_m = 0.25;
constexpr std::size_t kMostCrumbs = 4000, kMostUndo = 16, kMostPlaces = 64;
constexpr double kSquareReach_m = 3.0;
constexpr double kMarkHeight_m = 1.5;  // of a mark, above or below the waist, to count as on this floor

}  // namespace

void ByEar::enter_world() {
    undo_.clear();
    leapt_to_ = kNoFeature;
    set_down();
}

void ByEar::set_down() {
    trail_ = {};
    retracing_ = false;
    halt();
    body_.crumbs_m.assign(1, body_.feet_m());
}

void ByEar::halt() {
    trail_left_m_ = retrace_left_m_ = 0.0;
    trail_to_event_ = false;
}

void ByEar::keep_place() {
    if (undo_.size() == kMostUndo) undo_.erase(undo_.begin());
    undo_.push_back({body_.feet_m(), body_.heading_goal_rad});
}

void ByEar::lay_crumb() {
    std::vector<Vec3>& crumbs = body_.crumbs_m;
    if (retracing_ || glm::length(body_.feet_m() - crumbs.back()) <= kCrumb_m) return;
    if (crumbs.size() >= kMostCrumbs) crumbs.erase(crumbs.begin(), crumbs.begin() + kMostCrumbs / 4);
    crumbs.push_back(body_.feet_m());
}

std::optional<Vec3> ByEar::wall_at_side() const {
    if (!trail_.touching() || !leads()) return std::nullopt;
    return trail_.wall_normal();
}

void ByEar::notice(Command command) {
    const bool walks = command == Command::Forward || command == Command::Back || command == Command::SideLeft ||
                       command == Command::SideRight;
    const bool turns = command == Command::TurnLeft || command == Command::TurnRight || command == Command::FreeLeft ||
                       command == Command::FreeRight || command == Command::SquareUp;
    const bool trails = command == Command::TrailLeft || command == Command::TrailRight ||
                        command == Command::TrailOn || command == Command::TrailBack;
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
            if (command == Command::TrailBack && trail_.active()) trail_.turn_round();
            else if (!trail_.active() && !start_trail(TrailSide::Left, now_s)) return true;
            trail_to_event_ = true;
            return true;
        case Command::SquareUp:
            square_up(now_s);
            return true;
        case Command::LeapNext:
        case Command::LeapLast:
            leap(command == Command::LeapNext ? 1 : -1, now_s);
            return true;
        case Command::UndoLeap:
            undo(now_s);
            return true;
        case Command::Retrace:
            trail_.stop();
            if (body_.crumbs_m.size() <= 1) {
                context_.play(SoundKind::Denied, now_s);
                context_.answer(phrase("walking.at_beginning"), now_s);
                return true;
            }
            if (!retracing_) context_.answer(phrase("walking.going_back"), now_s);
            retracing_ = true;
            retrace_left_m_ = more_to_go_m(retrace_left_m_, step_m, times);
            return true;
        default:
            return false;
    }
}

void ByEar::undo(double now_s) {
    // Where something stands by now nobody is put back, nor where one stood in a solid.
    std::erase_if(
        undo_, [&](const Place& place) { return context_.world.solids->blocked(place.feet_m, body_.walker->shape()); });
    if (undo_.empty()) {
        context_.play(SoundKind::Denied, now_s);
        return context_.answer(phrase("walking.nothing_to_undo"), now_s);
    }
    const Place back = undo_.back();
    undo_.pop_back();
    context_.asks.place(back.feet_m, back.heading_rad, now_s);
    context_.answer(phrase("walking.undone") + " " + where_am_i(), now_s);
}

bool ByEar::start_trail(TrailSide side, double now_s) {
    if (trail_.active() && trail_.side() == side) return true;
    if (trail_.start(*context_.world.solids, body_.feet_m(), body_.heading_goal_rad, body_.walker->size(), side))
        return true;
    context_.play(SoundKind::Denied, now_s);
    context_.answer(phrase("walking.no_wall"), now_s);
    return false;
}

bool ByEar::leads() const {
    const bool keys = keys_.held(Command::TrailLeft) || keys_.held(Command::TrailRight);
    return (trail_.active() && (keys || trail_left_m_ > 0.0 || trail_to_event_)) ||
           (retracing_ && (keys_.held(Command::Retrace) || retrace_left_m_ > 0.0));
}

std::optional<Vec3> ByEar::lead(double now_s, double dt_s) {
    if (!leads() || !body_.walker->state().on_ground) return std::nullopt;
    if (retracing_) return retrace(now_s, dt_s);
    std::vector<TrailEvent> events;
    const TrailWay way = trail_.tick(*context_.world.solids, body_.feet_m(), body_.heading_rad, body_.walker->size(),
                                     context_.settings.walk.speed_m_per_s, dt_s, events);
    body_.heading_goal_rad = wrap_angle(way.heading_rad);
    for (const TrailEvent& event : events) tell_trail(event, now_s);
    const bool keys = keys_.held(Command::TrailLeft) || keys_.held(Command::TrailRight);
    if (!keys) trail_left_m_ = std::max(0.0, trail_left_m_ - glm::length(way.wish_m_per_s) * dt_s);
    if (!events.empty() && trail_to_event_) {
        trail_to_event_ = false;
        trail_left_m_ = 0.0;
    }
    return way.wish_m_per_s;
}

void ByEar::tell_trail(const TrailEvent& event, double now_s) {
    const std::string name =
        describe_feature(*context_.world.scene, event.feature, std::max(1, context_.settings.speech.verbosity));
    switch (event.kind) {
        case TrailEvent::Kind::Corner:
            context_.cues.cue(sound_at(SoundKind::Corner, event.place_m, now_s));
            context_.say(phrase("walking.corner", {{"name", name}}), SpeechClass::Contact, now_s);
            return;
        case TrailEvent::Kind::Meets: {
            CueRequest touched = sound_at(SoundKind::Contact, event.place_m, now_s);
            if (const Feature* feature = context_.world.scene->find(event.feature))
                touched.material = context_.world.scene->material(feature->material).sound;
            touched.loudness = 0.6;
            context_.cues.cue(std::move(touched));
            if (!name.empty()) context_.say(name, SpeechClass::Contact, now_s);
            return;
        }
        case TrailEvent::Kind::Opening: {
            context_.cues.cue(sound_at(SoundKind::Opening, event.place_m, now_s));
            if (!context_.settings.walk.callouts) return;
            // An open door goes by its name.
            std::string text = phrase("walking.opening", {{"metres", std::round(event.width_m * 10.0) / 10.0}});
            for (const Feature& feature : context_.world.scene->features)
                if (feature.kind == FeatureKind::Door && !feature.bounds_m.empty() &&
                    glm::length(glm::clamp(event.place_m, feature.bounds_m.min_m, feature.bounds_m.max_m) -
                                event.place_m) < 0.5)
                    text = phrase("walking.open", {{"door", sentence_case(spoken_name(feature))}});
            context_.say(text, SpeechClass::Contact, now_s);
            return;
        }
        case TrailEvent::Kind::Ends:
            context_.say(phrase("walking.wall_ends"), SpeechClass::Contact, now_s);
            return;
    }
}

std::optional<Vec3> ByEar::retrace(double now_s, double dt_s) {
    std::vector<Vec3>& crumbs = body_.crumbs_m;
    const auto level_to = [&](const Vec3& place) {
        return Vec3(place.x - body_.feet_m().x, place.y - body_.feet_m().y, 0.0);
    };
    const double stride = context_.settings.walk.speed_m_per_s * dt_s;
    while (crumbs.size() > 1 && glm::length(level_to(crumbs.back())) <= std::max(stride, 0.02)) crumbs.pop_back();
    const Vec3 left = level_to(crumbs.back());
    const double way_m = glm::length(left);
    if (way_m <= std::max(stride, 0.02)) {
        retracing_ = false;
        retrace_left_m_ = 0.0;
        context_.play(SoundKind::Arrived, now_s);
        context_.answer(phrase("walking.at_beginning"), now_s);
        return std::nullopt;
    }
    body_.heading_goal_rad = std::atan2(left.x, left.y);
    if (std::abs(wrap_angle(body_.heading_goal_rad - body_.heading_rad)) > 0.5) return Vec3(0.0);
    if (!keys_.held(Command::Retrace)) retrace_left_m_ = std::max(0.0, retrace_left_m_ - stride);
    return left * (context_.settings.walk.speed_m_per_s / way_m);
}

// Square to the nearest wall, or to the nearest quarter of the compass where none is near.
void ByEar::square_up(double now_s) {
    std::optional<TraceHit> nearest;
    double nearest_m = kSquareReach_m;
    const Vec3 eye = body_.feet_m() + Vec3(0.0, 0.0, kWaist_m);
    for (int i = 0; i < 32; ++i) {
        const TraceHit hit = context_.world.solids->trace(
            eye, eye + forward_of_heading(i * kPi / 16.0) * kSquareReach_m, BodyShape{}, true);
        if (!hit.hit || std::abs(hit.normal.z) > 0.3 || hit.fraction * kSquareReach_m >= nearest_m) continue;
        nearest = hit;
        nearest_m = hit.fraction * kSquareReach_m;
    }
    const double quarter = 0.5 * kPi;
    const double origin = nearest ? std::atan2(-nearest->normal.x, -nearest->normal.y) : 0.0;
    body_.heading_goal_rad =
        wrap_angle(origin + std::round(wrap_angle(body_.heading_goal_rad - origin) / quarter) * quarter);
    const std::string compass = fine_compass_word(body_.heading_goal_rad);
    context_.play(SoundKind::TurnTick, now_s);
    if (!nearest) return context_.answer(phrase("walking.square", {{"compass", compass}}), now_s);
    const std::string wall = sentence_case(name_of(context_, nearest->feature)),
                      where = where_words(context_, nearest_m, origin);
    context_.answer(phrase("walking.square_to", {{"compass", compass}, {"wall", wall}, {"where", where}}), now_s);
}

// To the next door, landmark, clue or own mark in sight, in the order of the file, and to a place before it where there
// is room. Marks come last, in the order in which they were set; one leaps right onto them where that is free.
void ByEar::leap(int by, double now_s) {
    struct Target {
        std::uint32_t order = 0;
        double bearing_rad = 0.0, distance_m = 0.0;
        bool mark = false;
    };
    std::vector<Target> places;
    for (const Seen& seen : things_in_sight(*context_.world.solids, body_.feet_m(), kWaist_m, kMostPlaces)) {
        const Feature& feature = context_.world.scene->features[seen.feature.value];
        if (feature.kind == FeatureKind::Door || feature.landmark || feature.clue)
            places.push_back({seen.feature.value, seen.bearing_rad, seen.distance_m, false});
    }
    const Vec3 eye = body_.feet_m() + Vec3(0.0, 0.0, kWaist_m);
    for (std::size_t i = 0; i < context_.world.marks.size() && places.size() < kMostPlaces; ++i) {
        const Vec3 way = context_.world.marks[i].place_m - eye;
        const double level_m = std::hypot(way.x, way.y);
        if (level_m < 0.5 * context_.settings.walk.step_length_m || level_m > kSightRange_m ||
            std::abs(way.z) > kMarkHeight_m)
            continue;
        if (context_.world.solids->trace(eye, eye + Vec3(way.x, way.y, 0.0), BodyShape{}, true).hit) continue;
        places.push_back({static_cast<std::uint32_t>(context_.world.scene->features.size() + i),
                          std::atan2(way.x, way.y), level_m, true});
    }
    std::sort(places.begin(), places.end(), [](const Target& a, const Target& b) { return a.order < b.order; });
    const std::size_t count = places.size();
    std::size_t first = by > 0 || count == 0 ? 0 : count - 1;  // the first after the last one, either way
    if (leapt_to_) {
        if (by > 0)
            while (first < count && places[first].order <= leapt_to_.value) ++first;
        else {
            first = count;
            while (first > 0 && places[first - 1].order >= leapt_to_.value) --first;
            first = (first + count - 1) % std::max<std::size_t>(count, 1);
        }
    }
    const BodyShape shape = body_.walker->shape();
    for (std::size_t i = 0; i < count; ++i) {
        const Target& to = places[(first + (by > 0 ? i : count - i)) % count];
        const Vec3 way = forward_of_heading(to.bearing_rad);
        for (double before = to.mark ? 0.0 : shape.radius_m + 0.15; before < shape.radius_m + 1.0; before += 0.1) {
            if (before > to.distance_m) break;
            const Vec3 feet = body_.feet_m() + way * (to.distance_m - before);
            const TraceHit ground =
                context_.world.solids->trace(feet + Vec3(0.0, 0.0, 0.5), feet - Vec3(0.0, 0.0, 1.0), shape);
            if (!ground.hit || ground.normal.z < 0.7 || context_.world.solids->blocked(ground.end_m, shape)) continue;
            const std::string where = where_words(context_, to.distance_m - before, to.bearing_rad);
            const std::string name = to.mark
                                         ? context_.world.marks[to.order - context_.world.scene->features.size()].name
                                         : describe_feature(*context_.world.scene, FeatureId{to.order},
                                                            std::max(2, context_.settings.speech.verbosity));
            const FeatureId order{to.order};
            const double bearing = to.bearing_rad;
            keep_place();
            context_.asks.place(ground.end_m, bearing, now_s);
            leapt_to_ = order;
            context_.play(SoundKind::Arrived, now_s);
            context_.answer(
                phrase("walking.leapt",
                       {{"name", name}, {"where", sentence_case(where)}, {"compass", fine_compass_word(bearing)}}),
                now_s);
            return;
        }
    }
    context_.play(SoundKind::Denied, now_s);
    context_.answer(phrase("leap.none"), now_s);
}

}  // namespace handrail
