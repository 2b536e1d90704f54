// Finds where the rooms of a storey meet, on a grid of squares, without anything in between. These are the openings
// that a drawing shows. Plain values and pure functions; any thread. The time grows with the number of squares.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace handrail::plan {

struct RoomGrid {
    int wide = 0, high = 0;
    std::vector<std::uint8_t> blocked;  // row by row; 1: stops a finger or a body
    std::vector<std::uint32_t> room;    // kNothing if no room is known for the square

    RoomGrid() = default;
    RoomGrid(int wide, int high);
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(wide) + static_cast<std::size_t>(x);
    }
    bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < wide && y < high; }
};

// A connected piece of a border: adjacent squares that belong to two rooms.
struct RoomBorder {
    std::array<std::uint32_t, 2> rooms{};  // the lower index first
    std::vector<std::size_t> squares;      // squares on both sides of the border
};

// Gives every free square the room from which it is reached first, moving over the sides of squares.
void spread_rooms(RoomGrid& grid);
// All borders between the rooms of a grid after spread_rooms.
std::vector<RoomBorder> borders_of(const RoomGrid& grid);

}  // namespace handrail::plan
