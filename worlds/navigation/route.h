// Defines a walking route from one place to another as plain values. Guidance and spoken directions use it, and so does
// the touchable wall along the route. World metres; points are at the height of the soles.
#pragma once

#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"

namespace handrail::navigation {

// The kind of a passage. A passage is something that the walker passes on a route, or that joins two rooms.
enum class PassageKind : std::uint8_t {
    Door,
    Opening,
    Stairs,
    Lift,
    Drop,
    Teleporter,
    Climb,  // stairs without walkable steps, which the walker uses like a lift: see stated_stairs.h
};

// Something that the walker passes on a route, such as a door.
struct RoutePassage {
    PassageKind kind = PassageKind::Door;
    Vec3 place_m{0.0};
    double at_m = 0.0;    // distance along the route
    double rise_m = 0.0;  // rise of stairs, climbs, lifts and drops; negative: down
    // The door, lift or teleporter. For stairs: the object that the walker steps on. For a climb: the stairs;
    // kNoFeature if the file contains no shape for them.
    FeatureId feature = kNoFeature;
};

struct Route {
    // The points of the route, from the start to the goal or to the nearest place that can be reached. Empty if nobody
    // can stand at the start.
    std::vector<Vec3> points_m;
    std::vector<RoutePassage> passages;  // in the order in which the walker reaches them
    // Length along the points, including the rise; a lift, climb, drop or teleporter adds nothing.
    double length_m = 0.0;
    bool reaches = false;     // the last point is the goal
    double short_of_m = 0.0;  // distance from the last point to the goal, if the route does not reach the goal
    bool drops = false;       // at some place the route goes down and cannot be walked back up
};

// Which of several possible routes the planner prefers.
enum class RoutePreference : std::uint8_t {
    Safest,    // keeps away from walls and edges, and avoids liquids and drops
    Shortest,  // the shortest route in metres
    OnFoot,    // as Safest, and never by a lift, a climb, a teleporter or a drop
};

}  // namespace handrail::navigation
