// One storey of a building as a plan to be drawn or printed: walls with windows closed and doors open, rooms, things,
// where it goes through, the base. Windows are closed by their sills and panes, since under a finger every gap is a
// door. Pure functions over plain values; any thread. World metres, x east, y north.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "worlds/navigation/rooms.h"
#include "worlds/plan/plan_shapes.h"

namespace handrail {

struct StoreyRoom {
    std::uint32_t room = 0;  // of the RoomGraph
    std::string name;        // in the language spoken
    RoomKind kind = RoomKind::Room;
    std::vector<std::vector<Vec2>> loops_m;  // see RoomOutline: a body's radius inside the walls
    double area_m2 = 0.0;
    Vec2 min_m{0.0}, max_m{0.0};  // of the loops
    Vec2 middle_m{0.0};    // by area, of its largest piece; where that is in another room, its own floor nearest to it
    bool outside = false;  // on the ground that a reader laid around the building
    bool shut = false;     // nothing leads into it
    bool elsewhere = false;  // the other plan of the storey shows it: see Storey::upper
};

// Something that stands on the floor and is no part of the building.
struct StoreyThing {
    FeatureId feature = kNoFeature;
    std::string name;  // in the language spoken
    PlanBox box;
    bool landmark = false;
};

// A door or an opening in a wall, between its jambs.
struct StoreyGap {
    PassageKind kind = PassageKind::Door;
    std::string name;  // empty for an opening
    Vec2 place_m{0.0};
    Vec2 along{1.0, 0.0};  // from jamb to jamb
    double width_m = 0.0;
    double deep_m = 0.0;  // on either side of its place this much is free too; 0: as deep as the wall is
};

// What joins two rooms of the storey: RoomGraph::portals.
struct StoreyPortal {
    PassageKind kind = PassageKind::Door;
    std::array<std::uint32_t, 2> rooms{};  // places in Storey::rooms
    Vec2 place_m{0.0};
    double width_m = 0.0;
};

struct StoreyStairs {
    std::uint32_t room = 0;  // that they begin or end in; a place in Storey::rooms
    std::vector<std::vector<Vec2>> loops_m;
};

// How a room is joined to one on another storey, without a flight of stairs that the plan shows: a lift, a ramp, steps
// that belong to the rooms at their ends. Falls are not among them.
struct StoreyExit {
    PassageKind kind = PassageKind::Opening;
    std::uint32_t room = 0;  // a place in Storey::rooms
    std::string to;          // the other room, in the language spoken
    Vec2 place_m{0.0};
};

struct StoreyBase {
    Vec2 place_m{0.0};
    double heading_rad = 0.0;
};

// Whose floor lies where, in squares.
struct StoreyFloor {
    double cell_m = 0.2;
    int wide = 0, high = 0;           // from Storey::min_m on
    std::vector<std::uint32_t> room;  // row by row; the place in Storey::rooms, kNothing where no body can stand
};

struct Storey {
    int number = 1, count = 1;  // from 1, the lowest
    // A plan shows one floor at each place. Where a storey has two, as with a footway over a platform, the storey
    // itself shows the lower floor, and a second plan shows the rooms of the upper one, with what joins them.
    bool upper = false;
    std::vector<std::uint32_t> hidden;  // places in `rooms`: parts of them are above others, on the second plan
    std::string world;
    std::string name;             // what the file calls the storey; may be empty
    double floor_m = 0.0;         // mean height of its rooms
    Vec2 min_m{0.0}, max_m{0.0};  // what is shown; the ground around a building does not widen it
    std::vector<StoreyRoom> rooms;
    StoreyFloor floor;
    // Cut 1 m above the floor, with sills, what closes windows, and whatever else stops a body between rooms.
    std::vector<PlanOutline> walls_m;
    std::vector<std::array<Vec2, 2>> sheets_m;  // walls without thickness, of meshes
    std::vector<PlanOutline> windows_m;         // those of walls_m that close a window
    std::vector<StoreyThing> things;            // landmarks first, then by size
    std::vector<StoreyGap> gaps;
    std::vector<StoreyStairs> stairs_of_others;  // flights that belong to another storey and begin or end here
    std::vector<StoreyPortal> portals;
    std::vector<StoreyExit> exits;
    std::optional<StoreyBase> base;
    int moving = 0;  // things free to move, which are not among `things`: they may stand elsewhere tomorrow
};

// How many storeys there are; 0 without rooms.
int storey_count(const RoomGraph& graph);
// The one with the base, else with the first start; 1 where that is in no room.
int storey_of_start(const Scene& scene, const RoomGraph& graph, const WalkSpace& space);
// Fails with one sentence where there is no such storey or no room in it. Time goes with solids and spans.
Result<Storey> storey_of(const Scene& scene, const RoomGraph& graph, const WalkSpace& space, int number);

// The second plan of a storey that has floors above each other; nothing if `storey`, which storey_of() made, has none.
std::optional<Storey> upper_part_of(const Scene& scene, const RoomGraph& graph, const WalkSpace& space,
                                    const Storey& storey);

// The place in Storey::rooms of the one whose floor is at a place; kNothing under furniture, in walls, outside.
std::uint32_t floor_at(const Storey& storey, const Vec2& at);
// Fills Storey::floor from the rooms' loops, for storeys that no reader made.
void lay_floor(Storey& storey);

}  // namespace handrail
