// Finds where the rooms of a storey adjoin without anything in between, on a grid of squares. These are the openings
// that a drawing shows. Plain values and pure functions; any thread may use them. The time grows with the number of
// squares.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace handrail::plan {

struct RoomGrid {
    int wide = 0, high = 0;
    std::vector<std::uint8_t> blocked;  // stored row by row; 1: the square stops a finger or a body
    std::vector<std::uint32_t> room;    // the room of each square; kNothing if none is known

    RoomGrid() = default;
    RoomGrid(int wide, int high);
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(wide) + static_cast<std::size_t>(x);
    }
    bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < wide && y < high; }
};

// A connected piece of the border between two rooms, as adjacent squares of these rooms.
struct RoomBorder {
    std::array<std::uint32_t, 2> rooms{};  // the room with the lower index first
    std::vector<std::size_t> squares;      // the squares next to the border, on both of its sides
};

// Gives every free square the room from which a flood fill reaches it first. The fill moves across the sides of
// squares, not across corners.
void spread_rooms(RoomGrid& grid);
// Returns all borders between the rooms of a grid to which spread_rooms was applied.
std::vector<RoomBorder> borders_of(const RoomGrid& grid);

}  // namespace handrail::plan
