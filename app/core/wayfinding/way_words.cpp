#include "app/core/wayfinding/way_words.h"

#include <cmath>
#include <utility>

#include "app/core/context/telling.h"
#include "app/core/wayfinding/stops.h"
#include "worlds/base/language.h"

namespace handrail {
namespace {

double heading_of(const Route& route, bool end) {
    const std::vector<Vec3>& points = route.points_m;
    const Vec3 way = end ? points.back() - points[points.size() - 2] : points[1] - points[0];
    return std::atan2(way.x, way.y);
}

}  // namespace

std::vector<RouteNode> nodes_to(const SessionContext& context, const Route& route, const std::string& goal) {
    return nodes_of(route, goal, [&context](const RoutePassage& passage) {
        return passage_now(context, passage.kind, passage.feature, passage.rise_m);
    });
}

std::string whole_way_words(const SessionContext& context, const Rooms& rooms, const std::string& name,
                            std::span<const Stop> stops) {
    WayRun along{{stops.begin(), stops.end()}, 1, false, {}, 0};
    Vec3 from = stops.front().place_m;
    double heading_rad = context.body.heading_rad, all_m = 0.0;
    // Who stands elsewhere does not know what right and left would be.
    bool first = !near_stop(stops.front(), context.body.feet_m(), kAtStop_m);
    std::string legs;
    while (along.next < stops.size()) {
        const Route route = plan_through(rooms.navigation(), from, along.places());
        const std::string& goal = stops[along.goal()].name;
        if (route.points_m.size() >= 2) {
            const double facing = std::exchange(first, false) ? heading_of(route, false) : heading_rad;
            const std::string words = route_words(route, nodes_to(context, route, goal), facing, distances(context));
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

}  // namespace handrail
