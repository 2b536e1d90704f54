// By which strategy somebody explores, window by window, from where they walked: along the walls (perimeter), in lanes
// (grid), from thing to thing, or out from the base and back. A walk is cut into legs, each leg gets a kind, and a
// window is as long as its last legs need, so that large and small rooms are judged alike. Pure functions; the kinds
// are those of Lahav and Mioduser, the thresholds our own.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail {

enum class Strategy : std::uint8_t { None, Perimeter, Grid, ObjectToObject, BackToBase, Mixed };
inline constexpr std::size_t kStrategies = 6;

// About ten times a second.
struct WalkSample {
    double t_s = 0.0;           // rising
    Vec3 place_m{0.0};          // height does not count
    double wall_m = 1e9;        // to the nearest wall
    bool wall_touched = false;  // by the hand or the body
    int thing = -1;             // touched, faced or asked about while standing; -1: none
    bool home = false;          // came back by the key that leads to the base
};

struct StrategyTuning {
    double bend_m = 0.4, bend_share = 0.07;  // a leg ends where the way leaves its line by more than the larger of both
    double merge_deg = 35.0, merge_longer = 1.06;  // what turns less and is hardly longer than straight is one leg
    double least_leg_m = 0.5;
    double parallel_deg = 25.0, lane_m = 1.2, lane_low_m = 0.3, lane_high_m = 2.2;
    std::size_t lane_within = 5;  // legs
    double base_m = 1.0;
    double near_wall_m = 0.45, touched_s = 1.5, wall_share = 0.6;
    double direct = 1.6;  // way over distance of legs that lead from one visit to the next
    std::size_t legs = 6;
    double least_s = 20.0, most_s = 90.0, step_s = 5.0, least_way_m = 2.0;
    double share = 0.5;  // of the way of a window names it
};

struct WalkedLeg {
    double from_s = 0.0, to_s = 0.0;
    Vec3 from_m{0.0}, to_m{0.0};
    double way_m = 0.0;
    double wall_share = 0.0;  // of the way near a wall
    int from_thing = -1, to_thing = -1;
    bool from_base = false, to_base = false;
    Strategy kind = Strategy::Mixed;
};
// With their kinds.
std::vector<WalkedLeg> legs_of(std::span<const WalkSample> walk, const Vec3& base_m, const StrategyTuning& tuning = {});

struct StrategyWindow {
    double from_s = 0.0, to_s = 0.0;
    Strategy kind = Strategy::None;
    double way_m = 0.0;
    std::array<double, kStrategies> share{};  // of the way, by kind
};
std::vector<StrategyWindow> strategy_windows(std::span<const WalkSample> walk, const Vec3& base_m,
                                             const StrategyTuning& tuning = {});

}  // namespace handrail
