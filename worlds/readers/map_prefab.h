// Furniture placed in a map by one key, as the brushes that somebody would have drawn for it. One reading thread.
#pragma once

#include <optional>

#include "worlds/readers/map_keys.h"
#include "worlds/scene/prefab.h"

namespace handrail {

// The piece that the key `prefab` names; nothing, and a warning, where there is none of that name or the entity has a
// shape or no place.
const Prefab* prefab_of(const MapEntity& entity, Diagnostics& diagnostics);
// The entity with its brushes: the middle of its floor at `origin`, its front to `heading_rad`, clockwise from north.
MapEntity with_prefab(const MapEntity& entity, const Prefab& prefab, const Vec3& origin_units, double heading_rad,
                      double metres_per_unit);

}  // namespace handrail
