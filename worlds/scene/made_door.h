// Doorways that a person has said to be where the file has a wall: cut through the walls of a world, so that every view
// of it has them. Pure functions over plain values; world metres; any thread.
#pragma once

#include <span>

#include "worlds/scene/scene.h"

namespace handrail {

struct MadeDoor {
    Vec3 place_m{0.0};         // the middle of the wall, at floor height
    double heading_rad = 0.0;  // straight through it
    double width_m = 0.9;
    double through_m = 0.3;  // how thick the wall is there
    std::string name;        // "Hall, kitchen": what it joins
};

inline constexpr double kMadeDoorHigh_m = 2.05;

// The world with walls, and all else that has no name of its own, cut away where these doors are, a threshold where the
// file has no floor under the wall, and each a stated opening where the file states rooms. Sheets without an inside
// stay. Time goes with the solids.
Scene with_made_doors(Scene scene, std::span<const MadeDoor> doors);

}  // namespace handrail
