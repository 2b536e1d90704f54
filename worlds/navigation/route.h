// A walking route from one place to another, as plain values. Guidance, spoken directions and the wall side of a route
// are made from it. World metres; points are where the soles are.
#pragma once

#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"

namespace handrail::navigation {

// Something that the walker meets on a route, or that joins two rooms.
enum class PassageKind : std::uint8_t {
    Door,
    Opening,
    Stairs,
    Lift,
    Drop,
    Teleporter,
    Climb,  // stairs without walkable steps, taken in one go: see stated_stairs.h
};

// A passage on a route.
struct RoutePassage {
    PassageKind kind = PassageKind::Door;
    Vec3 place_m{0.0};
    double at_m = 0.0;    // distance along the route
    double rise_m = 0.0;  // stairs, climbs, lifts and drops: height to where they lead, negative down
    // The door, lift or teleporter. For stairs, what the walker steps on. For a climb, the stairs if anything of them
    // was built.
    FeatureId feature = kNoFeature;
};

struct Route {
    // From the start to the goal, or to the nearest place that can be reached. Empty if nobody can stand at the start.
    std::vector<Vec3> points_m;
    std::vector<RoutePassage> passages;  // in the order in which the walker meets them
    double length_m = 0.0;    // along the points, including the rise; a lift, climb, drop or teleporter adds nothing
    bool reaches = false;     // the last point is the goal
    double short_of_m = 0.0;  // from the last point to the goal, if the route does not reach it
    bool drops = false;       // the route goes down somewhere without a way back up there
};

// What matters if there are several routes.
enum class RouteWish : std::uint8_t {
    Safest,    // away from walls and edges, around liquids and drops
    Shortest,  // shortest in metres
    OnFoot,    // as Safest, and never by a lift, a climb, a teleporter or a drop
};

}  // namespace handrail::navigation
