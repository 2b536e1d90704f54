// Describes the draft of a lesson of three sessions, which an instructor has prepared in the program. The owner of the
// session writes the draft to a file. Plain data in world metres.
#pragma once

#include <string>
#include <vector>

#include "worlds/geometry/convex.h"

namespace handrail::core {

struct LessonDraft {
    // A thing or a room, under its name in files. If both names are empty, the place is only a position.
    struct Place {
        std::string name, thing, room;
        Vec3 place_m{0.0};
        Aabb box_m{};  // bounding box of the whole landmark
    };
    std::string title;
    Vec3 base_feet_m{0.0};
    double base_heading_rad = 0.0;
    // Spoken name of the room that contains the base. Empty if the base is in no room, or outdoors, which has no walls
    // to learn.
    std::string base_room;
    std::vector<Place> landmarks;
    std::vector<Place> stops;  // stops of the route, in order
    // Landmarks that the learner must locate from the base: all landmarks except those at the base itself.
    std::vector<std::string> requested;
    std::vector<std::string> on_route;   // those of `requested` that the route passes, in the order of the route
    std::vector<std::string> questions;  // questions that were set in this world; the third session asks them
    std::string world_checksum;          // checksum of the world file; empty: not known
};

}  // namespace handrail::core
