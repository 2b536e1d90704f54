// Keys of things that give way: a cushion, clay.
#pragma once

#include <optional>
#include <string>

#include "worlds/readers/map_keys.h"
#include "worlds/scene/scene.h"

namespace handrail {

// What an entity wants of each of its brushes.
struct SoftWish {
    SoftFace face;             // its depth 0: half of what there is
    Vec3 side{0.0, 0.0, 1.0};  // which face gives way
    TextPlace place;           // of the key `soft`
    TextPlace depth_place;     // of the key `soft_depth`
};

// Nothing where the key `soft` is not there, or is no kind, or has no depth: then the thing is hard, and that is said.
std::optional<SoftWish> soft_wish_of(const MapEntity& entity, double metres_per_unit, Diagnostics& diagnostics);

// For one brush. A depth that leaves nothing underneath is made less.
std::optional<SoftFace> soft_face_of(const SoftWish& wish, const ConvexSolid& shape, const std::string& name,
                                     Diagnostics& diagnostics);

}  // namespace handrail
