#include "worlds/exports/openings.h"

#include <algorithm>
#include <cmath>

#include "worlds/navigation/walk_space.h"
#include "worlds/plan/room_borders.h"

namespace handrail::exports {
namespace {

// A finger passes through a portal within a certain distance of its middle. That distance is half the portal's width,
// or half of a door's width on paper, plus kNextToPortal_mm and kNextToPortal_m.
constexpr double kHalfDoor_mm = 3.3, kNextToPortal_mm = 2.0, kNextToPortal_m = 0.5;
constexpr double kLeastLeak_mm = 0.3;  // a narrower gap between rooms is only an effect of the pixels

Vec2 middle_of(const plan::RoomGrid& grid, std::size_t square) {
    return Vec2(static_cast<double>(square % static_cast<std::size_t>(grid.wide)) + 0.5,
                static_cast<double>(square / static_cast<std::size_t>(grid.wide)) + 0.5) *
           kInkPixel_mm;
}

bool joins(const plan::StoreyPortal& portal, const plan::RoomBorder& border) {
    return std::min(portal.rooms[0], portal.rooms[1]) == border.rooms[0] &&
           std::max(portal.rooms[0], portal.rooms[1]) == border.rooms[1];
}

bool is_in_flight(const plan::StoreyStairs& flight, const Vec2& at_m) {
    return std::any_of(flight.loops_m.begin(), flight.loops_m.end(),
                       [&](const std::vector<Vec2>& loop) { return plan::within_loop(loop, at_m); });
}

// Returns the rooms of the cells of a storey's floor. Where the well of a flight of another storey has no floor, the
// cells belong to the room in which the flight begins or ends.
std::vector<std::uint32_t> rooms_with_wells(const plan::Storey& storey) {
    const plan::StoreyFloor& floor = storey.floor;
    std::vector<std::uint32_t> rooms = floor.room;
    for (std::size_t cell = 0; cell < rooms.size(); ++cell) {
        if (rooms[cell] != navigation::kNothing) continue;
        const auto wide = static_cast<std::size_t>(floor.wide);
        const Vec2 at_m = storey.min_m + (Vec2(cell % wide, cell / wide) + Vec2(0.5)) * floor.cell_m;
        const auto flight = std::find_if(storey.stairs_of_others.begin(), storey.stairs_of_others.end(),
                                         [&](const plan::StoreyStairs& stairs) { return is_in_flight(stairs, at_m); });
        if (flight != storey.stairs_of_others.end()) rooms[cell] = flight->room;
    }
    return rooms;
}

class Checker {
public:
    Checker(const plan::RoomGrid& grid, const plan::Storey& storey, const OnPaper& on_paper)
        : storey_(storey), on_paper_(on_paper), grid_(grid), borders_(plan::borders_of(grid_)) {
        const auto outside = static_cast<std::uint32_t>(storey.rooms.size());
        std::erase_if(borders_, [&](const plan::RoomBorder& border) { return border.rooms[1] == outside; });
    }

    OpeningCheck check() const {
        OpeningCheck found;
        for (const plan::StoreyPortal& portal : storey_.portals) {
            const Vec2 at = on_paper_(portal.place_m);
            if (portal.kind != navigation::PassageKind::Door && portal.kind != navigation::PassageKind::Opening)
                continue;
            if (!grid_.holds(static_cast<int>(at.x / kInkPixel_mm), static_cast<int>(at.y / kInkPixel_mm))) continue;
            const bool open = std::any_of(borders_.begin(), borders_.end(), [&](const plan::RoomBorder& border) {
                return joins(portal, border) &&
                       std::any_of(border.squares.begin(), border.squares.end(), [&](std::size_t square) {
                           return glm::distance(middle(square), at) <= reach_mm(portal);
                       });
            });
            if (!open) found.lacking.push_back({portal.rooms, at, {}});
        }
        for (const plan::RoomBorder& border : borders_)
            if (WrongOpening leak = leak_of(border); !leak.squares_mm.empty()) found.leaking.push_back(std::move(leak));
        return found;
    }

private:
    Vec2 middle(std::size_t square) const { return middle_of(grid_, square); }

    double reach_mm(const plan::StoreyPortal& portal) const {
        return std::max(0.5 * portal.width_m * on_paper_.mm_per_m, kHalfDoor_mm) +
               kNextToPortal_m * on_paper_.mm_per_m + kNextToPortal_mm;
    }

    // Returns whether the room is a flight of stairs. Its lines show its sides, which have no walls. A line around it
    // would leave no space for those lines.
    bool is_flight(std::uint32_t room) const { return storey_.rooms[room].kind == navigation::RoomKind::Stairs; }

    // Returns whether the place is on or next to a flight of another storey, whose lines also show its sides.
    bool is_at_flight_of_other(const Vec2& at) const {
        const double reach_m = kNextToPortal_m + kNextToPortal_mm / on_paper_.mm_per_m;
        const Vec2 at_m = on_paper_.world(at);
        return std::any_of(storey_.stairs_of_others.begin(), storey_.stairs_of_others.end(),
                           [&](const plan::StoreyStairs& flight) {
                               if (is_in_flight(flight, at_m)) return true;
                               for (int eighth = 0; eighth < 8; ++eighth) {
                                   const double way_rad = eighth * kPi / 4.0;
                                   const Vec2 aside(std::cos(way_rad), std::sin(way_rad));
                                   if (is_in_flight(flight, at_m + aside * reach_m)) return true;
                               }
                               return false;
                           });
    }

    // Returns whether a route leads to another storey from this place, as at the low end of a ramp. A finger finds no
    // wall at such a place.
    bool leads_on(const plan::RoomBorder& border, const Vec2& at) const {
        return std::any_of(storey_.exits.begin(), storey_.exits.end(), [&](const plan::StoreyExit& exit) {
            const double reach = (0.5 * exit.width_m + kNextToPortal_m) * on_paper_.mm_per_m + kNextToPortal_mm;
            return (exit.room == border.rooms[0] || exit.room == border.rooms[1]) &&
                   glm::distance(on_paper_(exit.place_m), at) <= reach;
        });
    }

    // Returns whether a walker can step from one room into the other near this place.
    bool is_crossed(const std::vector<Vec2>& crossings_m, const Vec2& at) const {
        const double reach = kNextToPortal_m * on_paper_.mm_per_m + kNextToPortal_mm;
        return std::any_of(crossings_m.begin(), crossings_m.end(),
                           [&](const Vec2& crossing_m) { return glm::distance(on_paper_(crossing_m), at) <= reach; });
    }

    // Returns the part of a border between two rooms that has no wall although no portal, crossing or exit is there.
    WrongOpening leak_of(const plan::RoomBorder& border) const {
        WrongOpening leak{border.rooms, Vec2(0.0), {}};
        if (is_flight(border.rooms[0]) || is_flight(border.rooms[1])) return leak;
        std::vector<Vec2> crossings_m;
        for (const plan::StoreyCrossings& crossings : storey_.crossings)
            if (crossings.rooms == border.rooms) crossings_m = crossings.places_m;
        for (const std::size_t square : border.squares) {
            const Vec2 at = middle(square);
            if (!leads_on(border, at) && !is_at_flight_of_other(at) &&
                std::none_of(storey_.portals.begin(), storey_.portals.end(),
                             [&](const plan::StoreyPortal& portal) {
                                 return joins(portal, border) &&
                                        glm::distance(on_paper_(portal.place_m), at) <= reach_mm(portal);
                             }) &&
                !is_crossed(crossings_m, at))
                leak.squares_mm.push_back(at);
        }
        if (static_cast<double>(leak.squares_mm.size()) * kInkPixel_mm < 2.0 * kLeastLeak_mm) leak.squares_mm.clear();
        if (!leak.squares_mm.empty()) leak.at_mm = leak.squares_mm[leak.squares_mm.size() / 2];
        return leak;
    }

    const plan::Storey& storey_;
    const OnPaper& on_paper_;
    const plan::RoomGrid& grid_;
    std::vector<plan::RoomBorder> borders_;
};

}  // namespace

plan::RoomGrid rooms_on(const Ink& walls, const plan::Storey& storey, const OnPaper& on_paper) {
    plan::RoomGrid grid(walls.wide, walls.high);
    grid.blocked = walls.black;
    const auto outside = static_cast<std::uint32_t>(storey.rooms.size());
    std::vector<std::size_t> beyond;
    const plan::StoreyFloor& floor = storey.floor;
    const auto cell_of = [&](int pixel, int axis) {
        const double at_m = on_paper.world(Vec2((pixel + 0.5) * kInkPixel_mm))[axis];
        return static_cast<int>(std::floor((at_m - storey.min_m[axis]) / floor.cell_m));
    };
    const std::vector<std::uint32_t> rooms = rooms_with_wells(storey);
    std::vector<int> column;
    for (int x = 0; x < grid.wide; ++x) column.push_back(cell_of(x, 0));
    for (int y = 0; y < grid.high; ++y) {
        const int row = cell_of(y, 1);
        for (int x = 0; x < grid.wide; ++x) {
            const int cell = column[static_cast<std::size_t>(x)];
            const std::size_t here = grid.at(x, y);
            const bool rim = x == 0 || y == 0 || x == grid.wide - 1 || y == grid.high - 1;
            const bool on_storey = cell >= 0 && row >= 0 && cell < floor.wide && row < floor.high;
            // The pixels at the rim of the picture belong to the outside. An exception is one of several sheets: its
            // rim can be in the middle of a room.
            if (rim && (!on_storey || floor.beyond.empty())) grid.room[here] = outside;
            if (!on_storey) continue;
            const std::size_t square =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(floor.wide) + static_cast<std::size_t>(cell);
            if (grid.room[here] != outside) grid.room[here] = rooms[square];
            if (floor.beyond.empty() || !floor.beyond[square] || grid.blocked[here]) continue;
            grid.blocked[here] = 1;
            beyond.push_back(here);
        }
    }
    plan::spread_rooms(grid);
    if (beyond.empty()) return grid;
    for (const std::size_t pixel : beyond) grid.blocked[pixel] = 0, grid.room[pixel] = outside;
    plan::spread_rooms(grid);
    return grid;
}

OpeningCheck check_openings(const Ink& walls, const plan::Storey& storey, const OnPaper& on_paper) {
    return check_openings(rooms_on(walls, storey, on_paper), storey, on_paper);
}

OpeningCheck check_openings(const plan::RoomGrid& rooms, const plan::Storey& storey, const OnPaper& on_paper) {
    return Checker(rooms, storey, on_paper).check();
}

std::vector<std::uint32_t> rooms_with_open_edges(const plan::RoomGrid& rooms, const plan::Storey& storey,
                                                 double least_mm, const std::function<bool(const Vec2&)>& shown) {
    const auto outside = static_cast<std::uint32_t>(storey.rooms.size());
    std::vector<double> edge_mm(storey.rooms.size(), 0.0);
    for (const plan::RoomBorder& border : plan::borders_of(rooms)) {
        if (border.rooms[1] != outside) continue;
        for (const std::size_t square : border.squares)
            if (rooms.room[square] != outside && shown(middle_of(rooms, square)))
                edge_mm[border.rooms[0]] += kInkPixel_mm;
    }
    std::vector<std::uint32_t> open;
    for (std::uint32_t room = 0; room < edge_mm.size(); ++room)
        if (edge_mm[room] >= least_mm && !storey.rooms[room].outside &&
            storey.rooms[room].kind != navigation::RoomKind::Stairs)
            open.push_back(room);
    return open;
}

MendedOpenings mend_openings(Ink& walls, const plan::Storey& storey, const OnPaper& on_paper, const WallLook& look) {
    MendedOpenings mended;
    constexpr double kReach_mm = 25.0;
    const auto nearest = [&](std::uint32_t room, const Vec2& from_mm) {
        std::optional<Vec2> found;
        double least = kReach_mm;
        for (double y = -kReach_mm; y <= kReach_mm; y += 0.5)
            for (double x = -kReach_mm; x <= kReach_mm; x += 0.5) {
                const Vec2 at = from_mm + Vec2(x, y);
                if (glm::length(Vec2(x, y)) >= least || plan::floor_at(storey, on_paper.world(at)) != room) continue;
                least = glm::length(Vec2(x, y));
                found = at;
            }
        return found;
    };
    const OpeningCheck found = check_openings(walls, storey, on_paper);
    for (const WrongOpening& leak : found.leaking) {
        for (const Vec2& at : leak.squares_mm) fill_disc(walls, at, 0.5 * look.line_mm);
        mended.closed.push_back(leak.rooms);
    }
    for (const WrongOpening& closed : found.lacking) {
        const auto a = nearest(closed.rooms[0], closed.at_mm), b = nearest(closed.rooms[1], closed.at_mm);
        if (!a || !b || *a == *b) continue;
        const Vec2 along = (*b - *a) / glm::distance(*a, *b);
        const plan::PlanBox way{0.5 * (*a + *b), along, {0.5 * glm::distance(*a, *b), 0.5 * look.door_mm}};
        fill(walls, std::vector<std::vector<Vec2>>{corners_of(way)}, false);
        ++mended.opened;
    }
    if (mended.opened > 0 || !mended.closed.empty()) join_near(walls, look.clear_mm);
    return mended;
}

}  // namespace handrail::exports
