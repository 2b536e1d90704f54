#include "worlds/plan/storey_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "worlds/navigation/walk_space.h"

namespace handrail::plan {
namespace {

// Size of a square, and greatest number of squares along the longer side.
constexpr double kSquare_m = 0.05, kMostSquares = 2000.0;
constexpr double kCrack_m = 0.1;  // a crack between walls that is narrower than this leads nowhere
// Distance from the middle of a floor cell within which a place is near the floor. It is slightly more than a walker's
// radius.
constexpr double kNextToFloor_m = 0.45;
constexpr double kDoorwayDeep_m = 2.0;  // greatest distance between the floors on both sides of a doorway
constexpr double kLeastVoid_m2 = 1.0;   // a smaller area between floors, without a floor of its own, is not a void
// Greatest distance from the floor to a wall of the storey; furniture or a machine may be between them.
constexpr double kWallNear_m = 2.0;

// Calls `each(x, y)` for the squares of a grid whose middles are within `radius` of a place. Lengths are in squares.
template <class Each>
void for_disc(int wide, int high, const Vec2& at, double radius, Each each) {
    const auto first = [](double from) { return std::max(0, static_cast<int>(std::floor(from))); };
    for (int y = first(at.y - radius); y < high && y <= at.y + radius; ++y)
        for (int x = first(at.x - radius); x < wide && x <= at.x + radius; ++x)
            if (glm::distance(Vec2(x + 0.5, y + 0.5), at) <= radius) each(x, y);
}

// Returns the middle of the floor cell of a room that is nearest to a place; nothing if the nearest is farther away
// than `most_m`.
std::optional<Vec2> nearest_floor_m(const Storey& storey, std::uint32_t room, const Vec2& place_m, double most_m) {
    const StoreyFloor& floor = storey.floor;
    std::optional<Vec2> nearest;
    for_disc(floor.wide, floor.high, (place_m - storey.min_m) / floor.cell_m, most_m / floor.cell_m, [&](int x, int y) {
        const std::size_t cell =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(floor.wide) + static_cast<std::size_t>(x);
        const Vec2 at_m = storey.min_m + (Vec2(x, y) + Vec2(0.5)) * floor.cell_m;
        if (floor.room[cell] == room && (!nearest || glm::distance(at_m, place_m) < glm::distance(*nearest, place_m)))
            nearest = at_m;
    });
    return nearest;
}

// Returns the free squares that belong to no room and lie between the floors of rooms, such as a void that walkways
// enclose. Squares that touch form a piece. A piece counts if each of its squares has at least `least` others in the
// piece, and if at least two rooms have floors next to it. `beside` contains the rooms whose floors are near.
std::vector<std::size_t> squares_between_rooms(const RoomGrid& grid, const RoomGrid& beside, double least) {
    std::vector<std::size_t> found;
    std::vector<std::uint8_t> seen(grid.room.size(), 0);
    const auto wide = static_cast<std::size_t>(grid.wide);
    for (std::size_t first = 0; first < seen.size(); ++first) {
        const auto is_free = [&](std::size_t square) {
            return !seen[square] && !grid.blocked[square] && grid.room[square] == navigation::kNothing;
        };
        if (!is_free(first)) continue;
        std::vector<std::size_t> piece{first};
        std::set<std::uint32_t> rooms;
        seen[first] = 1;
        // The squares at the rim have a room, so a square in the piece has four neighbours.
        for (std::size_t i = 0; i < piece.size(); ++i)
            for (const std::size_t next : {piece[i] - 1, piece[i] + 1, piece[i] - wide, piece[i] + wide}) {
                if (beside.room[next] != navigation::kNothing) rooms.insert(beside.room[next]);
                if (!is_free(next)) continue;
                seen[next] = 1;
                piece.push_back(next);
            }
        if (rooms.size() > 1 && static_cast<double>(piece.size()) >= least)
            found.insert(found.end(), piece.begin(), piece.end());
    }
    return found;
}

}  // namespace

StoreyGrid StoreyGrid::of(const Storey& storey) {
    const Vec2 size = storey.max_m - storey.min_m;
    return {storey, std::max(kSquare_m, std::max(size.x, size.y) / kMostSquares)};
}

RoomGrid StoreyGrid::walls() const {
    const Vec2 size = storey_->max_m - storey_->min_m;
    RoomGrid grid(static_cast<int>(std::ceil(size.x / square_m_)), static_cast<int>(std::ceil(size.y / square_m_)));
    const auto outside = static_cast<std::uint32_t>(storey_->rooms.size());
    for (int y = 0; y < grid.high; ++y)
        for (int x = 0; x < grid.wide; ++x) {
            const bool rim = x == 0 || y == 0 || x == grid.wide - 1 || y == grid.high - 1;
            std::uint32_t& room = grid.room[grid.at(x, y)] = floor_at(*storey_, middle(x, y));
            if (rim && room == navigation::kNothing) room = outside;
        }
    for (const PlanOutline& wall : storey_->walls_m) block(grid, wall);
    for (const auto& sheet : storey_->sheets_m) block_line(grid, sheet[0], sheet[1]);
    return grid;
}

void StoreyGrid::block_line(RoomGrid& grid, const Vec2& from, const Vec2& to) const {
    const int steps = std::max(1, static_cast<int>(std::ceil(2.0 * glm::distance(from, to) / square_m_)));
    for (int i = 0; i <= steps; ++i) {
        const Vec2 at = (from + (to - from) * (static_cast<double>(i) / steps) - storey_->min_m) / square_m_;
        const int x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::floor(at.y));
        if (grid.holds(x, y)) grid.blocked[grid.at(x, y)] = 1;
    }
}

void StoreyGrid::block(RoomGrid& grid, const PlanOutline& outline) const {
    Vec2 low(std::numeric_limits<double>::infinity()), high(-low);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        block_line(grid, outline[i], outline[(i + 1) % outline.size()]);
        low = glm::min(low, outline[i]);
        high = glm::max(high, outline[i]);
    }
    const auto square = [&](double m) { return static_cast<int>(std::floor(m / square_m_)); };
    for (int y = std::max(0, square(low.y - storey_->min_m.y)); y <= square(high.y - storey_->min_m.y); ++y)
        for (int x = std::max(0, square(low.x - storey_->min_m.x)); x <= square(high.x - storey_->min_m.x); ++x)
            if (grid.holds(x, y) && within(outline, middle(x, y))) grid.blocked[grid.at(x, y)] = 1;
}

void drop_far_walls(Storey& storey) {
    const StoreyFloor& floor = storey.floor;
    const auto cell = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(floor.wide) + static_cast<std::size_t>(x);
    };
    const auto is_floor = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < floor.wide && y < floor.high && floor.room[cell(x, y)] != navigation::kNothing;
    };
    std::vector<std::uint8_t> near_floor(floor.room.size(), 0);
    const auto lay = [&](const Vec2& at_m) {
        for_disc(floor.wide, floor.high, (at_m - storey.min_m) / floor.cell_m, kWallNear_m / floor.cell_m,
                 [&](int x, int y) { near_floor[cell(x, y)] = 1; });
    };
    for (int y = 0; y < floor.high; ++y)
        for (int x = 0; x < floor.wide; ++x) {
            if (!is_floor(x, y)) continue;
            near_floor[cell(x, y)] = 1;
            if (!is_floor(x - 1, y) || !is_floor(x + 1, y) || !is_floor(x, y - 1) || !is_floor(x, y + 1))
                lay(storey.min_m + (Vec2(x, y) + Vec2(0.5)) * floor.cell_m);
        }
    for (const StoreyStairs& stairs : storey.stairs_of_others)
        for (const std::vector<Vec2>& loop : stairs.loops_m)
            for (const Vec2& at : loop) lay(at);
    const auto is_near = [&](const Vec2& from, const Vec2& to) {
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / floor.cell_m)));
        for (int i = 0; i <= steps; ++i) {
            const Vec2 at = (from + (to - from) * (static_cast<double>(i) / steps) - storey.min_m) / floor.cell_m;
            const int x = std::clamp(static_cast<int>(std::floor(at.x)), 0, floor.wide - 1);
            const int y = std::clamp(static_cast<int>(std::floor(at.y)), 0, floor.high - 1);
            if (near_floor[cell(x, y)]) return true;
        }
        return false;
    };
    const auto is_far = [&](const PlanOutline& wall) {
        for (std::size_t i = 0; i < wall.size(); ++i)
            if (is_near(wall[i], wall[(i + 1) % wall.size()])) return false;
        return true;
    };
    if (floor.room.empty()) return;
    std::erase_if(storey.walls_m, is_far);
    std::erase_if(storey.windows_m, is_far);
    std::erase_if(storey.sheets_m, [&](const auto& sheet) { return !is_near(sheet[0], sheet[1]); });
}

void find_beyond(Storey& storey) {
    StoreyFloor& floor = storey.floor;
    floor.beyond.assign(floor.room.size(), 0);
    if (floor.room.empty()) return;
    const auto cell = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(floor.wide) + static_cast<std::size_t>(x);
    };
    std::vector<std::uint8_t> near_floor(floor.room.size(), 0);
    const auto lay = [&](const Vec2& at_m, double radius_m) {
        for_disc(floor.wide, floor.high, (at_m - storey.min_m) / floor.cell_m, radius_m / floor.cell_m,
                 [&](int x, int y) { near_floor[cell(x, y)] = 1; });
    };
    const auto lay_middle = [&](int x, int y) {
        lay(storey.min_m + (Vec2(x, y) + Vec2(0.5)) * floor.cell_m, kNextToFloor_m);
    };
    for (int y = 0; y < floor.high; ++y)
        for (int x = 0; x < floor.wide; ++x) {
            const bool flight = std::any_of(
                storey.stairs_of_others.begin(), storey.stairs_of_others.end(), [&](const StoreyStairs& stairs) {
                    return std::any_of(stairs.loops_m.begin(), stairs.loops_m.end(), [&](const auto& loop) {
                        return within_loop(loop, storey.min_m + (Vec2(x, y) + Vec2(0.5)) * floor.cell_m);
                    });
                });
            if (floor.room[cell(x, y)] != navigation::kNothing || flight) lay_middle(x, y);
        }
    // A doorway may be a gap between two floors. Along the rest of a wide portal, the floors adjoin.
    for (const StoreyPortal& portal : storey.portals) {
        const double reach_m = 0.5 * portal.width_m + kDoorwayDeep_m;
        const auto a = nearest_floor_m(storey, portal.rooms[0], portal.place_m, reach_m);
        const auto b = a ? nearest_floor_m(storey, portal.rooms[1], *a, kDoorwayDeep_m) : std::nullopt;
        if (!b) continue;
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(*a, *b) / floor.cell_m)));
        for (int i = 0; i <= steps; ++i) lay(*a + (*b - *a) * (static_cast<double>(i) / steps), kNextToFloor_m);
    }

    // Finds the squares that can be reached from the rim without crossing a wall or a floor, and the voids between
    // rooms.
    const StoreyGrid squares = StoreyGrid::of(storey);
    RoomGrid grid = squares.walls();
    const std::vector<std::uint8_t> walls = grid.blocked;
    const double crack = kCrack_m / squares.square_m();
    for (int y = 0; y < grid.high; ++y)
        for (int x = 0; x < grid.wide; ++x)
            if (walls[grid.at(x, y)])
                for_disc(grid.wide, grid.high, Vec2(x + 0.5, y + 0.5), crack,
                         [&](int i, int j) { grid.blocked[grid.at(i, j)] = 1; });
    for (const StoreyThing& thing : storey.things) {
        const std::array<Vec2, 4> corners = thing.box.corners_m();
        squares.block(grid, PlanOutline(corners.begin(), corners.end()));
    }
    const auto cell_of = [&](std::size_t square) {
        const Vec2 at = (squares.middle(grid, square) - storey.min_m) / floor.cell_m;
        return cell(std::min(static_cast<int>(at.x), floor.wide - 1), std::min(static_cast<int>(at.y), floor.high - 1));
    };
    RoomGrid beside = grid;  // the floors, and the squares near them on the same side of a wall
    for (std::size_t i = 0; i < grid.room.size(); ++i) {
        const int x = static_cast<int>(i % static_cast<std::size_t>(grid.wide));
        const int y = static_cast<int>(i / static_cast<std::size_t>(grid.wide));
        const bool rim = x == 0 || y == 0 || x == grid.wide - 1 || y == grid.high - 1;
        (near_floor[cell_of(i)] ? grid : beside).blocked[i] = 1;
        if (beside.room[i] == storey.rooms.size()) beside.room[i] = navigation::kNothing;
        grid.room[i] = rim ? 0 : navigation::kNothing;
    }
    spread_rooms(grid);
    spread_rooms(beside);
    for (const std::size_t square :
         squares_between_rooms(grid, beside, kLeastVoid_m2 / std::pow(squares.square_m(), 2)))
        grid.room[square] = 0;
    for (std::size_t i = 0; i < grid.room.size(); ++i)
        if (grid.room[i] != navigation::kNothing) floor.beyond[cell_of(i)] = 1;
    // The cell of a wall's square is not beyond the floors, because a room may be on the other side of a thin wall.
    for (std::size_t i = 0; i < walls.size(); ++i)
        if (walls[i]) floor.beyond[cell_of(i)] = 0;
}

}  // namespace handrail::plan
