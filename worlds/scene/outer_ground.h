// The ground that readers lay round a building whose file ends at its walls. One can stand on it, but it does not count
// as a thing. Pure; any thread.
#pragma once

#include "worlds/scene/scene.h"

namespace handrail {

inline constexpr const char* kOuterGround = "ground outside";

// A reader's name for a building next to the one that it reads.
inline constexpr const char* kNeighbouringBuilding = "building";

inline bool is_outer_ground(const Feature& feature) { return feature.made_name && feature.name == kOuterGround; }

}  // namespace handrail
