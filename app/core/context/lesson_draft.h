// What an instructor has put together in the program for a lesson of three sessions: the owner writes the file. Plain
// data; metres of the world.
#pragma once

#include <string>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail {

struct LessonDraft {
    // A thing or a room by the name that files know it by; else a place of its own.
    struct Place {
        std::string name, thing, room;
        Vec3 place_m{0.0};
    };
    std::string title;
    Vec3 base_feet_m{0.0};
    double base_heading_rad = 0.0;
    std::string base_room;  // as it is called; empty: none
    std::vector<Place> landmarks;
    std::vector<Place> stops;  // of the route, in order
};

}  // namespace handrail
