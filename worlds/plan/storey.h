// Makes a plan of one storey of a building for drawing or printing: walls with windows closed and doors open, rooms,
// things, passages and the base. Windows are drawn closed, by their sills and panes, because every gap in a raised line
// feels like a door to a finger. Plain values and pure functions; any thread may use them. World metres, x east, y
// north.
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
    std::uint32_t room = 0;  // index of the room in the RoomGraph
    std::string name;        // name of the room in the spoken language
    navigation::RoomKind kind = navigation::RoomKind::Room;
    // The outline of the area where the middle of a walker can be, so it is a walker's radius inside the walls (see
    // RoomOutline).
    std::vector<std::vector<Vec2>> loops_m;
    double area_m2 = 0.0;
    Vec2 min_m{0.0}, max_m{0.0};  // bounds of loops_m
    // Centroid of the largest piece of the room. If that point is in another room, the nearest place on the room's own
    // floor.
    Vec2 middle_m{0.0};
    bool outside = false;    // true if the room is on the ground that a reader added around the building
    bool shut = false;       // true if nothing leads into the room
    bool elsewhere = false;  // true if the other plan of the storey shows the room; see Storey::upper
};

// A thing on the floor that is not part of the building.
struct StoreyThing {
    FeatureId feature = kNoFeature;
    std::string name;  // name of the thing in the spoken language
    PlanBox box;
    bool landmark = false;
};

// A door or an opening in a wall, from jamb to jamb.
struct StoreyGap {
    navigation::PassageKind kind = navigation::PassageKind::Door;
    std::string name;  // name of the door; empty for an opening
    Vec2 place_m{0.0};
    Vec2 along{1.0, 0.0};  // direction from one jamb to the other
    double width_m = 0.0;
    // Distance by which the gap extends from place_m to each side of the wall; 0: it is as deep as the wall.
    double deep_m = 0.0;
    // The two rooms, as indices into Storey::rooms; kNothing: the room is on another storey.
    std::array<std::uint32_t, 2> rooms{navigation::kNothing, navigation::kNothing};
};

// A portal between two rooms of the storey, as in RoomGraph::portals.
struct StoreyPortal {
    navigation::PassageKind kind = navigation::PassageKind::Door;
    std::array<std::uint32_t, 2> rooms{};  // the two rooms, as indices into Storey::rooms
    Vec2 place_m{0.0};
    double width_m = 0.0;
};

// The places at which a walker can step from one room of the storey into another. A portal has one place and one width,
// which do not describe an opening that runs around a corner.
struct StoreyCrossings {
    std::array<std::uint32_t, 2> rooms{};  // the two rooms, as indices into Storey::rooms, the lower one first
    std::vector<Vec2> places_m;
};

struct StoreyStairs {
    std::uint32_t room = 0;  // the room in which the stairs begin or end, as an index into Storey::rooms
    std::vector<std::vector<Vec2>> loops_m;
};

// A connection of a room to another storey other than stairs that are drawn on the plan: a lift, a ramp, or steps that
// belong to the rooms at their ends. Drops are not included.
struct StoreyExit {
    navigation::PassageKind kind = navigation::PassageKind::Opening;
    std::uint32_t room = 0;  // the room on this storey, as an index into Storey::rooms
    std::string to;          // name of the room on the other storey, in the spoken language
    Vec2 place_m{0.0};
    double width_m = 0.0;
};

struct StoreyBase {
    Vec2 place_m{0.0};
    double heading_rad = 0.0;
};

// A grid of square cells that states for each cell the room whose floor is there.
struct StoreyFloor {
    double cell_m = 0.2;
    int wide = 0, high = 0;  // number of cells in x and y, beginning at Storey::min_m
    // Stored row by row: the room as an index into Storey::rooms, or kNothing where nobody can stand.
    std::vector<std::uint32_t> room;
    // For the same cells: 1 if the cell is outside all floors and no wall is between it and the rim of the plan. Empty
    // if this is not known.
    std::vector<std::uint8_t> beyond;
};

struct Storey {
    int number = 1, count = 1;  // number: counted from 1, the lowest storey; count: number of storeys
    // True for a second plan. A plan shows one floor at each place. If a storey has two floors above each other, like a
    // platform and a walkway above it, the first plan shows the lower floor. The second plan shows the rooms of the
    // upper floor and their connections.
    bool upper = false;
    // Rooms that have parts above other rooms, and therefore are on the second plan; indices into `rooms`.
    std::vector<std::uint32_t> hidden;
    std::string world;
    std::string name;             // the file's name for the storey, or empty
    double floor_m = 0.0;         // mean height of the floors of its rooms
    Vec2 min_m{0.0}, max_m{0.0};  // the area that the plan shows; ground around a building does not enlarge it
    std::vector<StoreyRoom> rooms;
    StoreyFloor floor;
    // Walls, cut 1 m above the floor. They include sills, parts that close windows, and all other parts that stop a
    // person between rooms.
    std::vector<PlanOutline> walls_m;
    std::vector<std::array<Vec2, 2>> sheets_m;  // walls that are meshes without thickness
    std::vector<PlanOutline> windows_m;         // the parts of walls_m that close windows
    std::vector<StoreyThing> things;            // landmarks first, then the largest first
    std::vector<StoreyGap> gaps;
    std::vector<StoreyStairs> stairs_of_others;  // flights that belong to another storey and begin or end on this one
    std::vector<StoreyPortal> portals;
    std::vector<StoreyCrossings> crossings;
    std::vector<StoreyExit> exits;
    std::optional<StoreyBase> base;
    int moving = 0;  // number of free bodies; `things` does not contain them, because they may be elsewhere tomorrow
};

// Returns the number of storeys; 0 if there are no rooms.
int storey_count(const navigation::RoomGraph& graph);
// Returns the storey of the base, or of the first start if there is no base. Returns 1 if that place is not in a room.
int storey_of_start(const Scene& scene, const navigation::RoomGraph& graph, const navigation::WalkSpace& space);
// Makes the plan. Fails with one sentence if there is no storey with that number, or no room on it. The time grows with
// the numbers of solids and spans.
Result<Storey> storey_of(const Scene& scene, const navigation::RoomGraph& graph, const navigation::WalkSpace& space,
                         int number);

// Makes the second plan of a storey whose floors are above each other. `storey` is the result of storey_of(). Empty if
// the storey needs no second plan.
std::optional<Storey> upper_part_of(const Scene& scene, const navigation::RoomGraph& graph,
                                    const navigation::WalkSpace& space, const Storey& storey);

// Returns the index in Storey::rooms of the room whose floor is at this place. Returns kNothing under furniture, in
// walls and outside.
std::uint32_t floor_at(const Storey& storey, const Vec2& at);

}  // namespace handrail::plan
