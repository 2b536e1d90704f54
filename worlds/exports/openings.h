// What a drawing of walls promises: between two rooms it is open where the route graph has a way through, and nowhere
// else. The sides of a flight of stairs are left open: its lines show them. So are routes to another storey. Pure
// functions; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "worlds/exports/wall_ink.h"
#include "worlds/plan/room_borders.h"
#include "worlds/plan/storey.h"

namespace handrail::exports {

// For every pixel, the room from whose floor a finger reaches it first. The number of rooms stands for the outside.
plan::RoomGrid rooms_on(const Ink& walls, const plan::Storey& storey, const OnPaper& on_paper);

struct WrongOpening {
    std::array<std::uint32_t, 2> rooms{};  // indices in Storey::rooms
    Vec2 at_mm{0.0};
    std::vector<Vec2> squares_mm;  // of an opening without a portal: the centres of its pixels
};

struct OpeningCheck {
    std::vector<WrongOpening> lacking;  // doors and openings of the graph that the drawing does not show
    std::vector<WrongOpening> leaking;  // rooms that the drawing joins and the graph does not
};
// `walls` must contain only walls. Doors and openings outside the drawing are not checked.
OpeningCheck check_openings(const Ink& walls, const plan::Storey& storey, const OnPaper& on_paper);
// The same for the result of rooms_on for that drawing.
OpeningCheck check_openings(const plan::RoomGrid& rooms, const plan::Storey& storey, const OnPaper& on_paper);

// Finds the rooms whose floor meets the outside without a wall, for at least `least_mm` of the part shown. Returns
// indices in Storey::rooms. `rooms`: see rooms_on.
std::vector<std::uint32_t> rooms_with_open_edges(const plan::RoomGrid& rooms, const plan::Storey& storey,
                                                 double least_mm, const std::function<bool(const Vec2&)>& shown);

// Opens missing openings, with the door width of `look`, and closes leaks. Leaks are places too narrow or too low for a
// walker; missing openings were closed when lines were joined. Black that is too near to a mended place is joined.
struct MendedOpenings {
    std::size_t opened = 0;
    std::vector<std::array<std::uint32_t, 2>> closed;  // pairs of indices in Storey::rooms
};
MendedOpenings mend_openings(Ink& walls, const plan::Storey& storey, const OnPaper& on_paper, const WallLook& look);

}  // namespace handrail::exports
