// Identifies the ground that readers add around a building whose file ends at its walls. People can stand on this
// ground, but it is not treated as a thing. Pure functions; any thread may call them.
#pragma once

#include "worlds/scene/scene.h"

namespace handrail {

inline constexpr const char* kOuterGround = "ground outside";

// The name that a reader gives to another building next to the one that it reads.
inline constexpr const char* kNeighbouringBuilding = "building";

inline bool is_outer_ground(const Feature& feature) { return feature.made_name && feature.name == kOuterGround; }

}  // namespace handrail
