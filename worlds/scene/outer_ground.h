// The ground that readers lay round a building whose file ends at its walls: a place to stand on, and no thing in it.
// Pure; any thread.
#pragma once

#include "worlds/scene/scene.h"

namespace handrail {

inline constexpr const char* kOuterGround = "ground outside";

// What a reader calls a building next to the one that is read.
inline constexpr const char* kNeighbouringBuilding = "building";

inline bool is_outer_ground(const Feature& feature) { return feature.made_name && feature.name == kOuterGround; }

}  // namespace handrail
