#include "app/results/strategy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handrail::results {
namespace {

constexpr double kDegree_rad = std::numbers::pi / 180.0;

double flat_length_m(const Vec3& a, const Vec3& b) { return std::hypot(b.x - a.x, b.y - a.y); }
double length_of(const WalkedLeg& leg) { return flat_length_m(leg.from_m, leg.to_m); }
double course_of(const WalkedLeg& leg) { return std::atan2(leg.to_m.x - leg.from_m.x, leg.to_m.y - leg.from_m.y); }
double turn_between(double a_rad, double b_rad) {
    return std::abs(std::remainder(b_rad - a_rad, 2.0 * std::numbers::pi));
}

// Returns the horizontal distance of `p` from the line segment between `a` and `b`.
double off_line(const Vec3& a, const Vec3& b, const Vec3& p) {
    const double ux = b.x - a.x, uy = b.y - a.y, square = ux * ux + uy * uy;
    const double along = square > 0.0 ? std::clamp(((p.x - a.x) * ux + (p.y - a.y) * uy) / square, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - a.x - along * ux, p.y - a.y - along * uy);
}

bool at_base(const WalkSample& sample, const Vec3& base_m, const StrategyTuning& tuning) {
    return sample.home || flat_length_m(sample.place_m, base_m) < tuning.base_m;
}

// Returns the indices of the samples at which legs end: at visits, and at bends of the path.
std::vector<std::size_t> cuts_of(std::span<const WalkSample> walk, const StrategyTuning& tuning) {
    std::vector<std::size_t> cuts{0};
    for (std::size_t i = 1; i < walk.size(); ++i)
        if (walk[i].thing >= 0 && walk[i].thing != walk[i - 1].thing && i > cuts.back()) cuts.push_back(i);
    if (cuts.back() + 1 < walk.size()) cuts.push_back(walk.size() - 1);
    // Split each part at its worst bend until all parts are straight. Work from the start of the walk to its end.
    std::vector<std::size_t> open(cuts.rbegin(), cuts.rend()), done;
    done.push_back(open.back());
    open.pop_back();
    while (!open.empty()) {
        const std::size_t first = done.back(), last = open.back();
        const Vec3 &a = walk[first].place_m, &b = walk[last].place_m;
        double worst_m = std::max(tuning.bend_m, tuning.bend_share * flat_length_m(a, b));
        std::size_t at = last;
        for (std::size_t i = first + 1; i < last; ++i)
            if (const double off_m = off_line(a, b, walk[i].place_m); off_m > worst_m) worst_m = off_m, at = i;
        if (at != last) {
            open.push_back(at);
        } else {
            done.push_back(last);
            open.pop_back();
        }
    }
    return done;
}

std::vector<WalkedLeg> cut_legs(std::span<const WalkSample> walk, const Vec3& base_m, const StrategyTuning& tuning) {
    std::vector<WalkedLeg> legs;
    const std::vector<std::size_t> cuts = cuts_of(walk, tuning);
    double touched_s = -1e9;
    for (std::size_t c = 1; c < cuts.size(); ++c) {
        const WalkSample &from = walk[cuts[c - 1]], &to = walk[cuts[c]];
        WalkedLeg leg{from.t_s,
                      to.t_s,
                      from.place_m,
                      to.place_m,
                      0.0,
                      0.0,
                      from.thing,
                      to.thing,
                      at_base(from, base_m, tuning),
                      at_base(to, base_m, tuning),
                      Strategy::Mixed};
        double near_m = 0.0;
        for (std::size_t i = cuts[c - 1] + 1; i <= cuts[c]; ++i) {
            if (walk[i].wall_touched) touched_s = walk[i].t_s;
            const double step_m = flat_length_m(walk[i - 1].place_m, walk[i].place_m);
            leg.way_m += step_m;
            if (walk[i].wall_m < tuning.near_wall_m || walk[i].t_s - touched_s < tuning.touched_s) near_m += step_m;
        }
        if (leg.way_m <= tuning.least_leg_m) continue;
        leg.wall_share = near_m / leg.way_m;
        legs.push_back(leg);
    }
    return legs;
}

// Joins two legs if they were split at a bend but continue in nearly the same direction.
void join_straight(std::vector<WalkedLeg>& legs, const StrategyTuning& tuning) {
    constexpr double kSlack_m = 0.2;
    std::vector<WalkedLeg> joined;
    for (const WalkedLeg& leg : legs) {
        if (joined.empty()) {
            joined.push_back(leg);
            continue;
        }
        WalkedLeg& last = joined.back();
        const double way_m = last.way_m + leg.way_m;
        if (last.to_thing >= 0 || leg.from_thing >= 0 || last.to_base ||
            turn_between(course_of(last), course_of(leg)) >= tuning.merge_deg * kDegree_rad ||
            way_m > tuning.merge_longer * flat_length_m(last.from_m, leg.to_m) + kSlack_m) {
            joined.push_back(leg);
            continue;
        }
        last.wall_share = (last.wall_share * last.way_m + leg.wall_share * leg.way_m) / way_m;
        last.way_m = way_m;
        last.to_s = leg.to_s;
        last.to_m = leg.to_m;
        last.to_thing = leg.to_thing;
        last.to_base = leg.to_base;
    }
    legs = std::move(joined);
}

// Returns true if two legs are lanes of one grid, which run side by side in opposite directions.
bool are_lanes(const WalkedLeg& a, const WalkedLeg& b, const StrategyTuning& tuning) {
    const double long_m = length_of(a), other_m = length_of(b);
    if (other_m < 0.5 * long_m || long_m < 0.5 * other_m) return false;
    const double course = course_of(a);
    if (turn_between(course + std::numbers::pi, course_of(b)) > tuning.parallel_deg * kDegree_rad) return false;
    const double mx = 0.5 * (b.from_m.x + b.to_m.x - a.from_m.x - a.to_m.x);
    const double my = 0.5 * (b.from_m.y + b.to_m.y - a.from_m.y - a.to_m.y);
    const double beside_m = std::abs(mx * std::cos(course) - my * std::sin(course));
    const double along_m = std::abs(mx * std::sin(course) + my * std::cos(course));
    return beside_m >= tuning.lane_low_m && beside_m <= tuning.lane_high_m && along_m < 0.5 * long_m;
}

bool visits(const WalkedLeg& leg) { return leg.from_thing >= 0 || leg.to_thing >= 0; }

void find_lanes(std::vector<WalkedLeg>& legs, const StrategyTuning& tuning) {
    for (std::size_t i = 0; i < legs.size(); ++i) {
        if (length_of(legs[i]) < tuning.lane_m || legs[i].wall_share >= tuning.wall_share) continue;
        const std::size_t first = i - std::min(i, tuning.lane_within);
        const std::size_t last = std::min(i + tuning.lane_within, legs.size() - 1);
        for (std::size_t j = first; j <= last; ++j)
            if (j != i && are_lanes(legs[i], legs[j], tuning)) legs[i].kind = Strategy::Grid;
    }
}

Strategy kind_of(const WalkedLeg& leg, bool between_lanes, const StrategyTuning& tuning) {
    const bool from_thing_to_thing = leg.from_thing >= 0 && leg.to_thing >= 0 && leg.from_thing != leg.to_thing;
    if (!visits(leg) && (leg.kind == Strategy::Grid || between_lanes)) return Strategy::Grid;
    if ((leg.from_base || leg.to_base) && visits(leg) && !from_thing_to_thing) return Strategy::BackToBase;
    if (leg.wall_share >= tuning.wall_share && !from_thing_to_thing) return Strategy::Perimeter;
    return visits(leg) ? Strategy::ObjectToObject : Strategy::Mixed;
}

void name_legs(std::vector<WalkedLeg>& legs, const StrategyTuning& tuning) {
    // A leg that joins two lanes may exceed the greatest distance between lanes (lane_high_m) by this length.
    constexpr double kStep_m = 0.4;
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const bool between = i > 0 && i + 1 < legs.size() && legs[i - 1].kind == Strategy::Grid &&
                             legs[i + 1].kind == Strategy::Grid && length_of(legs[i]) <= tuning.lane_high_m + kStep_m;
        legs[i].kind = kind_of(legs[i], between, tuning);
    }
}

// Finds each path from one visit to the next, or between a visit and the base. If the path is direct enough and no leg
// of it follows a wall, gives all its legs the same kind.
void name_paths(std::vector<WalkedLeg>& legs, const StrategyTuning& tuning) {
    constexpr double kSlack_m = 0.5;
    for (std::size_t first = 0; first < legs.size();) {
        std::size_t last = first;
        double way_m = legs[first].way_m;
        while (last + 1 < legs.size() && legs[last].to_thing < 0 && !legs[last].to_base) way_m += legs[++last].way_m;
        const WalkedLeg &a = legs[first], &b = legs[last];
        const bool ends = b.to_thing >= 0 || b.to_base;
        const bool based = (a.from_base && b.to_thing >= 0) || (b.to_base && a.from_thing >= 0);
        const bool along_wall = std::any_of(legs.begin() + static_cast<std::ptrdiff_t>(first),
                                            legs.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                                            [](const WalkedLeg& leg) { return leg.kind == Strategy::Perimeter; });
        if (ends && last > first && !along_wall &&
            way_m <= tuning.direct * flat_length_m(a.from_m, b.to_m) + kSlack_m &&
            (based || (a.from_thing >= 0 && b.to_thing >= 0)))
            for (std::size_t i = first; i <= last; ++i)
                legs[i].kind = based ? Strategy::BackToBase : Strategy::ObjectToObject;
        first = last + 1;
    }
}

}  // namespace

std::vector<WalkedLeg> legs_of(std::span<const WalkSample> walk, const Vec3& base_m, const StrategyTuning& tuning) {
    if (walk.size() < 2) return {};
    std::vector<WalkedLeg> legs = cut_legs(walk, base_m, tuning);
    join_straight(legs, tuning);
    find_lanes(legs, tuning);
    name_legs(legs, tuning);
    name_paths(legs, tuning);
    return legs;
}

std::vector<StrategyWindow> strategy_windows(std::span<const WalkSample> walk, const Vec3& base_m,
                                             const StrategyTuning& tuning) {
    std::vector<StrategyWindow> windows;
    if (walk.size() < 3) return windows;
    const std::vector<WalkedLeg> legs = legs_of(walk, base_m, tuning);
    const double first_s = walk.front().t_s, last_s = walk.back().t_s;
    for (double to_s = first_s + tuning.least_s; to_s <= last_s + 1e-6; to_s += tuning.step_s) {
        double from_s = to_s - tuning.least_s;
        const auto begun =
            std::partition_point(legs.begin(), legs.end(), [to_s](const WalkedLeg& leg) { return leg.from_s < to_s; });
        const auto count = std::min<std::ptrdiff_t>(begun - legs.begin(), static_cast<std::ptrdiff_t>(tuning.legs));
        if (count > 0) from_s = std::min(from_s, (begun - count)->from_s);
        StrategyWindow window{std::max({from_s, to_s - tuning.most_s, first_s}), to_s, Strategy::None, 0.0, {}};
        for (const WalkedLeg& leg : legs) {
            const double part_s = std::min(leg.to_s, to_s) - std::max(leg.from_s, window.from_s);
            if (part_s <= 0.0) continue;
            const double way_m = leg.way_m * part_s / (leg.to_s - leg.from_s);
            window.way_m += way_m;
            window.share[static_cast<std::size_t>(leg.kind)] += way_m;
        }
        if (window.way_m >= tuning.least_length_m) {
            for (double& share : window.share) share /= window.way_m;
            const auto most = std::max_element(window.share.begin() + 1, window.share.end() - 1);
            window.kind = *most >= tuning.share ? static_cast<Strategy>(most - window.share.begin()) : Strategy::Mixed;
        }
        windows.push_back(window);
    }
    return windows;
}

}  // namespace handrail::results
