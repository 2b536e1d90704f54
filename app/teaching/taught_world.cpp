#include "app/teaching/taught_world.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/core/kept/saved_routes.h"
#include "app/core/wayfinding/finding.h"
#include "app/core/world/walker.h"
#include "settings/settings.h"
#include "worlds/base/text.h"

namespace handrail::teaching {
namespace {

bool same_name(std::string_view a, std::string_view b) { return lower_ascii(a) == lower_ascii(b); }

}  // namespace

tl::unexpected<Error> TaughtWorld::bad(int line, const char* key, const std::string& name,
                                       const std::vector<std::string>& known) const {
    return fail(phrase(key, {{"name", name}, {"nearest", nearest_name(name, known)}}), lesson_.file.filename().string(),
                line);
}

std::vector<std::string> TaughtWorld::names() const {
    std::vector<std::string> names{"base"};
    for (const auto& [key, place] : places_) names.push_back(place.name);
    for (const navigation::Room& room : rooms_->graph().rooms) names.push_back(navigation::own_name(room));
    return names;
}

std::vector<std::pair<std::string, FeatureId>> TaughtWorld::doors() const {
    std::map<std::string, int> called;
    std::vector<FeatureId> doors;
    for (const Mover& mover : scene_->movers)
        if (const Feature& feature = scene_->features[mover.feature.value]; feature.kind == FeatureKind::Door) {
            doors.push_back(mover.feature);
            ++called[spoken_name(feature)];
        }
    std::vector<std::pair<std::string, FeatureId>> names;
    for (const FeatureId door : doors) {
        const Feature& feature = scene_->features[door.value];
        if (!feature.name.empty()) names.emplace_back(feature.name, door);
        if (called[spoken_name(feature)] == 1) names.emplace_back(spoken_name(feature), door);
        for (const navigation::Portal& portal : rooms_->graph().portals) {
            if (portal.feature != door) continue;
            const std::string one = navigation::own_name(rooms_->graph().rooms[portal.rooms[0]]),
                              other = navigation::own_name(rooms_->graph().rooms[portal.rooms[1]]);
            names.emplace_back(phrase("teaching.door_between", {{"one", one}, {"other", other}}), door);
            names.emplace_back(phrase("teaching.door_between", {{"one", other}, {"other", one}}), door);
        }
    }
    return names;
}

std::vector<std::string> TaughtWorld::door_names() const {
    std::vector<std::string> names;
    for (const auto& [name, door] : doors()) names.push_back(name);
    return names;
}

std::string TaughtWorld::nearest(std::string_view name) const { return nearest_name(name, names()); }

std::string TaughtWorld::nearest_door(std::string_view name) const { return nearest_name(name, door_names()); }

const TaughtPlace* TaughtWorld::place(std::string_view name) const {
    if (same_name(name, "base") || (!lesson_.base_name.empty() && same_name(name, lesson_.base_name))) return &base_;
    const auto found = places_.find(lower_ascii(name));
    return found == places_.end() ? nullptr : &found->second;
}

std::vector<TaughtPlace> TaughtWorld::stops_of(const LessonRoute& route) const {
    std::vector<TaughtPlace> stops;
    for (const LessonPlace& stop : route.stops)
        if (const TaughtPlace* known = place(stop.name)) stops.push_back(*known);
    return stops;
}

std::optional<FeatureId> TaughtWorld::door(std::string_view name) const {
    for (const auto& [known, door] : doors())
        if (same_name(known, name)) return door;
    return std::nullopt;
}

navigation::Route TaughtWorld::way(const Vec3& from_m, const std::vector<TaughtPlace>& stops,
                                   const std::vector<FeatureId>& blocked) {
    std::vector<Aabb> boxes;
    for (const FeatureId one : blocked)
        for (const Aabb& box : navigation::door_boxes(*scene_, rooms_->graph(), one)) boxes.push_back(box);
    rooms_->navigation().block(boxes);
    std::vector<Vec3> places;
    for (const TaughtPlace& stop : stops) places.push_back(stop.stand_m);
    navigation::Route route = core::plan_through(rooms_->navigation(), from_m, places);
    rooms_->navigation().block({});
    return route;
}

Result<TaughtPlace> TaughtWorld::look_up(const LessonPlace& place) const {
    navigation::Navigation& navigation = rooms_->navigation();
    TaughtPlace found{place.name, Vec3(0.0), Vec3(0.0), {}};
    const auto stand = [&](const Vec3& at_m) -> Result<TaughtPlace> {
        const auto near = navigation.nearest_place(at_m);
        if (!near) return bad(place.line, "teaching.no_place", place.name, {});
        found.stand_m = *near;
        return found;
    };
    if (place.thing.empty() && place.room.empty()) {
        found.middle_m = *place.place_m;
        return stand(*place.place_m);
    }
    std::vector<std::string> known;
    std::vector<TaughtPlace> candidates;
    if (!place.room.empty()) {
        for (const navigation::Room& room : rooms_->graph().rooms) {
            if (same_name(room.map_name, place.room) || same_name(navigation::own_name(room), place.room))
                candidates.push_back({place.name, room.middle_m, room.middle_m, {}});
            known.push_back(navigation::own_name(room));
        }
        if (candidates.empty()) return bad(place.line, "teaching.no_room", place.room, known);
        return one_of(place, candidates);
    }
    for (const core::NamedThing& thing : core::named_things(*scene_)) {
        if (same_name(thing.name, place.thing) ||
            same_name(spoken_name(scene_->features[thing.feature.value]), place.thing)) {
            Vec3 foot = thing.bounds_m.centre_m();
            foot.z = thing.bounds_m.min_m.z;
            candidates.push_back({place.name, foot, thing.bounds_m.centre_m(), thing.bounds_m});
        }
        known.push_back(thing.name);
    }
    if (candidates.empty()) return bad(place.line, "teaching.no_thing", place.thing, known);
    auto one = one_of(place, candidates);
    if (!one) return one;
    found.middle_m = one->middle_m;
    found.box_m = one->box_m;
    return stand(one->stand_m);
}

Result<TaughtPlace> TaughtWorld::one_of(const LessonPlace& place, const std::vector<TaughtPlace>& candidates) const {
    constexpr std::size_t kMostNamed = 5;
    if (place.place_m)
        return *std::min_element(candidates.begin(), candidates.end(), [&](const TaughtPlace& a, const TaughtPlace& b) {
            return glm::length(a.middle_m - *place.place_m) < glm::length(b.middle_m - *place.place_m);
        });
    if (candidates.size() == 1) return candidates.front();
    std::string places;
    for (std::size_t i = 0; i < std::min(candidates.size(), kMostNamed); ++i) {
        const Vec3& at = candidates[i].middle_m;
        places += fmt::format("{}[{:.1f}, {:.1f}, {:.1f}]", i == 0 ? "" : ", ", at.x, at.y, at.z);
    }
    return fail(phrase("teaching.which_of_them",
                       {{"name", place.thing + place.room}, {"count", candidates.size()}, {"places", places}}),
                lesson_.file.filename().string(), place.line);
}

Result<void> TaughtWorld::know(const LessonPlace& place) {
    auto found = look_up(place);
    if (!found) return tl::unexpected(found.error());
    places_.emplace(lower_ascii(place.name), std::move(*found));
    return {};
}

// Looks up a name that a step uses. The name may be that of any object of the world, not only of a landmark.
Result<void> TaughtWorld::know_requested(const std::string& name, int line) {
    if (place(name)) return {};
    LessonPlace thing;
    thing.name = thing.thing = name;
    thing.line = line;
    std::vector<std::string> known = names();
    for (const core::NamedThing& one : core::named_things(*scene_)) {
        if (same_name(one.name, name) || same_name(spoken_name(scene_->features[one.feature.value]), name))
            return know(thing);
        known.push_back(one.name);
    }
    return bad(line, "teaching.no_name", name, known);
}

// Checks that the question in a step has an answer. An object under the learner's feet has no direction and no
// distance, and nobody can approach it. The ground outside the building has no walls.
Result<void> TaughtWorld::check_requested(const TaughtStep& step) const {
    constexpr double kUnderFeet_m = 0.3, kSameStorey_m = 2.5;
    const TaughtPlace& from = step.from.empty() ? base_ : *place(step.from);
    for (const std::string& name : step.to) {
        const TaughtPlace& requested = *place(name);
        const Vec3 near = requested.box_m.empty()
                              ? requested.middle_m
                              : glm::clamp(from.stand_m, requested.box_m.min_m, requested.box_m.max_m);
        const Vec3 off_m = near - from.stand_m;
        if (std::hypot(off_m.x, off_m.y) < kUnderFeet_m && std::abs(off_m.z) < kSameStorey_m)
            return bad(step.line, "teaching.under_feet", name, {});
    }
    if (step.walls_percent <= 0) return {};
    for (const navigation::Room& room : rooms_->graph().rooms)
        if (same_name(navigation::own_name(room), step.room) &&
            navigation::is_outside(room, rooms_->navigation().space(), *rooms_->scene()))
            return bad(step.line, "teaching.no_walls_outside", step.room, {});
    return {};
}

Result<void> TaughtWorld::check_step(const TaughtStep& step) {
    std::vector<std::string> named = step.to;
    if (!step.from.empty()) named.push_back(step.from);
    if (!step.room.empty()) named.push_back(step.room);
    for (const std::string& name : named)
        if (auto known = know_requested(name, step.line); !known) return known;
    if (auto fits = check_requested(step); !fits) return fits;
    std::vector<FeatureId> blocked;
    for (const std::string& name : step.block) {
        const auto found = door(name);
        if (!found) return bad(step.line, "teaching.no_door", name, door_names());
        blocked.push_back(*found);
    }
    if (step.kind != StepKind::Go) return {};
    const LessonRoute& route = *lesson_.route(step.route);
    if (!way(base_.stand_m, stops_of(route), {}).reaches) return bad(route.line, "teaching.no_way", route.name, {});
    if (!blocked.empty() && !way(base_.stand_m, {stops_of(route).back()}, blocked).reaches)
        return bad(step.line, "teaching.no_way_round", route.name, {});
    return {};
}

Result<std::shared_ptr<TaughtWorld>> TaughtWorld::find(LessonFile lesson, const std::shared_ptr<const Scene>& scene,
                                                       const std::string& checksum, core::RoomsKept* rooms_kept) {
    std::shared_ptr<TaughtWorld> world(new TaughtWorld);
    world->scene_ = scene;
    const core::WalkerSize size = core::walker_size(*scene, settings::Settings{}.walk.body_radius_m);
    world->rooms_ = std::make_unique<core::RoomsOfWorld>(
        scene, navigation::walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m), at_once(),
        core::RoutesKeeper{}, rooms_kept);
    if (!world->rooms_->ready() || !world->rooms_->found())
        return fail(world->rooms_->problem(), lesson.file.filename().string());
    if (!lesson.world_checksum.empty() && !checksum.empty() && checksum != lesson.world_checksum)
        world->news_ = phrase("teaching.world_edited", {{"world", lesson.world_name}});
    world->lesson_ = std::move(lesson);
    const LessonFile& file = world->lesson_;
    world->base_.name = file.base_name.empty() ? phrase("teaching.base") : file.base_name;
    Vec3 feet(0.0);
    if (file.base_feet_m) {
        feet = *file.base_feet_m;
        world->base_heading_rad_ = file.base_heading_rad;
    } else if (!scene->starts.empty()) {
        const Start* start = &scene->starts.front();
        for (const Start& one : scene->starts)
            if (one.base) start = &one;
        feet = start->feet_m;
        world->base_heading_rad_ = start->heading_rad;
    }
    const auto stand = world->rooms_->navigation().nearest_place(feet);
    if (!stand) return fail(phrase("teaching.no_base"), file.file.filename().string(), 1);
    world->base_.stand_m = world->base_.middle_m = *stand;
    for (const LessonPlace& landmark : file.landmarks)
        if (auto known = world->know(landmark); !known) return tl::unexpected(known.error());
    for (const LessonRoute& route : file.routes)
        for (const LessonPlace& stop : route.stops)
            if (auto known = world->know(stop); !known) return tl::unexpected(known.error());
    for (const navigation::Room& room : world->rooms_->graph().rooms)
        world->places_.emplace(lower_ascii(navigation::own_name(room)),
                               TaughtPlace{navigation::own_name(room), room.middle_m, room.middle_m, {}});
    for (const TaughtSession& session : file.sessions)
        for (const TaughtStep& step : session.steps)
            if (auto fits = world->check_step(step); !fits) return tl::unexpected(fits.error());
    return world;
}

}  // namespace handrail::teaching
