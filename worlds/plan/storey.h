// A plan of one storey of a building, for drawing or printing: walls with windows closed and doors open, rooms, things,
// passages and the base. Windows are closed by their sills and panes, because every gap feels like a door under a
// finger. Pure functions over plain values; any thread. World metres, x east, y north.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "worlds/navigation/rooms.h"
#include "worlds/plan/plan_shapes.h"

namespace handrail::plan {

struct StoreyRoom {
    std::uint32_t room = 0;  // index in the RoomGraph
    std::string name;        // in the spoken language
    navigation::RoomKind kind = navigation::RoomKind::Room;
    std::vector<std::vector<Vec2>> loops_m;  // the outline, a body's radius inside the walls: see RoomOutline
    double area_m2 = 0.0;
    Vec2 min_m{0.0}, max_m{0.0};  // bounds of the loops
    // Centre of area of its largest piece. If that is in another room, the nearest place on its own floor.
    Vec2 middle_m{0.0};
    bool outside = false;    // on the ground that a reader laid around the building
    bool shut = false;       // nothing leads into the room
    bool elsewhere = false;  // the other plan of the storey shows it; see Storey::upper
};

// A thing on the floor that is no part of the building.
struct StoreyThing {
    FeatureId feature = kNoFeature;
    std::string name;  // in the spoken language
    PlanBox box;
    bool landmark = false;
};

// A door or an opening in a wall, from jamb to jamb.
struct StoreyGap {
    navigation::PassageKind kind = navigation::PassageKind::Door;
    std::string name;  // empty for an opening
    Vec2 place_m{0.0};
    Vec2 along{1.0, 0.0};  // direction from jamb to jamb
    double width_m = 0.0;
    double deep_m = 0.0;  // on either side of its place this much is free too; 0: as deep as the wall is
    std::array<std::uint32_t, 2> rooms{navigation::kNothing,
                                       navigation::kNothing};  // places in Storey::rooms; kNothing: of another storey
};

// A portal between two rooms of the storey, from RoomGraph::portals.
struct StoreyPortal {
    navigation::PassageKind kind = navigation::PassageKind::Door;
    std::array<std::uint32_t, 2> rooms{};  // indices into Storey::rooms
    Vec2 place_m{0.0};
    double width_m = 0.0;
};

struct StoreyStairs {
    std::uint32_t room = 0;  // the room in which they begin or end; an index into Storey::rooms
    std::vector<std::vector<Vec2>> loops_m;
};

// A connection of a room to another storey without stairs that the plan shows: a lift, a ramp, or steps that belong to
// the rooms at their ends. Drops do not count.
struct StoreyExit {
    navigation::PassageKind kind = navigation::PassageKind::Opening;
    std::uint32_t room = 0;  // index into Storey::rooms
    std::string to;          // the other room, in the spoken language
    Vec2 place_m{0.0};
    double width_m = 0.0;
};

struct StoreyBase {
    Vec2 place_m{0.0};
    double heading_rad = 0.0;
};

// Which room's floor is where, in square cells.
struct StoreyFloor {
    double cell_m = 0.2;
    int wide = 0, high = 0;           // from Storey::min_m on
    std::vector<std::uint32_t> room;  // row by row; the place in Storey::rooms, kNothing where no body can stand
    // Of the same squares: 1 beyond all floors, where no wall lies between there and the rim of the plan. Empty: it is
    // not known.
    std::vector<std::uint8_t> beyond;
};

struct Storey {
    int number = 1, count = 1;  // number: from 1, the lowest storey
    // A plan shows one floor at each place. If a storey has two, as with a walkway above a platform, the storey itself
    // shows the lower floor. A second plan shows the rooms of the upper one and their connections.
    bool upper = false;
    // Indices into `rooms`: parts of these rooms are above others and on the second plan.
    std::vector<std::uint32_t> hidden;
    std::string world;
    std::string name;             // the file's name for the storey; may be empty
    double floor_m = 0.0;         // mean height of its rooms
    Vec2 min_m{0.0}, max_m{0.0};  // the area shown; the ground around a building does not widen it
    std::vector<StoreyRoom> rooms;
    StoreyFloor floor;
    // Walls, cut 1 m above the floor. They include sills, parts that close windows, and whatever else stops a body
    // between rooms.
    std::vector<PlanOutline> walls_m;
    std::vector<std::array<Vec2, 2>> sheets_m;  // walls of meshes, without thickness
    std::vector<PlanOutline> windows_m;         // the parts of walls_m that close windows
    std::vector<StoreyThing> things;            // landmarks first, then by size
    std::vector<StoreyGap> gaps;
    std::vector<StoreyStairs> stairs_of_others;  // flights that belong to another storey but begin or end here
    std::vector<StoreyPortal> portals;
    std::vector<StoreyExit> exits;
    std::optional<StoreyBase> base;
    int moving = 0;  // number of free bodies, which are not in `things` because they may be elsewhere tomorrow
};

// The number of storeys; 0 if there are no rooms.
int storey_count(const navigation::RoomGraph& graph);
// The storey of the base, else of the first start; 1 if that is in no room.
int storey_of_start(const Scene& scene, const navigation::RoomGraph& graph, const navigation::WalkSpace& space);
// Fails with one sentence if there is no such storey, or no room on it. The time grows with the numbers of solids and
// spans.
Result<Storey> storey_of(const Scene& scene, const navigation::RoomGraph& graph, const navigation::WalkSpace& space,
                         int number);

// The second plan of a storey that has floors above each other. `storey` is the result of storey_of(); empty if it has
// no second plan.
std::optional<Storey> upper_part_of(const Scene& scene, const navigation::RoomGraph& graph,
                                    const navigation::WalkSpace& space, const Storey& storey);

// The index in Storey::rooms of the room whose floor is at this place; kNothing under furniture, in walls and outside.
std::uint32_t floor_at(const Storey& storey, const Vec2& at);
// Fills Storey::floor from the rooms' loops, for storeys that were not made from a world.
void lay_floor(Storey& storey);

}  // namespace handrail::plan
