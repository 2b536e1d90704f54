// Defines the rooms of a world and the portals between them as a graph. Every kind of world has such a graph, made from
// the walkable space and the rooms that the file states. Pure functions; any thread may call them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

enum class RoomKind : std::uint8_t { Room, Stairs, Liquid, Niche };

// The noun for a room in a name that Handrail makes.
enum class RoomLook : std::uint8_t { Niche, Corridor, SmallRoom, Room, LargeRoom, Hall };
struct MadeRoomName {
    // Name of the object in the room from which the room has its name; empty: none. See Feature::name.
    std::string thing;
    bool thing_made = false;  // `thing` is a name that the program made; see Feature::made_name
    OtherLanguages thing_in = {};
    bool with_thing = false;  // the name is "room with Stove"; otherwise it is the name of the object
    RoomLook look = RoomLook::Room;
    int wide_m = 0, deep_m = 0;           // size of the room; a room without an object is named by its size and place
    std::optional<double> side_rad = {};  // on which side of the storey the room is; none: in the middle
    int level = 0, levels = 1;
    // Name of the storey in the file, if there are several storeys; empty: the name contains the number of the level.
    std::string storey = {};
};

struct Room {
    RoomKind kind = RoomKind::Room;
    // The spoken name, in lower case unless it is a proper name: "Kitchen", "large room, 12 by 8 metres, north". A name
    // that no person gave is in the language that was spoken when the graph was made: see say_room_names. Files never
    // use such a name to refer to a room.
    std::string name;
    bool given = false;  // `name` comes from a person
    // The name that the map gives. If it is empty, the map gives none, and Handrail made the name from what is known
    // about the room.
    std::string map_name;
    OtherLanguages map_name_in;
    bool is_way = false;  // the room is a footway, a street or a platform outdoors
    MadeRoomName made;
    // Number of the room among those with the same name; footways, streets and platforms are not numbered.
    int same_name = 1;
    int level = 0;         // number of the storey; 0 is the lowest
    double area_m2 = 0.0;  // area of the floor where people can stand, including the strip along the walls
    double floor_m = 0.0;  // mean height of the floor
    Aabb bounds_m;         // box around the room's floor
    Vec3 middle_m{0.0};    // place in the room with the most clearance
};

struct Portal {
    PassageKind kind = PassageKind::Opening;
    std::array<std::uint32_t, 2> rooms{};  // a one-way portal leads from the first to the second
    Vec3 place_m{0.0};
    double width_m = 0.0;
    FeatureId feature = kNoFeature;  // the door, lift or teleporter that joins the rooms
    bool one_way = false;
};

// A name that a person gives to the room around a place.
struct GivenName {
    Vec3 at_m{0.0};
    std::string name;
};

struct RoomGraph {
    std::vector<Room> rooms;
    std::vector<Portal> portals;
    std::vector<std::uint32_t> room_of_span;  // for each entry of WalkSpace::spans: its room
    std::string language;                     // language of the names that Handrail made
};

// Makes the graph. Rooms are divided at doors, stairs, liquids and places where walls narrow the floor; furniture does
// not divide them. Floor that no wall divides, but that has several names of Scene::room_names, is divided at the
// narrowest places between them. The time is proportional to the number of spans. `stop` is queried every few
// milliseconds; after a stop the graph has no rooms.
RoomGraph make_rooms(const Scene& scene, const WalkSpace& space, const std::stop_token& stop = {});

// Returns the name that Handrail makes for a room without one, in the language spoken.
std::string own_name(const Room& room);
// Returns the name by which files refer to the room in any language: the name that a person gave, or else the map's
// name. Empty if neither a person nor the map named the room.
const std::string& known_as(const Room& room);

// Numbers the rooms that have the same name and sets all names. Afterwards the names are those of a new graph, without
// the names that people gave.
void number_room_names(RoomGraph& graph);
// If another language is spoken now, makes the names of rooms again in that language. Otherwise returns at once.
void say_room_names(RoomGraph& graph);

// Returns the room at that place; kNothing if nobody can walk there.
std::uint32_t room_at(const RoomGraph& graph, const WalkSpace& space, const Vec3& feet_m);

// Returns whether the walker is on the floor of the room and at least a hand's breadth inside it. The walker must also
// be inside the outline that the file states for the room, if any. On the border it would be unclear which room the
// program announces.
bool stands_inside(const RoomGraph& graph, const WalkSpace& space, const Scene& scene, const Vec3& feet_m,
                   std::uint32_t room);

// Returns whether the room is on the ground that a reader laid around a building. Such a room has no walls.
bool is_outside(const Room& room, const WalkSpace& space, const Scene& scene);

// Returns the boxes that nobody can pass if a door is blocked: those of the leaves at their places in the file, and
// that of the doorway.
std::vector<Aabb> door_boxes(const Scene& scene, const RoomGraph& graph, FeatureId door);

// Applies each name that a person gave to the room around its place. Returns the names that no longer have a room, or
// whose room has another given name.
std::vector<std::string> give_names(RoomGraph& graph, const WalkSpace& space, const std::vector<GivenName>& names);

// Returns the exits from a room as indices in RoomGraph::portals. They are in clockwise order as seen from `feet_m`,
// starting from `heading_rad`.
std::vector<std::uint32_t> exits_of(const RoomGraph& graph, std::uint32_t room, const Vec3& feet_m, double heading_rad);

}  // namespace handrail::navigation
