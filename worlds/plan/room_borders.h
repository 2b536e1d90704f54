// Where on a grid of squares the rooms of a storey meet with nothing in between: the openings that a drawing of it has.
// Plain values and pure functions; any thread. Time goes with the squares.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace handrail {

struct RoomGrid {
    int wide = 0, high = 0;
    std::vector<std::uint8_t> blocked;  // row by row; what stops a finger or a body
    std::vector<std::uint32_t> room;    // kNothing where no room is known to be

    RoomGrid() = default;
    RoomGrid(int wide, int high);
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(wide) + static_cast<std::size_t>(x);
    }
    bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < wide && y < high; }
};

// Squares next to each other that belong to two rooms, as one piece.
struct RoomBorder {
    std::array<std::uint32_t, 2> rooms{};  // the lower first
    std::vector<std::size_t> squares;      // on both sides
};

// Gives every free square the room from which it is reached first, step by step over the sides of squares.
void spread_rooms(RoomGrid& grid);
// All borders between rooms of a grid that was spread.
std::vector<RoomBorder> borders_of(const RoomGrid& grid);

}  // namespace handrail
