// What a drawing of walls promises: between two rooms it is open where the route graph has a way through, and nowhere
// else. The sides of a flight of stairs are left open: its lines show them. Pure functions; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "worlds/exports/wall_ink.h"
#include "worlds/plan/room_borders.h"
#include "worlds/plan/storey.h"

namespace handrail {

// The room of every pixel that a finger reaches from its floor first; as many as there are rooms: the outside.
RoomGrid rooms_on(const Ink& walls, const Storey& storey, const OnPaper& on_paper);

struct WrongOpening {
    std::array<std::uint32_t, 2> rooms{};  // places in Storey::rooms
    Vec2 at_mm{0.0};
    std::vector<Vec2> squares_mm;  // of an opening without a portal: the middles of its pixels
};

struct OpeningCheck {
    std::vector<WrongOpening> lacking;  // a door or an opening of the graph that the drawing has not
    std::vector<WrongOpening> leaking;  // rooms that the drawing joins and the graph does not
};
// `walls` holds walls alone. Doors and openings whose place is off the drawing are not looked for.
OpeningCheck check_openings(const Ink& walls, const Storey& storey, const OnPaper& on_paper);
// The same of rooms_on for that drawing.
OpeningCheck check_openings(const RoomGrid& rooms, const Storey& storey, const OnPaper& on_paper);

// Opens what lacks, as wide as `look` has doors, and closes what leaks: places too narrow or too low for a body, and
// what joining lines has closed. What is too near to a mended place is joined. How many of each there were.
struct MendedOpenings {
    std::size_t opened = 0, closed = 0;
};
MendedOpenings mend_openings(Ink& walls, const Storey& storey, const OnPaper& on_paper, const WallLook& look);

}  // namespace handrail
