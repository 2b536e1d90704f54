// What an instructor has put together in the program for a lesson of three sessions. The owner of the session writes it
// to a file. Plain data; world metres.
#pragma once

#include <string>
#include <vector>

#include "worlds/geometry/convex.h"

namespace handrail::core {

struct LessonDraft {
    // A thing or a room under its name in files; otherwise just a position.
    struct Place {
        std::string name, thing, room;
        Vec3 place_m{0.0};
        Aabb box_m{};  // whole extent of a landmark
    };
    std::string title;
    Vec3 base_feet_m{0.0};
    double base_heading_rad = 0.0;
    std::string base_room;  // as it is spoken; empty: none, or outdoors, which has no walls to learn
    std::vector<Place> landmarks;
    std::vector<Place> stops;  // of the route, in order
    // Landmarks that the learner must locate from the base: all except those at its feet.
    std::vector<std::string> asked;
    std::vector<std::string> on_route;  // those of `asked` that the route passes, in its order
    std::string world_checksum;         // empty: unknown
};

}  // namespace handrail::core
