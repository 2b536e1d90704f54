#include "app/core/wayfinding/whole_route_words.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/wayfinding/leg.h"
#include "app/core/wayfinding/route_stage.h"
#include "app/core/wayfinding/stops.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

double heading_of(const navigation::Route& route, bool end) {
    const std::vector<Vec3>& points = route.points_m;
    const Vec3 way = end ? points.back() - points[points.size() - 2] : points[1] - points[0];
    return std::atan2(way.x, way.y);
}

}  // namespace

std::vector<RouteNode> nodes_to(const SessionContext& context, const navigation::Route& route,
                                const std::string& goal) {
    return nodes_of(
        route, goal,
        [&context](const navigation::RoutePassage& passage) {
            return passage_now(context, passage.kind, passage.feature, passage.rise_m);
        },
        [&context](const navigation::RoutePassage& passage) {
            return must_be_opened(context, passage.kind, passage.feature);
        });
}

std::string rooms_between(const Rooms& rooms, const navigation::Route& route) {
    constexpr double kLookEvery_m = 0.5;
    constexpr std::size_t kMostRooms = 4;
    std::vector<std::uint32_t> through;
    const auto look = [&](const Vec3& place_m) {
        const std::uint32_t room = navigation::room_at(rooms.graph(), rooms.space(), place_m);
        if (room != navigation::kNothing && (through.empty() || through.back() != room)) through.push_back(room);
    };
    for (std::size_t i = 1; i < route.points_m.size(); ++i) {
        const Vec3 way = route.points_m[i] - route.points_m[i - 1];
        const int looks = std::max(1, static_cast<int>(glm::length(way) / kLookEvery_m));
        for (int k = 0; k < looks; ++k) look(route.points_m[i - 1] + way * (static_cast<double>(k) / looks));
    }
    if (!route.points_m.empty()) look(route.points_m.back());
    std::vector<std::string> names;
    for (std::size_t i = 1; i + 1 < through.size(); ++i) {
        std::string name = sentence_case(rooms.graph().rooms[through[i]].name);
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
    }
    if (names.size() > kMostRooms) names.resize(kMostRooms);
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string whole_route_words(const SessionContext& context, const Rooms& rooms, const std::string& name,
                              std::span<const Stop> stops) {
    RouteRun along{{stops.begin(), stops.end()}, 1, false, {}, 0};
    Vec3 from = stops.front().place_m;
    double heading_rad = context.avatar.heading_rad, all_m = 0.0;
    // If the person does not stand at the first stop, left and right at that stop would mean nothing to them.
    bool first = !near_stop(stops.front(), context.avatar.feet_m(), kAtStop_m);
    std::string legs;
    while (along.next < stops.size()) {
        const navigation::Route route = plan_through(rooms.navigation(), from, along.places());
        const std::string& goal = stops[along.goal()].name;
        if (route.points_m.size() >= 2) {
            const double facing = std::exchange(first, false) ? heading_of(route, false) : heading_rad;
            const std::string words =
                route_words(route, route_legs(route, nodes_to(context, route, goal), facing, distances(context)),
                            distances(context));
            if (route.reaches) legs += " " + phrase("rooms.way", {{"goal", goal}, {"route", words}});
            heading_rad = heading_of(route, true);
            all_m += route.length_m;
        }
        if (!route.reaches)
            legs += " " + phrase("rooms.not_reached",
                                 {{"goal", goal}, {"short_of", distance_words(route.short_of_m, distances(context))}});
        from = stops[along.goal()].place_m;
        along.next = along.goal() + 1;
    }
    return phrase(
               "ways.whole",
               {{"way", name}, {"from", stops.front().name}, {"distance", distance_words(all_m, distances(context))}}) +
           legs;
}

void append_legs_behind(std::vector<std::string>& legs, const SessionContext& context, const navigation::Route& route,
                        const std::string& goal) {
    constexpr double kBehind_m = 1e-3;
    const auto passage = without_legs(context, route);
    if (!passage) return;
    const navigation::Route rest = rest_of(route, passage->at_m + kBehind_m);
    if (rest.points_m.size() < 2) return;
    for (std::string& leg :
         route_legs(rest, nodes_to(context, rest, goal), heading_of(rest, false), distances(context)))
        legs.push_back(std::move(leg));
}

std::string place_facing_words(const SessionContext& context, const Rooms& rooms) {
    const std::uint32_t room = navigation::room_at(rooms.graph(), rooms.space(), context.avatar.feet_m());
    const std::string place =
        room == navigation::kNothing ? spoken_name(*context.world.scene) : rooms.graph().rooms[room].name;
    return phrase("questions.place_facing",
                  {{"place", sentence_case(place)}, {"compass", fine_compass_word(context.avatar.heading_goal_rad)}});
}

}  // namespace handrail::core
