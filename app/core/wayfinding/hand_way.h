// The way to a thing: on foot to the side of it from which one reaches it, and for a hand along that same walk at the
// height of a hand, so through doors and never through a wall. Pure functions over a world's ways and solids; app
// thread. A plan takes milliseconds, so once for each wish, not each frame.
#pragma once

#include <vector>

#include "app/core/world/body_world.h"
#include "worlds/navigation/navigation.h"

namespace handrail {

// Nothing solid but the thing itself stands between; thing: kNoFeature for a mere place.
bool free_line(const BodyWorld& world, const Vec3& from_m, const Vec3& to_m, FeatureId thing);

// A ball of the hand's gets from one place to the other, or to the thing before it. A ball that touches something at
// the start does not.
bool ball_passes(const BodyWorld& world, const Vec3& from_m, const Vec3& to_m, FeatureId thing);

// The place of a thing nearest to another place, a little inside it: what it stands on or hangs at holds its faces.
Vec3 place_on(const Aabb& thing_m, const Vec3& from_m);

// The shortest walk to a place beside the thing from which nothing stands between it and a hand; where there is no such
// place, to any beside it. Without points: there is no floor at `from_m`.
Route walk_to_thing(Navigation& navigation, const BodyWorld& world, const Vec3& from_m, const Aabb& thing_m,
                    FeatureId thing);

// A hand cannot take a lift or a teleporter.
bool hand_can_follow(const Route& route);

// What a hand that is led along a walk goes through: from where it is to the walk, along it so high above the floor,
// and where the walk reaches its goal to the thing. At most `most` points; where there would be more, those that bend
// it least are left out.
std::vector<Vec3> hand_way(const Route& route, const Vec3& hand_m, double height_m, const BodyWorld& world,
                           const Aabb& thing_m, FeatureId thing, std::size_t most);

}  // namespace handrail
