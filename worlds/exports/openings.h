// What a drawing of walls promises: between two rooms it is open where the route graph has a way through, and nowhere
// else. The sides of a flight of stairs are left open: its lines show them. Pure functions; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
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

// Rooms whose floor ends without a wall before the outside, along `least_mm` or more of what is shown. Places in
// Storey::rooms. `rooms`: see rooms_on.
std::vector<std::uint32_t> rooms_with_open_edges(const RoomGrid& rooms, const Storey& storey, double least_mm,
                                                 const std::function<bool(const Vec2&)>& shown);

// Opens what lacks, as wide as `look` has doors, and closes what leaks: places too narrow or too low for a body, and
// what joining lines has closed. What is too near to a mended place is joined.
struct MendedOpenings {
    std::size_t opened = 0;
    std::vector<std::array<std::uint32_t, 2>> closed;  // between these places in Storey::rooms
};
MendedOpenings mend_openings(Ink& walls, const Storey& storey, const OnPaper& on_paper, const WallLook& look);

}  // namespace handrail
