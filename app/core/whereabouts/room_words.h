// Describes distant rooms and the whole building, for a person who wants to know them before walking there. Functions
// of the context and the room graph, for the app thread. Call them only after the rooms have been found. Describing a
// room examines every thing of the world once.
#pragma once

#include <string>

#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

// Returns the wing or other part of the building that the room is in, as the file names it; empty if it names none.
std::string part_of_building(const Scene& scene, const navigation::RoomGraph& graph, std::uint32_t room);

// Describes a room: its size, its storey, its wing, how it runs if it is a corridor, its exits with their walls, and
// what is along the walls. The walls are listed clockwise from the west end of the north wall, as seen from above:
// "Library, 9 by 6 metres, 13 by 9 steps. 2 exits: ... North wall: shelf; table."
std::string room_words(const SessionContext& context, const Rooms& rooms, std::uint32_t room);

// Returns the name and the size of a room: "Library, 9 by 6 metres, 13 by 9 steps."
std::string room_size_words(const SessionContext& context, const Rooms& rooms, std::uint32_t room);

// Describes the building in three or four sentences. They contain the storeys and rooms, the parts, the size and
// outline of everything under a roof, and which rooms connect to which. The rooms with the most neighbours come first.
std::string building_words(const SessionContext& context, const Rooms& rooms);

// The shape of an outline, as it is announced.
enum class OutlineShape {
    Rectangle,
    CornerMissing,  // three quarters of a rectangle, in the form of an L
    Court,          // a ring round a free middle
    Irregular,
};
struct Outline {
    OutlineShape shape = OutlineShape::Rectangle;
    // Which corner is missing if the shape is CornerMissing: 0 north-east, 1 south-east, 2 south-west, 3 north-west.
    int corner = 0;
};
// Returns the outline of the boxes as seen from above, sampled on a grid of squares. There must be at least one box,
// and no box may be empty.
Outline outline_of(const std::vector<Aabb>& boxes_m);

}  // namespace handrail::core
