// Reads the keys of soft objects, such as a cushion or clay.
#pragma once

#include <optional>
#include <string>

#include "worlds/readers/map_keys.h"
#include "worlds/scene/scene.h"

namespace handrail::readers {

// The soft face of each brush of an entity, as the keys of the entity state it.
struct SoftOptions {
    SoftFace face;             // a depth of 0 stands for half of the thickness
    Vec3 side{0.0, 0.0, 1.0};  // direction of the face that is soft
    TextPlace place;           // place of the key `soft` in the file
    TextPlace depth_place;     // place of the key `soft_depth` in the file
};

// Reads the keys. Returns nothing if the key `soft` is missing. If its value is unknown or the depth is faulty, reports
// that and returns nothing; the object then stays hard.
std::optional<SoftOptions> soft_options_of(const MapEntity& entity, double metres_per_unit, Diagnostics& diagnostics);

// Returns the soft face of one brush. Reduces a depth that would leave nothing hard below the soft layer.
std::optional<SoftFace> soft_face_of(const SoftOptions& options, const ConvexSolid& shape, const std::string& name,
                                     Diagnostics& diagnostics);

}  // namespace handrail::readers
