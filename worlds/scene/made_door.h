// Doorways that a person has reported at places where the file has a wall. They are cut through the walls of the world,
// so that touch, walking, drawing and sound all have them. Pure functions over plain values; world metres; any thread.
#pragma once

#include <span>

#include "worlds/scene/scene.h"

namespace handrail {

struct MadeDoor {
    Vec3 place_m{0.0};         // the middle of the wall, at floor height
    double heading_rad = 0.0;  // direction straight through the wall
    double width_m = 0.9;
    double through_m = 0.3;  // thickness of the wall there
    std::string name;        // what it joins: "Hall, kitchen"
};

inline constexpr double kMadeDoorHigh_m = 2.05;

// Returns the world with these doors. Walls, and everything else without a name of its own, are cut away there. A door
// gets a threshold if there is no floor under the wall, and becomes a stated opening if the file states rooms. Sheets
// without an inside are not cut. The time grows with the number of solids.
Scene with_made_doors(Scene scene, std::span<const MadeDoor> doors);

}  // namespace handrail
