// The nearest place of a way made of straight legs: how far off it somebody is, and how far along. Pure function; any
// thread; linear over the legs.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "worlds/base/vec.h"

namespace handrail {

struct WayPlace {
    Vec3 place_m{0.0};        // on the way
    double distance_m = 0.0;  // from it
    double along_m = 0.0;     // from the way's first point to it
    std::size_t leg = 0;      // from points_m[leg] to the next
};

// Of several places as near, the first along the way. Legs without length are fine; one point is a way. Expects at
// least one point.
WayPlace nearest_on_way(std::span<const Vec3> points_m, const Vec3& from_m);

// The same for somebody who was so far along it a moment ago: a way may pass near itself, so what is far along from
// there counts as farther off. height_counts: the part of a metre that a metre up or down counts; half of one for who
// walks, since over the steps of a stair the way is a straight line. `sees`: asked of the places in that order until
// one holds, since beyond a wall a way may be near too; where none does that is hardly farther off than the nearest one
// is where one was. Empty: all do.
inline constexpr double kFartherForEachMetreAlong_m = 0.05;
inline constexpr double kRoundCorner_m = 1.5;  // farther off, the nearest place hides behind something thin
inline constexpr double kHeightCountsForWalkers = 0.5;
WayPlace near_on_way(std::span<const Vec3> points_m, const Vec3& from_m, double along_m,
                     double height_counts = kHeightCountsForWalkers, const std::function<bool(const Vec3&)>& sees = {});

// The place so far along a way; its ends before and beyond them.
Vec3 place_along(std::span<const Vec3> points_m, double along_m);

}  // namespace handrail
