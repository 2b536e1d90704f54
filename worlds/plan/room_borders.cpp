#include "worlds/plan/room_borders.h"

#include <algorithm>
#include <map>

#include "worlds/navigation/walk_space.h"

namespace handrail::plan {
namespace {

// Calls `each` for the four squares next to a square.
template <class Each>
void for_sides(const RoomGrid& grid, std::size_t square, Each each) {
    const auto wide = static_cast<std::size_t>(grid.wide);
    const std::size_t x = square % wide;
    if (x + 1 < wide) each(square + 1);
    if (square + wide < grid.room.size()) each(square + wide);
    if (x > 0) each(square - 1);
    if (square >= wide) each(square - wide);
}

// True if `answers` is true for at least one neighbour of the square. Most squares have no such neighbour, and a page
// has millions of squares, so this must be fast.
template <class Answers>
bool any_side(const RoomGrid& grid, std::size_t square, Answers answers) {
    const auto wide = static_cast<std::size_t>(grid.wide);
    const std::size_t x = square % wide;
    return (x + 1 < wide && answers(square + 1)) || (x > 0 && answers(square - 1)) ||
           (square + wide < grid.room.size() && answers(square + wide)) || (square >= wide && answers(square - wide));
}

// Groups the squares of one border into pieces. Squares that touch, even at a corner only, are in one piece.
void split_into_pieces(const RoomGrid& grid, const std::array<std::uint32_t, 2>& rooms,
                       const std::vector<std::size_t>& squares, std::vector<RoomBorder>& borders) {
    std::map<std::size_t, bool> taken;
    for (const std::size_t square : squares) taken[square] = false;
    for (const std::size_t first : squares) {
        if (std::exchange(taken[first], true)) continue;
        RoomBorder border{rooms, {first}};
        for (std::size_t i = 0; i < border.squares.size(); ++i) {
            const int x = static_cast<int>(border.squares[i] % static_cast<std::size_t>(grid.wide));
            const int y = static_cast<int>(border.squares[i] / static_cast<std::size_t>(grid.wide));
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    if (!grid.holds(x + dx, y + dy)) continue;
                    const auto next = taken.find(grid.at(x + dx, y + dy));
                    if (next == taken.end() || std::exchange(next->second, true)) continue;
                    border.squares.push_back(next->first);
                }
        }
        borders.push_back(std::move(border));
    }
}

}  // namespace

RoomGrid::RoomGrid(int wide_squares, int high_squares)
    : wide(wide_squares),
      high(high_squares),
      blocked(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), 0),
      room(blocked.size(), navigation::kNothing) {}

void spread_rooms(RoomGrid& grid) {
    std::vector<std::size_t> reached;
    for (std::size_t i = 0; i < grid.room.size(); ++i)
        if (grid.blocked[i]) grid.room[i] = navigation::kNothing;
    // The flood fill goes on to a square only if that square is free and next to a square with a room.
    const auto is_free = [&](std::size_t square) {
        return grid.room[square] == navigation::kNothing && !grid.blocked[square];
    };
    for (std::size_t i = 0; i < grid.room.size(); ++i)
        if (grid.room[i] != navigation::kNothing && any_side(grid, i, is_free)) reached.push_back(i);
    for (std::size_t i = 0; i < reached.size(); ++i)
        for_sides(grid, reached[i], [&](std::size_t next) {
            if (grid.blocked[next] || grid.room[next] != navigation::kNothing) return;
            grid.room[next] = grid.room[reached[i]];
            reached.push_back(next);
        });
}

std::vector<RoomBorder> borders_of(const RoomGrid& grid) {
    std::map<std::array<std::uint32_t, 2>, std::vector<std::size_t>> squares;
    for (std::size_t i = 0; i < grid.room.size(); ++i) {
        const std::uint32_t mine = grid.room[i];
        if (mine == navigation::kNothing || !any_side(grid, i, [&](std::size_t next) {
                return grid.room[next] != mine && grid.room[next] != navigation::kNothing;
            }))
            continue;
        for_sides(grid, i, [&](std::size_t next) {
            if (grid.room[next] == navigation::kNothing || grid.room[next] == grid.room[i]) return;
            std::vector<std::size_t>& of =
                squares[std::array{std::min(grid.room[i], grid.room[next]), std::max(grid.room[i], grid.room[next])}];
            if (of.empty() || of.back() != i) of.push_back(i);
        });
    }
    std::vector<RoomBorder> borders;
    for (const auto& [rooms, of] : squares) split_into_pieces(grid, rooms, of, borders);
    return borders;
}

}  // namespace handrail::plan
