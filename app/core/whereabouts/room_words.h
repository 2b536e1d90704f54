// Rooms and the whole building told from afar, for who wants to know them before walking there. Functions of what the
// context and the graph of rooms hold; rooms must be found; app thread. Telling a room looks at every thing of the
// world once.
#pragma once

#include <string>

#include "app/core/whereabouts/rooms.h"

namespace handrail {

// Size, exits with their walls, and what stands along the walls, clockwise from the north wall's west end, as seen from
// above: "Library, 9 by 6 metres, 13 by 9 steps. 2 exits: ... North wall: shelf; table."
std::string room_words(const SessionContext& context, const Rooms& rooms, std::uint32_t room);

// Three sentences: storeys and rooms; size and shape of the outline of what has a roof; which rooms join what others,
// those with the most neighbours first.
std::string building_words(const SessionContext& context, const Rooms& rooms);

// The shape of an outline, as it is told.
enum class OutlineShape {
    Rectangle,
    CornerMissing,  // three quarters of a rectangle: an L
    Court,          // round a middle that is left free
    Irregular,
};
struct Outline {
    OutlineShape shape = OutlineShape::Rectangle;
    int corner = 0;  // of CornerMissing: 0 north-east, 1 south-east, 2 south-west, 3 north-west
};
// Of boxes seen from above, as far as squares of half a metre tell; at least one box, none of them empty.
Outline outline_of(const std::vector<Aabb>& boxes_m);

}  // namespace handrail
