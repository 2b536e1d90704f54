// Assigns the spans of a walkable space to the rooms that a file states. Pure functions; any thread may call them.
#pragma once

#include <vector>

#include "worlds/navigation/walk_space.h"
#include "worlds/scene/stated_building.h"

namespace handrail::navigation {

// Returns, for each span, the index in StatedBuilding::rooms of the room that contains it by outline and height;
// kNothing if no room does. If two rooms overlap, returns the first one. The time is proportional to the number of
// cells under the rooms' outlines.
template <class Span>
std::vector<std::uint32_t> stated_rooms_of(const StatedBuilding& stated, const SpanGrid<Span>& grid);

// Returns the first room that contains the place; null if none does, or if the file states no rooms.
const StatedRoom* stated_room_at(const Scene& scene, const Vec3& at_m);

}  // namespace handrail::navigation
