// Assigns the places of a walkable space to the rooms that a file states. Pure functions; any thread.
#pragma once

#include <vector>

#include "worlds/navigation/walk_space.h"
#include "worlds/scene/stated_building.h"

namespace handrail::navigation {

// For each span, the index in StatedBuilding::rooms of the room that contains it, by outline and height; kNothing if
// none does. Of two overlapping rooms the first counts. The time is proportional to the cells under the rooms'
// outlines.
template <class Span>
std::vector<std::uint32_t> stated_rooms_of(const StatedBuilding& stated, const SpanGrid<Span>& grid);

// The first room that contains the place; null if none does, or the file states no rooms.
const StatedRoom* stated_room_at(const Scene& scene, const Vec3& at_m);

}  // namespace handrail::navigation
