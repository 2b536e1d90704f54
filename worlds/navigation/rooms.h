// Rooms and the portals between them: one graph for every kind of world, derived from the walkable space if the file
// states none. Pure functions; any thread.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

enum class RoomKind : std::uint8_t { Room, Stairs, Liquid, Niche };

// The kind of room in the name that Handrail makes for a room without one.
enum class RoomLook : std::uint8_t { Niche, Corridor, SmallRoom, Room, LargeRoom, Hall };
struct MadeRoomName {
    std::string thing;        // an object in the room that gives it its name, if any: see Feature::name
    bool thing_made = false;  // see Feature::made_name
    OtherLanguages thing_in = {};
    bool with_thing = false;  // "room with Stove"; else the room has the name of the object
    RoomLook look = RoomLook::Room;
    int wide_m = 0, deep_m = 0;           // otherwise the name states the size and place
    std::optional<double> side_rad = {};  // side of the storey; none: in the middle
    int level = 0, levels = 1;
    std::string storey = {};  // name of the storey in the file, if there are several; empty: the level is counted
};

struct Room {
    RoomKind kind = RoomKind::Room;
    // Lower case unless it is a proper name: "Kitchen", "large room, 12 by 8 metres, north". A name that no person gave
    // is in the language that was spoken when the graph was made: see say_room_names. Files never refer to a room by
    // it.
    std::string name;
    bool given = false;  // `name` comes from a person
    // Empty: the map gives no name, so the name is made from what is known about the room.
    std::string map_name;
    OtherLanguages map_name_in;
    bool is_way = false;  // a footway, a street or a platform outside rooms
    MadeRoomName made;
    int same_name = 1;     // number among the rooms of the same name; ways are not numbered
    int level = 0;         // 0 is the lowest
    double area_m2 = 0.0;  // floor where people can stand, plus the strip along the walls
    double floor_m = 0.0;  // mean height
    Aabb bounds_m;         // of the room's floor
    Vec3 middle_m{0.0};    // the place with the most room around it
};

struct Portal {
    PassageKind kind = PassageKind::Opening;
    std::array<std::uint32_t, 2> rooms{};  // a one-way portal leads from the first to the second
    Vec3 place_m{0.0};
    double width_m = 0.0;
    FeatureId feature = kNoFeature;  // the door, lift or teleporter
    bool one_way = false;
};

// A name for the room around a place.
struct GivenName {
    Vec3 at_m{0.0};
    std::string name;
};

struct RoomGraph {
    std::vector<Room> rooms;
    std::vector<Portal> portals;
    std::vector<std::uint32_t> room_of_span;  // size as WalkSpace::spans
    std::string language;                     // the language of the names
};

// Rooms are divided at doors, stairs, liquids and places where walls narrow the floor; furniture does not divide them.
// Names of Scene::room_names divide floor that no wall divides, at the narrowest place between them. The time is
// proportional to the spans. `stop` is queried every few milliseconds; after a stop the graph has no rooms.
RoomGraph make_rooms(const Scene& scene, const WalkSpace& space, const std::stop_token& stop = {});

// The name that Handrail makes for a room without one, in the language spoken.
std::string own_name(const Room& room);
// The name by which files refer to the room in any language: the person's or the map's. Empty if neither named it.
const std::string& known_as(const Room& room);

// Numbers the rooms of the same name and sets all names, as when the graph was made, before any person gave one.
void number_room_names(RoomGraph& graph);
// Remakes the names that Handrail made, if another language is spoken now. Costs nothing otherwise.
void say_room_names(RoomGraph& graph);

// The room at that place; kNothing if it is not walkable.
std::uint32_t room_at(const RoomGraph& graph, const WalkSpace& space, const Vec3& feet_m);

// Returns whether the walker is at least a hand's breadth inside the room, on its floor, and within the outline that
// the file states for it, if any. On the border it would be unclear which room is announced.
bool stands_inside(const RoomGraph& graph, const WalkSpace& space, const Scene& scene, const Vec3& feet_m,
                   std::uint32_t room);

// Returns whether the room is on the ground that a reader laid around a building. Such a room has no walls.
bool is_outside(const Room& room, const WalkSpace& space, const Scene& scene);

// The boxes that nobody can pass if a door is blocked: its leaves as the file has them, and the doorway.
std::vector<Aabb> door_boxes(const Scene& scene, const RoomGraph& graph, FeatureId door);

// Gives a person's names to the rooms around their places. Returns the names that no longer have a room, or share one
// with another name.
std::vector<std::string> give_names(RoomGraph& graph, const WalkSpace& space, const std::vector<GivenName>& names);

// Indices in RoomGraph::portals of the exits from a room. They are in clockwise order as seen from that place, starting
// from that heading.
std::vector<std::uint32_t> exits_of(const RoomGraph& graph, std::uint32_t room, const Vec3& feet_m, double heading_rad);

}  // namespace handrail::navigation
