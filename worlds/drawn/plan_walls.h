// The walls of one level: along the outlines of its spaces, each once, with gaps where doors are; and where spaces lie
// open to one another. Pure functions; metres.
#pragma once

#include <array>
#include <map>

#include "worlds/drawn/floor_plan.h"

namespace handrail {

// A straight wall, and where it is open: rising, apart from one another.
struct WallRun {
    Vec2 from{0.0}, to{0.0};
    struct Gap {
        double from_m = 0.0, to_m = 0.0, height_m = 0.0;  // along the wall; a height of 0: as high as the wall
        double sill_m = 0.0;  // where the higher of the two floors is, over that of the level; `height_m` begins there
    };
    std::vector<Gap> gaps;
};

// How a door stands in its wall.
struct DoorGap {
    std::size_t door = 0;  // place in FloorPlan::doors
    Vec2 at{0.0};          // its middle
    Vec2 along{1.0, 0.0};  // unit, along the wall
    double width_m = 0.9;
    bool in_wall = false;              // else no wall is near
    bool moved = false;                // aside, from where walls meet
    std::vector<std::size_t> spaces;   // that it joins, rising
    std::array<std::size_t, 2> sides;  // what lies to the left and to the right of `along`; kNoSpace: nothing
};
inline constexpr std::size_t kNoSpace = static_cast<std::size_t>(-1);
inline constexpr double kDoorHigh_m = 2.1, kDoorWide_m = 0.9, kLeastWay_m = 0.6;

struct LevelWalls {
    std::vector<WallRun> runs;
    std::vector<DoorGap> doors;
    // Pairs of spaces, the lesser first, that lie open to one another: how wide, and where.
    struct Open {
        double width_m = 0.0;
        Vec2 at{0.0};
    };
    std::map<std::pair<std::size_t, std::size_t>, Open> open;
};

// `here`: the spaces of this level. Its time goes with the corners there and with how many lie near one another.
LevelWalls walls_of_level(const FloorPlan& plan, std::size_t level, const std::vector<std::size_t>& here);

}  // namespace handrail
