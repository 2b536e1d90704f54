#include "app/core/wayfinding/stops.h"

#include <algorithm>
#include <cmath>

#include "app/core/wayfinding/finding.h"
#include "app/core/wayfinding/hand_path.h"
#include "app/core/world/body_heights.h"
#include "audio-cues/plan/speakable.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

// If a route begins this near to the end of the previous one, it continues that route.
constexpr double kGoesOn_m = 3.0;

void add(std::vector<Stop>& stops, const Stop& stop) {
    if (stops.back().name == stop.name && near_stop(stops.back(), stop.place_m, kAtStop_m)) return;
    stops.push_back(stop);
    if (stops.size() > kMostStops) stops.erase(stops.begin());
}

}  // namespace

std::vector<Goal> goals(const SessionContext& context) {
    std::vector<Goal> all;
    for (const Mark& mark : context.world.marks) all.push_back({mark.name, point_box(mark.place_m), kNoFeature});
    for (NamedThing& thing : named_things(*context.world.scene))
        all.push_back({sentence_case(cues::speakable(thing.name)), thing.bounds_m, thing.feature});
    const Vec3 here = context.avatar.feet_m() + Vec3(0.0, 0.0, kWaist_m);
    std::stable_sort(all.begin(), all.end(), [&](const Goal& a, const Goal& b) {
        return glm::length(nearest_place(a.box_m, here) - here) < glm::length(nearest_place(b.box_m, here) - here);
    });
    return all;
}

Aabb announced_box(const Rooms& rooms, const Goal& goal) {
    if (!rooms.found() || goal.feature == kNoFeature) return goal.box_m;
    for (const navigation::Portal& portal : rooms.graph().portals)
        if (portal.kind == navigation::PassageKind::Door && portal.feature == goal.feature)
            return {{portal.place_m.x, portal.place_m.y, goal.box_m.min_m.z},
                    {portal.place_m.x, portal.place_m.y, goal.box_m.max_m.z}};
    return goal.box_m;
}

bool near_stop(const Stop& stop, const Vec3& place_m, double near_m) {
    return std::hypot(stop.place_m.x - place_m.x, stop.place_m.y - place_m.y) <= near_m &&
           std::abs(stop.place_m.z - place_m.z) < 2.0;
}

Stop stop_at_place(const Rooms& rooms, const Vec3& place_m, const std::string& otherwise) {
    Stop stop;
    stop.place_m = place_m;
    stop.name = otherwise;
    const navigation::RoomGraph& graph = rooms.graph();
    if (const std::uint32_t room = navigation::room_at(graph, rooms.space(), place_m); room != navigation::kNothing) {
        stop.name = sentence_case(graph.rooms[room].name);
        stop.room = navigation::known_as(graph.rooms[room]);
    }
    if (!good_name(stop.name)) stop.name = otherwise;
    return stop;
}

Stop stop_in_room(const Rooms& rooms, std::uint32_t room) {
    return stop_at_place(rooms, rooms.graph().rooms[room].middle_m, phrase("ways.end"));
}

Stop stop_at_goal(const SessionContext& context, const Rooms& rooms, const Goal& goal, const Vec3& from_m) {
    const navigation::Route route =
        walk_to_thing(rooms.navigation(), *context.world.solids, from_m, goal.box_m, goal.feature);
    const Vec3 nearest = nearest_place(goal.box_m, from_m);
    const Vec3 place =
        route.reaches ? route.points_m.back() : rooms.navigation().nearest_place(nearest).value_or(nearest);
    Stop stop = stop_at_place(rooms, place, phrase("ways.end"));
    if (good_name(goal.name)) stop.name = goal.name;
    if (const Feature* feature = context.world.scene->find(goal.feature); feature && !feature->name.empty()) {
        stop.thing = feature->name;
        stop.thing_m = glm::length(nearest_place(feature->bounds_m, place) - place);
    }
    return stop;
}

Goal goal_of(const SessionContext& context, const Stop& stop) {
    Goal goal{stop.name, point_box(stop.place_m + Vec3(0.0, 0.0, kWaist_m)), kNoFeature};
    if (stop.thing.empty()) return goal;
    double near_m = 1e9;
    const std::vector<Feature>& features = context.world.scene->features;
    for (std::uint32_t i = 0; i < features.size(); ++i) {
        if (features[i].name != stop.thing || features[i].bounds_m.empty()) continue;
        if (const double away_m = glm::length(nearest_place(features[i].bounds_m, stop.place_m) - stop.place_m);
            away_m < near_m) {
            near_m = away_m;
            goal.box_m = features[i].bounds_m;
            goal.feature = FeatureId{i};
        }
    }
    return goal;
}

void PlannedStops::note(const Stop& stop, const Vec3& from_m) {
    const Vec3 here = rooms_.navigation().nearest_place(from_m).value_or(context_.avatar.feet_m());
    const Stop begin = stop_at_place(rooms_, here, phrase("ways.begin"));
    const bool goes_on = !stops_.empty() && near_stop(stops_.back(), here, kGoesOn_m);
    const bool from_there = !chosen_.empty() && glm::length(chosen_at_m_ - here) < kGoesOn_m;
    if (!goes_on) stops_.assign(1, begin);
    if (!goes_on && !from_there) chosen_.assign(1, begin);
    chosen_at_m_ = here;
    add(stops_, stop);
    add(chosen_, stop);
}

}  // namespace handrail::core
