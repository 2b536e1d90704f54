// Finds where people can stand in a column: the free stretches between obstacles that have a floor below. The tiles of
// the flood use these functions, and so does the estimate of the whole floor area.
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

// Least difference between a floor and the highest possible position of the soles above it.
inline constexpr double kLeastRoom_m = 1e-3;
inline constexpr double kSky = 1e7;

// The range of heights in a column that one obstacle occupies.
struct ColumnInterval {
    double low = 0.0, high = 0.0;
    std::uint32_t obstacle = 0;
    bool steep = false;
};

// Sorts by the lower ends, stably. Insertion sort is fastest for most columns, because they have few intervals.
inline void from_below(std::span<ColumnInterval> intervals) {
    const auto lower = [](const ColumnInterval& a, const ColumnInterval& b) { return a.low < b.low; };
    if (intervals.size() > 16) return std::stable_sort(intervals.begin(), intervals.end(), lower);
    for (std::size_t i = 1; i < intervals.size(); ++i)
        for (std::size_t k = i; k > 0 && lower(intervals[k], intervals[k - 1]); --k)
            std::swap(intervals[k], intervals[k - 1]);
}

// Finds the free stretches of one column that have a floor to stand on, from below. `intervals` of obstacles and
// `floors` of movers must be sorted by their lower ends. Intervals for which `skip` returns true are ignored. Calls
// `put(floor, ceiling, ground)` for each stretch.
template <class Skip, class Put>
void free_stretches(std::span<const ColumnInterval> intervals, std::span<const ColumnInterval> floors, double step_up_m,
                    Skip skip, Put put) {
    // Returns whether the floor of a mover covers this floor, at most a step higher.
    const auto covered = [&](double floor_m) {
        return std::any_of(floors.begin(), floors.end(), [&](const ColumnInterval& f) {
            return !f.steep && f.high > floor_m + kLeastRoom_m && f.high <= floor_m + step_up_m;
        });
    };
    const auto bearable = [&](double from, double to) {  // adds the floors of movers within a free stretch
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
        // If several tops have the same height, use one that people can stand on.
        if (i.high > top + kWalkRounding_m || (i.high > top - kWalkRounding_m && steep && !i.steep)) {
            top = std::max(top, i.high);
            ground = i.obstacle;
            steep = i.steep;
        }
    }
    if (!steep && !covered(top)) put(top, kSky, ground);
    bearable(top, kSky);
}

// Estimates the floor area of the whole scene on which people could stand, whether they can get there or not. Ground
// that is left out is not included. The estimate determines how fine the columns can be. If there are many obstacles,
// it comes from a fixed number of sampled columns, with an error of a few percent.
double standable_m2(const Obstacles& obstacles, const WalkerMeasures& body, const NearGround& ground,
                    double exact_enough_m2);

}  // namespace handrail::navigation
