// Furniture that one key places in a map. It is turned into the brushes that an author would have drawn. One reading
// thread.
#pragma once

#include <optional>

#include "worlds/readers/map_keys.h"
#include "worlds/scene/prefab.h"

namespace handrail::readers {

// The piece of furniture that the key `prefab` names. Returns null with a warning if there is no such piece, or if the
// entity also has a shape or no origin.
const Prefab* prefab_of(const MapEntity& entity, Diagnostics& diagnostics);
// The entity with the brushes of the piece: the middle of its floor is at `origin`, its front faces `heading_rad`,
// clockwise from north.
MapEntity with_prefab(const MapEntity& entity, const Prefab& prefab, const Vec3& origin_units, double heading_rad,
                      double metres_per_unit);

}  // namespace handrail::readers
