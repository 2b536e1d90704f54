// Rooms and what joins them: one graph for every kind of world, derived from the walkable space where the file does not
// say. Pure functions; any thread.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "worlds/navigation/walk_space.h"

namespace handrail {

enum class RoomKind : std::uint8_t { Room, Stairs, Liquid, Niche };

// What a room without a name of its own is called by.
enum class RoomLook : std::uint8_t { Niche, Corridor, SmallRoom, Room, LargeRoom, Hall };
struct MadeRoomName {
    std::string thing;        // by something in it, where there is such a thing: see Feature::name
    bool thing_made = false;  // see Feature::made_name
    OtherLanguages thing_in = {};
    bool with_thing = false;  // "room with Stove"; else the room is called as the thing is
    RoomLook look = RoomLook::Room;
    int wide_m = 0, deep_m = 0;           // else by size and place
    std::optional<double> side_rad = {};  // of its storey it is on; none: in the middle
    int level = 0, levels = 1;
    std::string storey = {};  // of several, as the file names it; empty: it does not, and the level is counted
};

struct Room {
    RoomKind kind = RoomKind::Room;
    // Lower case unless it is a name: "Kitchen", "large room, 12 by 8 metres, north". One that no person gave is in the
    // language that was spoken when the graph was made: see say_room_names. No file knows a room by it.
    std::string name;
    bool given = false;    // `name` comes from a person
    std::string map_name;  // empty: the map gives none, and it is called by what is known of it
    OtherLanguages map_name_in;
    bool is_way = false;  // a footway, a street or a platform outside rooms
    MadeRoomName made;
    int same_name = 1;     // which of the rooms of that name it is; ways are not numbered
    int level = 0;         // 0 is the lowest
    double area_m2 = 0.0;  // of floor where one can stand, plus the strip along its walls
    double floor_m = 0.0;  // mean height
    Aabb bounds_m;         // of its floor
    Vec3 middle_m{0.0};    // the place with most room round it
};

struct Portal {
    PassageKind kind = PassageKind::Opening;
    std::array<std::uint32_t, 2> rooms{};  // from the first to the second where it leads one way
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
    std::vector<std::uint32_t> room_of_span;  // size WalkSpace::spans
    std::string language;                     // the one that the names are in
};

// Rooms are cut at doors, stairs, liquids and where walls come together; furniture makes none. Names of
// Scene::room_names cut apart what no wall does, at the narrowest place between them. Time goes with the spans. `stop`
// is asked every few milliseconds; stopped, there are no rooms in it.
RoomGraph make_rooms(const Scene& scene, const WalkSpace& space, const std::stop_token& stop = {});

// What a room is called where no person gave it a name, in the language spoken.
std::string own_name(const Room& room);
// The name that files know it by, whatever is spoken: the person's or the map's. Empty for one that neither has named.
const std::string& known_as(const Room& room);

// Numbers those of one name and says all names, as when the graph was made: before any person gave one.
void number_room_names(RoomGraph& graph);
// The own names anew where another language is spoken by now. Costs nothing where not.
void say_room_names(RoomGraph& graph);

// The room somebody stands in; kNothing where that is no walkable place.
std::uint32_t room_at(const RoomGraph& graph, const WalkSpace& space, const Vec3& feet_m);

// Somebody stands a hand's breadth inside the room, on its floor and within the outline that the file states of it, if
// it states one: on its border one is told of one room or the other.
bool stands_inside(const RoomGraph& graph, const WalkSpace& space, const Scene& scene, const Vec3& feet_m,
                   std::uint32_t room);

// The room is on the ground that a reader laid around a building: it has no walls of its own.
bool is_outside(const Room& room, const WalkSpace& space, const Scene& scene);

// What nobody passes where a door is blocked: its leaves as the file has them, and the doorway.
std::vector<Aabb> door_boxes(const Scene& scene, const RoomGraph& graph, FeatureId door);

// Gives the names of a person to the rooms around their places. The names for which there is no room any more, or no
// longer one of their own.
std::vector<std::string> give_names(RoomGraph& graph, const WalkSpace& space, const std::vector<GivenName>& names);

// Places in RoomGraph::portals that lead out of a room, clockwise as somebody at that place sees them who faces that
// way.
std::vector<std::uint32_t> exits_of(const RoomGraph& graph, std::uint32_t room, const Vec3& feet_m, double heading_rad);

}  // namespace handrail
