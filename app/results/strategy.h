// Recognises by which strategy someone explores, window by window, from where they walked. The strategies: along the
// walls (perimeter), in lanes (grid), from object to object, or out from the base and back. A walk is divided into
// legs, and each leg gets a kind. A window lasts as long as its last legs, so that large and small rooms are judged
// alike. Pure functions. The kinds are those of Lahav and Mioduser, the thresholds our own.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail::results {

enum class Strategy : std::uint8_t { None, Perimeter, Grid, ObjectToObject, BackToBase, Mixed };
inline constexpr std::size_t kStrategies = 6;

// A sample of a walk, about ten times a second.
struct WalkSample {
    double t_s = 0.0;           // in rising order
    Vec3 place_m{0.0};          // the height is ignored
    double wall_m = 1e9;        // distance to the nearest wall
    bool wall_touched = false;  // by the hand or the walker's body
    int thing = -1;             // index of the thing touched, faced or queried while standing; -1: none
    bool home = false;          // came back with the key that leads to the base
};

struct StrategyTuning {
    // A leg ends where the path leaves its straight line by more than the larger of both.
    double bend_m = 0.4, bend_share = 0.07;
    // Legs with a smaller turn, which together are hardly longer than the straight line, are joined.
    double merge_deg = 35.0, merge_longer = 1.06;
    double least_leg_m = 0.5;
    double parallel_deg = 25.0, lane_m = 1.2, lane_low_m = 0.3, lane_high_m = 2.2;
    std::size_t lane_within = 5;  // number of legs
    double base_m = 1.0;
    double near_wall_m = 0.45, touched_s = 1.5, wall_share = 0.6;
    double direct = 1.6;  // longest path over distance for legs from one visit to the next
    std::size_t legs = 6;
    double least_s = 20.0, most_s = 90.0, step_s = 5.0, least_way_m = 2.0;
    double share = 0.5;  // share of a window's path at which a kind names the window
};

struct WalkedLeg {
    double from_s = 0.0, to_s = 0.0;
    Vec3 from_m{0.0}, to_m{0.0};
    double way_m = 0.0;
    double wall_share = 0.0;  // share of the path near a wall
    int from_thing = -1, to_thing = -1;
    bool from_base = false, to_base = false;
    Strategy kind = Strategy::Mixed;
};
// Divides a walk into legs and sets their kinds.
std::vector<WalkedLeg> legs_of(std::span<const WalkSample> walk, const Vec3& base_m, const StrategyTuning& tuning = {});

struct StrategyWindow {
    double from_s = 0.0, to_s = 0.0;
    Strategy kind = Strategy::None;
    double way_m = 0.0;
    std::array<double, kStrategies> share{};  // of the path, by kind
};
std::vector<StrategyWindow> strategy_windows(std::span<const WalkSample> walk, const Vec3& base_m,
                                             const StrategyTuning& tuning = {});

}  // namespace handrail::results
