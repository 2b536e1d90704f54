// Recognises by which strategy a person explores, from the path that the person walked. The strategies: along the walls
// (perimeter), in lanes (grid), from object to object, or out from the base and back. The functions divide the walk
// into legs and give each leg a kind. They then give each window of several legs a strategy. Windows have no fixed
// length, so that large and small rooms are judged alike. Pure functions. The kinds are those of Lahav and Mioduser; we
// chose the thresholds.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail::results {

enum class Strategy : std::uint8_t { None, Perimeter, Grid, ObjectToObject, BackToBase, Mixed };
inline constexpr std::size_t kStrategies = 6;

// A sample of a walk. There are about ten samples a second.
struct WalkSample {
    double t_s = 0.0;           // time, in rising order
    Vec3 place_m{0.0};          // position; the height is ignored
    double wall_m = 1e9;        // distance to the nearest wall
    bool wall_touched = false;  // the hand or the walker's body touched the wall
    int thing = -1;     // index of the object that the walker touched, faced or asked about while standing; -1: none
    bool home = false;  // the walker came here with the key that leads back to the base
};

struct StrategyTuning {
    // A leg ends where the path deviates from a straight line by more than bend_m and by more than bend_share of the
    // line's length.
    double bend_m = 0.4, bend_share = 0.07;
    // Two legs are joined if the turn between them is less than merge_deg, and if their path is nearly straight. The
    // length of this path must be at most merge_longer times the distance between its ends.
    double merge_deg = 35.0, merge_longer = 1.06;
    double least_leg_m = 0.5;
    double parallel_deg = 25.0, lane_m = 1.2, lane_low_m = 0.3, lane_high_m = 2.2;
    std::size_t lane_within = 5;  // greatest difference between the indices of two legs that are lanes of one grid
    double base_m = 1.0;
    double near_wall_m = 0.45, touched_s = 1.5, wall_share = 0.6;
    // For the path from one visit to the next: greatest ratio of its length to the straight distance, if it is direct.
    double direct = 1.6;
    std::size_t legs = 6;
    double least_s = 20.0, most_s = 90.0, step_s = 5.0, least_length_m = 2.0;
    double share = 0.5;  // a window gets the strategy of a kind that has at least this share of the window's path
};

struct WalkedLeg {
    double from_s = 0.0, to_s = 0.0;
    Vec3 from_m{0.0}, to_m{0.0};
    double way_m = 0.0;
    double wall_share = 0.0;  // share of the leg's path that is near a wall
    int from_thing = -1, to_thing = -1;
    bool from_base = false, to_base = false;
    Strategy kind = Strategy::Mixed;
};
// Divides a walk into legs and sets the kind of each leg.
std::vector<WalkedLeg> legs_of(std::span<const WalkSample> walk, const Vec3& base_m, const StrategyTuning& tuning = {});

struct StrategyWindow {
    double from_s = 0.0, to_s = 0.0;
    Strategy kind = Strategy::None;
    double way_m = 0.0;
    std::array<double, kStrategies> share{};  // for each kind: its share of the window's path
};
std::vector<StrategyWindow> strategy_windows(std::span<const WalkSample> walk, const Vec3& base_m,
                                             const StrategyTuning& tuning = {});

}  // namespace handrail::results
