// What an instructor has put together in the program for a lesson of three sessions: the owner writes the file. Plain
// data; metres of the world.
#pragma once

#include <string>
#include <vector>

#include "worlds/geometry/convex.h"

namespace handrail {

struct LessonDraft {
    // A thing or a room by the name that files know it by; else a place of its own.
    struct Place {
        std::string name, thing, room;
        Vec3 place_m{0.0};
        Aabb box_m{};  // of a landmark: all of it
    };
    std::string title;
    Vec3 base_feet_m{0.0};
    double base_heading_rad = 0.0;
    std::string base_room;  // as it is called; empty: none, or the ground outside, which has no walls to learn
    std::vector<Place> landmarks;
    std::vector<Place> stops;           // of the route, in order
    std::vector<std::string> asked;     // landmarks that are asked for from the base: all but those under its feet
    std::vector<std::string> on_route;  // of those the ones that the route comes to, in its order
    std::string world_checksum;         // empty: unknown
};

}  // namespace handrail
