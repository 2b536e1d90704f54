// The next straight stretch of a way on foot. Pure; app thread; world metres.
#pragma once

#include <optional>

#include "worlds/navigation/route.h"

namespace handrail {

struct Leg {
    Route route;
    Vec3 to_m{0.0};
    double along_m = 0.0;  // of the route
};

// The first from there that is longer than `least_m`, with the way it belongs to; none: there is no way.
std::optional<Leg> next_leg(Route route, const Vec3& from_m, double least_m);

// What is left of a route from so far along it.
Route rest_of(const Route& route, double along_m);

}  // namespace handrail
