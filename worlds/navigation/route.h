// A way for a walking body from one place to another, as plain values: what guidance, words and the wall-side of a
// route are made of. World metres; points are where the soles stand.
#pragma once

#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"

namespace handrail {

// Something one meets on a way, or what joins two rooms.
enum class PassageKind : std::uint8_t {
    Door,
    Opening,
    Stairs,
    Lift,
    Drop,
    Teleporter,
    Climb,  // stairs that no body walks on, taken in one go: see stated_stairs.h
};

// One of them on a route.
struct RoutePassage {
    PassageKind kind = PassageKind::Door;
    Vec3 place_m{0.0};
    double at_m = 0.0;               // along the route
    double rise_m = 0.0;             // stairs, climbs, lifts and drops: to where it leads, negative down
    FeatureId feature = kNoFeature;  // the door, lift or teleporter; for stairs what one treads on, for a climb the
                                     // stairs where anything was built of them
};

struct Route {
    std::vector<Vec3> points_m;  // from the start to the goal, or to the nearest place that can be reached; empty when
                                 // one cannot stand at the start
    std::vector<RoutePassage> passages;  // in the order in which one meets them
    double length_m = 0.0;    // along the points, rise included; a lift, climb, drop or teleporter counts nothing
    bool reaches = false;     // the last point is the goal
    double short_of_m = 0.0;  // from the last point to the goal where it does not reach it
    bool drops = false;       // it goes down somewhere where one cannot go back up the same way
};

// What counts when there is a choice.
enum class RouteWish : std::uint8_t {
    Safest,    // away from walls and edges, round liquids and drops
    Shortest,  // metres only
    OnFoot,    // as Safest, and never by a lift, a climb, a teleporter or a drop
};

}  // namespace handrail
