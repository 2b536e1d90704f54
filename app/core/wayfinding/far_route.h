// Plans routes to rooms, a long one a stretch at a time, so that no tick takes long. The graph of rooms decides through
// which doorways the route leads. The planner then finds the way from doorway to doorway. A route through a large
// office costs 0.4 s at once; a stretch costs milliseconds. Lengths are in world metres. Use it on the app thread only.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/core/context/session_context.h"
#include "app/core/whereabouts/rooms.h"
#include "worlds/navigation/foot_distances.h"
#include "worlds/navigation/route.h"

namespace handrail::core {

// Longest stretch, measured along the graph of rooms. A shorter route is planned at once.
inline constexpr double kStretch_m = 60.0;

struct FarRoute {
    navigation::Route route;  // the route as far as it is planned
    // The doorways after the end of `route`, and the goal. Empty: the route is whole.
    std::vector<Vec3> ahead_m = {};
};

// Returns the first stretch of a route to `to_m` in `room`. Returns no value if the route is no longer than kStretch_m,
// or if it leads over anything but floor and stairs or through a door that waits for a button. `on_foot` has the
// distances from the walker's place.
std::optional<FarRoute> far_route(const SessionContext& context, const Rooms& rooms, std::uint32_t room,
                                  const Vec3& to_m, const navigation::FootDistances& on_foot);
// Returns the route from the walker to a room, or its first stretch. Stairs are preferred to a lift if they are not
// much farther, because directions leg by leg are more reliable.
FarRoute route_to_room(const SessionContext& context, const Rooms& rooms, std::uint32_t room,
                       const navigation::FootDistances& on_foot);
// Returns the whole route from the walker to a room, by lift if that is shorter.
navigation::Route planned_to_room(const SessionContext& context, const Rooms& rooms, std::uint32_t room);
// Plans the next stretch. Returns false if the planner finds no route there. Call it only while the route is not whole.
bool plan_stretch(const Rooms& rooms, FarRoute& far);
// Returns the route with straight lines to the places that are still ahead.
navigation::Route with_straight_lines(FarRoute far);

}  // namespace handrail::core
