// What whoever teaches sees of a session. Plain data; metres of the world.
#pragma once

#include <string>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"

namespace handrail {

struct LessonView {
    Vec3 feet_m{0.0};
    int times_put = 0;  // how often the body was put there instead of walking
    double heading_rad = 0.0;
    double wall_m = 1e9;       // from the body's middle to the nearest wall
    bool trails = false;       // is led along what is at its side
    bool rooms_known = false;  // the rest only then
    std::string room;
    double perimeter_m = 0.0;  // of the room: its walls, doors and what stands against them; 0: there are none
    double walls_share = 0.0;  // how much of that is known
    int walls = 0, walls_done = 0, exits = 0, exits_found = 0;
};

}  // namespace handrail
