// Reads furniture that an author places in a map with one key. A piece is turned into the brushes that the author would
// otherwise have drawn. Used on the reading thread only.
#pragma once

#include <optional>

#include "worlds/readers/map_keys.h"
#include "worlds/scene/prefab.h"

namespace handrail::readers {

// Returns the piece of furniture that the key `prefab` names. Returns null and warns if there is no such piece, or if
// the entity also has a shape or lacks an origin.
const Prefab* prefab_of(const MapEntity& entity, Diagnostics& diagnostics);
// Returns the entity with the brushes of the piece. The middle of the piece's underside is at `origin_units`. Its front
// faces `heading_rad`, clockwise from north.
MapEntity with_prefab(const MapEntity& entity, const Prefab& prefab, const Vec3& origin_units, double heading_rad,
                      double metres_per_unit);

}  // namespace handrail::readers
