// Reads the keys of soft things, such as a cushion or clay.
#pragma once

#include <optional>
#include <string>

#include "worlds/readers/map_keys.h"
#include "worlds/scene/scene.h"

namespace handrail::readers {

// What an entity's keys request for each of its brushes.
struct SoftWish {
    SoftFace face;             // a depth of 0 means half of the thickness
    Vec3 side{0.0, 0.0, 1.0};  // direction of the face that gives way
    TextPlace place;           // where the key `soft` is
    TextPlace depth_place;     // where the key `soft_depth` is
};

// Returns nothing if the key `soft` is missing, unknown or without depth. In the last two cases the thing stays hard,
// and that is reported.
std::optional<SoftWish> soft_wish_of(const MapEntity& entity, double metres_per_unit, Diagnostics& diagnostics);

// The soft face of one brush. A depth that would leave nothing hard underneath is reduced.
std::optional<SoftFace> soft_face_of(const SoftWish& wish, const ConvexSolid& shape, const std::string& name,
                                     Diagnostics& diagnostics);

}  // namespace handrail::readers
