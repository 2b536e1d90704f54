// The walls of one level. They follow the outlines of its spaces, each once, with gaps for doors. Also finds where
// spaces are open to one another. Pure functions; metres.
#pragma once

#include <array>
#include <map>

#include "worlds/floorplan/floor_plan.h"

namespace handrail::floorplan {

// A straight wall and its gaps, in rising order and separate from one another.
struct WallRun {
    Vec2 from{0.0}, to{0.0};
    struct Gap {
        // From and to are distances along the wall. A height of 0 means as high as the wall.
        double from_m = 0.0, to_m = 0.0, height_m = 0.0;
        // The higher of the two floors, relative to the floor of the level; `height_m` begins there.
        double sill_m = 0.0;
    };
    std::vector<Gap> gaps;
};

// Where a door is in its wall.
struct DoorGap {
    std::size_t door = 0;  // index in FloorPlan::doors
    Vec2 at{0.0};          // the middle of the door
    Vec2 along{1.0, 0.0};  // unit vector along the wall
    double width_m = 0.9;
    bool in_wall = false;              // false if no wall is near
    bool moved = false;                // pushed aside from a corner of walls
    std::vector<std::size_t> spaces;   // that the door joins, in rising order
    std::array<std::size_t, 2> sides;  // spaces to the left and to the right of `along`; kNoSpace: none
};
inline constexpr std::size_t kNoSpace = static_cast<std::size_t>(-1);
inline constexpr double kDoorHigh_m = 2.1, kDoorWide_m = 0.9, kLeastWay_m = 0.6;

struct LevelWalls {
    std::vector<WallRun> runs;
    std::vector<DoorGap> doors;
    // Pairs of spaces, the lesser index first, that are open to one another: the width of the opening, and where it is.
    struct Open {
        double width_m = 0.0;
        Vec2 at{0.0};
    };
    std::map<std::pair<std::size_t, std::size_t>, Open> open;
};

// `here`: the spaces of this level. The time grows with the number of corners and with how many are close together.
LevelWalls walls_of_level(const FloorPlan& plan, std::size_t level, const std::vector<std::size_t>& here);

}  // namespace handrail::floorplan
