// Finds where people can stand in a column: the free stretches between obstacles, with a floor below. Used for the
// tiles and for the estimate of how much floor there is.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "worlds/navigation/near_ground.h"
#include "worlds/navigation/walk_obstacles.h"
#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

inline constexpr double kLeastRoom_m = 1e-3;  // least distance between the floor and the highest place of the soles
inline constexpr double kSky = 1e7;

// The part of a column that one obstacle occupies.
struct ColumnInterval {
    double low = 0.0, high = 0.0;
    std::uint32_t obstacle = 0;
    bool steep = false;
};

// Sorts by the lower ends, stably. Insertion sort suits most columns, which have few intervals.
inline void from_below(std::span<ColumnInterval> intervals) {
    const auto lower = [](const ColumnInterval& a, const ColumnInterval& b) { return a.low < b.low; };
    if (intervals.size() > 16) return std::stable_sort(intervals.begin(), intervals.end(), lower);
    for (std::size_t i = 1; i < intervals.size(); ++i)
        for (std::size_t k = i; k > 0 && lower(intervals[k], intervals[k - 1]); --k)
            std::swap(intervals[k], intervals[k - 1]);
}

// Finds the free stretches of one column with a floor to stand on, from below. `intervals`, and `floors` of movers,
// must be sorted by their lower ends. Intervals for which `skip` is true are ignored. Calls `put(floor, ceiling,
// ground)` for each stretch.
template <class Skip, class Put>
void free_stretches(std::span<const ColumnInterval> intervals, std::span<const ColumnInterval> floors, double step_up_m,
                    Skip skip, Put put) {
    const auto covered = [&](double floor_m) {  // by the floor of a mover, at most a step higher
        return std::any_of(floors.begin(), floors.end(), [&](const ColumnInterval& f) {
            return !f.steep && f.high > floor_m + kLeastRoom_m && f.high <= floor_m + step_up_m;
        });
    };
    const auto bearable = [&](double from, double to) {  // floors of movers within a free stretch
        for (const ColumnInterval& f : floors)
            if (!f.steep && f.high > from + kLeastRoom_m && f.high < to - kLeastRoom_m) put(f.high, to, f.obstacle);
    };
    double top = -std::numeric_limits<double>::infinity();
    std::uint32_t ground = kNothing;
    bool steep = true;
    for (const ColumnInterval& i : intervals) {
        if (skip(i)) continue;
        if (i.low > top + kLeastRoom_m) {
            if (!steep && !covered(top)) put(top, i.low, ground);
            bearable(top, i.low);
        }
        // If several tops have the same height, one that people can stand on takes precedence.
        if (i.high > top + kWalkRounding_m || (i.high > top - kWalkRounding_m && steep && !i.steep)) {
            top = std::max(top, i.high);
            ground = i.obstacle;
            steep = i.steep;
        }
    }
    if (!steep && !covered(top)) put(top, kSky, ground);
    bearable(top, kSky);
}

// Estimates the area of floor to stand on in the whole scene, reached or not, without ground that is left out. It
// decides how fine the columns can be. The error is a few percent: if there are many obstacles, a fixed number of
// columns is sampled.
double standable_m2(const Obstacles& obstacles, const WalkerMeasures& body, const NearGround& ground,
                    double exact_enough_m2);

}  // namespace handrail::navigation
