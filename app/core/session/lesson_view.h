// Defines the state of a session as a teacher sees it. Plain data in world metres.
#pragma once

#include <string>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"

namespace handrail::core {

struct LessonView {
    Vec3 feet_m{0.0};
    int times_put = 0;  // how often the walker was moved to this place instead of walking
    double heading_rad = 0.0;
    double wall_m = 1e9;       // distance from the walker's centre to the nearest wall
    bool trails = false;       // true: the walker is following a wall
    bool rooms_known = false;  // true: the fields below are valid
    std::string room;
    // Length of the room's walls, with doors and what stands against the walls; 0: there are none.
    double perimeter_m = 0.0;
    double walls_share = 0.0;  // share of `perimeter_m` that the person knows
    int walls = 0, walls_done = 0, exits = 0, exits_found = 0;
};

}  // namespace handrail::core
