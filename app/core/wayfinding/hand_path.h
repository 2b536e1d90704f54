// Plans the path to a thing. On foot, the path ends at the side from which the thing can be reached. For a hand, the
// path follows the same route at hand height, so it goes through doors and never through a wall. Pure functions over a
// world's routes and solids, for the app thread. A plan takes milliseconds, so make one for each request, not for each
// frame.
#pragma once

#include <vector>

#include "app/core/world/walker_world.h"
#include "worlds/navigation/navigation.h"

namespace handrail::core {

// Returns true if no solid is between `from_m` and `to_m`, except the thing itself. `thing` is kNoFeature if the goal
// is only a place.
bool free_line(const WalkerWorld& world, const Vec3& from_m, const Vec3& to_m, FeatureId thing);

// Returns true if a proxy can move straight from `from_m` to `to_m`, or until it touches the thing. Returns false if
// the proxy touches something at the start.
bool proxy_passes(const WalkerWorld& world, const Vec3& from_m, const Vec3& to_m, FeatureId thing);

// Returns the point of a thing that is nearest to `from_m`, moved slightly into the thing. The faces of the thing may
// be covered by what it stands on or hangs at.
Vec3 place_on(const Aabb& thing_m, const Vec3& from_m);

// Returns the shortest route to a place next to the thing from which a hand can reach the thing freely. If there is no
// such place, the route leads to any place next to the thing. A route without points means that there is no floor at
// `from_m`.
navigation::Route walk_to_thing(navigation::Navigation& navigation, const WalkerWorld& world, const Vec3& from_m,
                                const Aabb& thing_m, FeatureId thing);

// Returns false if the route uses a lift, a teleporter or a climb, which a hand cannot follow.
bool hand_can_follow(const navigation::Route& route);

// Returns the points of a hand's path. It leads from the hand to the route, and along the route at `height_m` above the
// floor. If the goal is reached, it also leads from the end of the route to the thing. If there are more than `most`
// points, those that bend the path least are left out.
std::vector<Vec3> path_of_hand(const navigation::Route& route, const Vec3& hand_m, double height_m,
                               const WalkerWorld& world, const Aabb& thing_m, FeatureId thing, std::size_t most);

}  // namespace handrail::core
