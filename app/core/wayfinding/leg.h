// Finds the next straight stretch of a route on foot. Pure functions for the app thread, in world metres.
#pragma once

#include <optional>

#include "worlds/navigation/route.h"

namespace handrail::core {

struct Leg {
    navigation::Route route;
    Vec3 to_m{0.0};
    double along_m = 0.0;  // distance of the beginning of the leg along the route
};

// Returns the first stretch after `from_m` that is longer than `least_m`, together with the route. Returns no value if
// there is no route.
std::optional<Leg> next_leg(navigation::Route route, const Vec3& from_m, double least_m);

// Returns the rest of `route` from the distance `along_m` on.
navigation::Route rest_of(const navigation::Route& route, double along_m);

}  // namespace handrail::core
