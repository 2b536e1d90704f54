#include "app/core/wayfinding/far_route.h"

#include <utility>

#include "app/core/kept/saved_routes.h"
#include "app/core/wayfinding/route_stage.h"
#include "worlds/base/contract.h"
#include "worlds/navigation/reach.h"

namespace handrail::core {

std::optional<FarRoute> far_route(const SessionContext& context, const Rooms& rooms, std::uint32_t room,
                                  const Vec3& to_m, const navigation::FootDistances& on_foot) {
    if (on_foot.to(room, to_m).value_or(0.0) <= kStretch_m) return std::nullopt;
    FarRoute far;
    far.route.points_m = {context.avatar.feet_m()};
    for (const std::uint32_t p : on_foot.portals_to(room, to_m)) {
        const navigation::Portal& portal = rooms.graph().portals[p];
        if (!has_legs(context, portal.kind, portal.feature)) return std::nullopt;
        far.ahead_m.push_back(portal.place_m);
    }
    far.ahead_m.push_back(to_m);
    if (!plan_stretch(rooms, far)) return std::nullopt;
    return far;
}

FarRoute route_to_room(const SessionContext& context, const Rooms& rooms, std::uint32_t room,
                       const navigation::FootDistances& on_foot) {
    constexpr double kLongerOnFoot = 1.5, kLongerOnFoot_m = 15.0;
    navigation::Navigation& ways = rooms.navigation();
    const Vec3 from_m = context.avatar.feet_m(), to_m = navigation::goal_in_room(ways, rooms.graph(), room, from_m);
    if (auto far = far_route(context, rooms, room, to_m, on_foot)) return std::move(*far);
    navigation::Route route = ways.plan(from_m, to_m);
    if (!route.reaches || !without_legs(context, route)) return {std::move(route)};
    navigation::Route foot = ways.plan(from_m, to_m, navigation::RoutePreference::OnFoot);
    const bool much_longer = foot.length_m >= kLongerOnFoot * route.length_m + kLongerOnFoot_m;
    if (!foot.reaches || without_legs(context, foot) || much_longer) return {std::move(route)};
    return {std::move(foot)};
}

navigation::Route planned_to_room(const SessionContext& context, const Rooms& rooms, std::uint32_t room) {
    navigation::Navigation& ways = rooms.navigation();
    const Vec3 from_m = context.avatar.feet_m();
    return ways.plan(from_m, navigation::goal_in_room(ways, rooms.graph(), room, from_m));
}

bool plan_stretch(const Rooms& rooms, FarRoute& far) {
    contract_pre(!far.ahead_m.empty());
    Vec3 to_m = far.ahead_m.front();
    std::size_t passed = 1;
    for (double far_m = glm::length(to_m - far.route.points_m.back()); passed < far.ahead_m.size(); ++passed) {
        far_m += glm::length(far.ahead_m[passed] - to_m);
        if (far_m > kStretch_m) break;
        to_m = far.ahead_m[passed];
    }
    const navigation::Route stretch =
        rooms.navigation().plan(far.route.points_m.back(), to_m, navigation::RoutePreference::OnFoot);
    if (!stretch.reaches) return false;
    far.route = joined(std::move(far.route), stretch);
    far.ahead_m.erase(far.ahead_m.begin(), far.ahead_m.begin() + static_cast<std::ptrdiff_t>(passed));
    return true;
}

navigation::Route with_straight_lines(FarRoute far) {
    navigation::Route route = std::move(far.route);
    for (const Vec3& place_m : far.ahead_m) {
        route.length_m += glm::length(place_m - route.points_m.back());
        route.points_m.push_back(place_m);
    }
    return route;
}

}  // namespace handrail::core
