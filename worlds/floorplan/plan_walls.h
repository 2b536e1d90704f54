// Makes the walls of one level. They follow the outlines of the level's spaces and have gaps for doors. A wall between
// two spaces is built only once. The result also says where spaces are open to each other. Pure functions on plain
// values in metres.
#pragma once

#include <array>
#include <map>

#include "worlds/floorplan/floor_plan.h"

namespace handrail::floorplan {

// A straight wall and its gaps. The gaps are in rising order and do not overlap.
struct WallRun {
    Vec2 from{0.0}, to{0.0};
    struct Gap {
        // from_m and to_m are distances along the wall. They may be up to half the thickness of the wall beyond its
        // ends, because the wall reaches as far. A height_m of 0 means that the gap is as high as the wall.
        double from_m = 0.0, to_m = 0.0, height_m = 0.0;
        // Height of the higher of the two floors, relative to the floor of the level. `height_m` is measured from
        // `sill_m`.
        double sill_m = 0.0;
    };
    std::vector<Gap> gaps;
};

// The place of a door in its wall.
struct DoorGap {
    std::size_t door = 0;  // index into FloorPlan::doors
    Vec2 at{0.0};          // the middle of the door
    Vec2 along{1.0, 0.0};  // unit vector along the wall
    double width_m = 0.9;
    bool in_wall = false;              // true if the door is in a wall; false if no wall is near
    bool moved = false;                // the door was moved away from a corner of walls
    std::vector<std::size_t> spaces;   // the spaces that the door connects, as rising indices
    std::array<std::size_t, 2> sides;  // the spaces to the left and to the right of `along`; kNoSpace: none
};
inline constexpr std::size_t kNoSpace = static_cast<std::size_t>(-1);
inline constexpr double kDoorHigh_m = 2.1, kDoorWide_m = 0.9, kLeastWay_m = 0.6;

struct LevelWalls {
    std::vector<WallRun> runs;
    std::vector<DoorGap> doors;
    // The greatest opening between two spaces that are open to each other: its width and its middle. The key is the
    // pair of spaces, with the lesser index first.
    struct Open {
        double width_m = 0.0;
        Vec2 at{0.0};
    };
    std::map<std::pair<std::size_t, std::size_t>, Open> open;
};

// Makes the walls of a level. `here` lists the spaces of this level. The time grows with the number of corners, and
// with how many of them are close together.
LevelWalls walls_of_level(const FloorPlan& plan, std::size_t level, const std::vector<std::size_t>& here);

}  // namespace handrail::floorplan
