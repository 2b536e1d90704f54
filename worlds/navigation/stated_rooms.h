// Which of the rooms that a file states the places of a walkable space lie in. Pure functions; any thread.
#pragma once

#include <vector>

#include "worlds/navigation/walk_space.h"
#include "worlds/scene/stated_building.h"

namespace handrail {

// Of each span the place in StatedBuilding::rooms, by its outline and height; kNothing: in none. Of two rooms that
// overlap the first. Goes with the cells under the rooms' outlines.
template <class Span>
std::vector<std::uint32_t> stated_rooms_of(const StatedBuilding& stated, const SpanGrid<Span>& grid);

// The first that holds the place; null: none does, or the file states no rooms.
const StatedRoom* stated_room_at(const Scene& scene, const Vec3& at_m);

}  // namespace handrail
