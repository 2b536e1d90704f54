// Cuts doorways that a person has reported at places where the file has a wall. They are cut through the walls of the
// world, so that touch, walking, drawing and sound all have them. Pure functions over plain values in world metres; any
// thread may call them.
#pragma once

#include <span>

#include "worlds/scene/scene.h"

namespace handrail {

struct MadeDoor {
    Vec3 place_m{0.0};         // the middle of the wall, at floor height
    double heading_rad = 0.0;  // direction in which a walker goes straight through the wall
    double width_m = 0.9;
    double through_m = 0.3;  // thickness of the wall at the door
    std::string name;        // names of the two rooms that the doorway connects: "Hall, kitchen"
};

inline constexpr double kMadeDoorHigh_m = 2.05;

// Returns the world with these doors. In the doorways, walls and everything else without an own name are cut away. A
// door gets a threshold if there is no floor below the wall. If the file states rooms, each door also becomes a stated
// opening. Sheets without an inside are not cut. The time grows with the number of solids.
Scene with_made_doors(Scene scene, std::span<const MadeDoor> doors);

}  // namespace handrail
