// The path to a thing. On foot, it ends at the side from which the thing can be reached. For a hand, it runs along the
// same route at hand height, so it goes through doors and never through a wall. Pure functions over a world's routes
// and solids; app thread. A plan takes milliseconds, so make one for each request, not for each frame.
#pragma once

#include <vector>

#include "app/core/world/walker_world.h"
#include "worlds/navigation/navigation.h"

namespace handrail::core {

// True if nothing solid is in between except the thing itself; thing: kNoFeature for a mere place.
bool free_line(const WalkerWorld& world, const Vec3& from_m, const Vec3& to_m, FeatureId thing);

// True if a proxy can move straight from one place to the other, or to the thing before it. Returns false if it touches
// something at the start.
bool ball_passes(const WalkerWorld& world, const Vec3& from_m, const Vec3& to_m, FeatureId thing);

// The point of a thing nearest to another place, slightly inside it, because whatever it stands on or hangs at covers
// its faces.
Vec3 place_on(const Aabb& thing_m, const Vec3& from_m);

// The shortest route to a place next to the thing from which a hand can reach it freely. If there is no such place, to
// any place next to it. Without points: there is no floor at `from_m`.
navigation::Route walk_to_thing(navigation::Navigation& navigation, const WalkerWorld& world, const Vec3& from_m,
                                const Aabb& thing_m, FeatureId thing);

// False if the route uses a lift, a teleporter or a climb, which a hand cannot follow.
bool hand_can_follow(const navigation::Route& route);

// The points of a hand's path along a route: from the hand to the route, along it at `height_m` above the floor, and
// from its end to the thing if the goal is reached. If there would be more than `most` points, those that bend the path
// least are left out.
std::vector<Vec3> hand_way(const navigation::Route& route, const Vec3& hand_m, double height_m,
                           const WalkerWorld& world, const Aabb& thing_m, FeatureId thing, std::size_t most);

}  // namespace handrail::core
