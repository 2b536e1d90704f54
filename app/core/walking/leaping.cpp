#include "app/core/walking/leaping.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/world/body_heights.h"
#include "app/core/world/surroundings.h"
#include "audio-cues/plan/cue_planner.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr std::size_t kMostUndo = 16, kMostPlaces = 64;
// a mark is on this floor if it is at most this far above or below the waist
constexpr double kMarkHeight_m = 1.5;
constexpr double kAnnouncedHeight_m = 0.3;  // if a leap changes the height by more than this, that is announced

}  // namespace

void Leaping::enter_world() {
    undo_.clear();
    leapt_.clear();
}

bool Leaping::act(Command command, double now_s) {
    if (command == Command::LeapNext) leap_on(now_s);
    else if (command == Command::LeapLast) leap_back(now_s);
    else if (command == Command::UndoLeap) undo(now_s);
    else return false;
    return true;
}

void Leaping::keep_place() {
    if (undo_.size() == kMostUndo) undo_.erase(undo_.begin());
    undo_.push_back({avatar_.feet_m(), avatar_.heading_goal_rad});
}

void Leaping::undo(double now_s) {
    // Remove places that are now inside a solid, so that the walker is never moved there.
    std::erase_if(undo_, [&](const Place& place) {
        return context_.world.solids->blocked(place.feet_m, avatar_.walker->shape());
    });
    if (undo_.empty()) {
        context_.play(cues::SoundKind::Denied, now_s);
        return context_.answer(phrase("walking.nothing_to_undo"), now_s);
    }
    const Place back = undo_.back();
    undo_.pop_back();
    begin_anew();
    context_.session_requests.place(back.feet_m, back.heading_rad, now_s);
    context_.answer(phrase("walking.undone") + " " + where_am_i_(), now_s);
}

// Returns the targets, nearest first: doors of the room; doors, landmarks and clues in sight; and marks.
std::vector<Leaping::Target> Leaping::targets() const {
    std::vector<Target> all;
    const Vec3& feet_m = avatar_.feet_m();
    const auto level = [&](const Vec3& to_m) { return std::hypot(to_m.x - feet_m.x, to_m.y - feet_m.y); };
    const auto bearing = [&](const Vec3& to_m) { return std::atan2(to_m.x - feet_m.x, to_m.y - feet_m.y); };
    if (doors_)
        for (const LeapDoor& door : doors_()) {
            const double facing_rad = std::atan2(door.place_m.x - door.feet_m.x, door.place_m.y - door.feet_m.y);
            all.push_back({door.feature.value, bearing(door.place_m), level(door.place_m), false,
                           Place{door.feet_m, facing_rad}});
        }
    for (const Seen& seen : things_in_sight(*context_.world.solids, feet_m, kWaist_m, kMostPlaces)) {
        const Feature& feature = context_.world.scene->features[seen.feature.value];
        const bool known = std::any_of(all.begin(), all.end(),
                                       [&](const Target& target) { return target.number == seen.feature.value; });
        if (!known && (feature.kind == FeatureKind::Door || feature.landmark || feature.clue))
            all.push_back({seen.feature.value, seen.bearing_rad, seen.distance_m, false, std::nullopt});
    }
    const Vec3 eye = feet_m + Vec3(0.0, 0.0, kWaist_m);
    for (std::size_t i = 0; i < context_.world.marks.size() && all.size() < 2 * kMostPlaces; ++i) {
        const Vec3& mark_m = context_.world.marks[i].place_m;
        const double away_m = level(mark_m);
        if (away_m < 0.5 * context_.settings.walk.step_length_m || away_m > kSightRange_m ||
            std::abs(mark_m.z - eye.z) > kMarkHeight_m)
            continue;
        if (context_.world.solids->trace(eye, Vec3(mark_m.x, mark_m.y, eye.z), WalkerShape{}, true).hit) continue;
        all.push_back({static_cast<std::uint32_t>(context_.world.scene->features.size() + i), bearing(mark_m), away_m,
                       true, std::nullopt});
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Target& a, const Target& b) { return a.distance_m < b.distance_m; });
    return all;
}

// Returns a place in front of the target if there is room for the walker. For a mark, returns the place of the mark
// itself if it is free.
std::optional<Leaping::Place> Leaping::place_at(const Target& target) const {
    if (target.before) return target.before;
    const WalkerShape shape = avatar_.walker->shape();
    const Vec3 way = forward_of_heading(target.bearing_rad);
    for (double before = target.mark ? 0.0 : shape.radius_m + 0.15; before < shape.radius_m + 1.0; before += 0.1) {
        if (before > target.distance_m) break;
        const Vec3 feet = avatar_.feet_m() + way * (target.distance_m - before);
        const TraceHit ground =
            context_.world.solids->trace(feet + Vec3(0.0, 0.0, 0.5), feet - Vec3(0.0, 0.0, 1.0), shape);
        if (ground.hit && ground.normal.z >= 0.7 && !context_.world.solids->blocked(ground.end_m, shape))
            return Place{ground.end_m, target.bearing_rad};
    }
    return std::nullopt;
}

std::string Leaping::name_of_target(const Target& target) const {
    if (target.mark) return context_.world.marks[target.number - context_.world.scene->features.size()].name;
    constexpr int kNameAndMaterial = 2;  // Use this verbosity at most, because a higher one would add whole sentences.
    return cues::describe_feature(*context_.world.scene, FeatureId{target.number}, kNameAndMaterial);
}

void Leaping::leap_on(double now_s) {
    const std::vector<Target> near = targets();
    const auto been_at = [&](std::uint32_t number) {
        return std::any_of(leapt_.begin(), leapt_.end(), [&](const Leapt& leapt) { return leapt.number == number; });
    };
    // There are two rounds: once the walker has visited all nearby targets, the series begins again, but not with the
    // present place.
    for (int round = 0; round < 2; ++round) {
        for (const Target& target : near) {
            if (been_at(target.number)) continue;
            const auto place = place_at(target);
            if (!place) continue;
            leapt_.push_back({target.number, name_of_target(target), *place});
            keep_place();
            return leap_to(leapt_.back(), now_s);
        }
        if (leapt_.size() > 1) leapt_.erase(leapt_.begin(), leapt_.end() - 1);
        else break;
    }
    context_.play(cues::SoundKind::Denied, now_s);
    context_.answer(phrase("leap.none"), now_s);
}

void Leaping::leap_back(double now_s) {
    if (leapt_.size() < 2) {
        context_.play(cues::SoundKind::Denied, now_s);
        return context_.answer(phrase("leap.no_last", {{"key", context_.keys.keys_of(Command::UndoLeap)}}), now_s);
    }
    leapt_.pop_back();
    keep_place();
    leap_to(Leapt(leapt_.back()), now_s);
}

void Leaping::leap_to(const Leapt& to, double now_s) {
    const Leapt there = to;                    // a copy, because `to` may be an element of leapt_
    const std::vector<Leapt> series = leapt_;  // a copy, because placing the walker elsewhere clears `leapt_`
    const double was_m = avatar_.feet_m().z;
    context_.session_requests.place(there.place.feet_m, there.place.heading_rad, now_s);
    leapt_ = series;
    context_.play(cues::SoundKind::Arrived, now_s);
    std::string text =
        phrase("walking.leapt", {{"name", there.name}, {"compass", fine_compass_word(avatar_.heading_goal_rad)}});
    const double rise_m = avatar_.feet_m().z - was_m;
    if (std::abs(rise_m) > kAnnouncedHeight_m)
        text += " " + phrase(rise_m > 0.0 ? "walking.higher" : "walking.lower", {{"metres", std::abs(rise_m)}});
    context_.answer(text, now_s);
}

}  // namespace handrail::core
