// Checks that a drawing of walls agrees with the route graph: two rooms are open to each other where the graph has a
// portal between them, and nowhere else. Flights of stairs are an exception: their sides stay open, because their lines
// show them. Routes to another storey also stay open. Pure functions; any thread may call them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "worlds/exports/wall_ink.h"
#include "worlds/plan/room_borders.h"
#include "worlds/plan/storey.h"

namespace handrail::exports {

// Returns, for every pixel, the room whose floor is nearest for a finger that moves without crossing a wall. The number
// of rooms stands for the outside.
plan::RoomGrid rooms_on(const Ink& walls, const plan::Storey& storey, const OnPaper& on_paper);

struct WrongOpening {
    std::array<std::uint32_t, 2> rooms{};  // indices in Storey::rooms
    Vec2 at_mm{0.0};
    std::vector<Vec2> squares_mm;  // for a wrong opening without a portal: the centres of its pixels
};

struct OpeningCheck {
    std::vector<WrongOpening> lacking;  // doors and openings of the graph that are closed in the drawing
    // Pairs of rooms that are open to each other in the drawing, but not in the graph.
    std::vector<WrongOpening> leaking;
};
// Checks a drawing that contains only walls. Doors and openings outside the drawing are not checked.
OpeningCheck check_openings(const Ink& walls, const plan::Storey& storey, const OnPaper& on_paper);
// Checks the drawing for which rooms_on returned `rooms`.
OpeningCheck check_openings(const plan::RoomGrid& rooms, const plan::Storey& storey, const OnPaper& on_paper);

// Returns the rooms whose floor meets the outside without a wall over at least `least_mm`, as indices in Storey::rooms.
// `shown` returns whether a place is on the sheet; other places are ignored. `rooms`: see rooms_on.
std::vector<std::uint32_t> rooms_with_open_edges(const plan::RoomGrid& rooms, const plan::Storey& storey,
                                                 double least_mm, const std::function<bool(const Vec2&)>& shown);

// The result of mend_openings. That function opens doors and openings that are closed in the drawing, with the door
// width of `look`; they were closed when the lines on both sides were joined. It also closes wrong openings, which are
// places that are too narrow or too low for a walker. If black is then too near to a mended place, the function joins
// them.
struct MendedOpenings {
    std::size_t opened = 0;
    // Pairs of indices in Storey::rooms between which a wrong opening was closed.
    std::vector<std::array<std::uint32_t, 2>> closed;
};
MendedOpenings mend_openings(Ink& walls, const plan::Storey& storey, const OnPaper& on_paper, const WallLook& look);

}  // namespace handrail::exports
