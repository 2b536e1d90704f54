// Derives the storeys of a building from its rooms, with their names and numbers of rooms. Pure functions over plain
// values in world metres, which any thread may call.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "worlds/navigation/rooms.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

struct StoreyOfRooms {
    int level = 0;          // number of the storey as in Room::level, which also counts storeys without rooms
    std::string file_name;  // name of the storey in the file, as it is spoken; empty: none
    double floor_m = 0.0;   // height of the floor of most of its rooms
    std::vector<std::uint32_t> rooms;  // indices in the room graph; never empty
};

// Returns the storeys, the lowest first. If the file states rooms, only the rooms that it names are included.
// Otherwise, all rooms except stairs, water and niches are included.
std::vector<StoreyOfRooms> storeys_of(const Scene& scene, const navigation::RoomGraph& graph);

// Returns the index in `storeys` of the storey of a room. If the room is on none of these storeys, returns the number
// of storeys.
std::size_t storey_of_room(const std::vector<StoreyOfRooms>& storeys, const navigation::RoomGraph& graph,
                           std::uint32_t room);

// Returns how many storeys room `to` is above room `from`; negative: below. Returns 0 if one of them is on no storey.
int storeys_up(const Scene& scene, const navigation::RoomGraph& graph, std::uint32_t from, std::uint32_t to);

// Returns the name from the file, such as "Level 1", or else "Storey 1", counted from the lowest.
std::string storey_name(const std::vector<StoreyOfRooms>& storeys, std::size_t which);
// Returns for each room of the graph the kinds for open_kinds_first: what the room is, such as "Rooms with a name" or
// "Footways and platforms", then its storey if there are several.
std::vector<std::vector<std::string>> kinds_of_rooms(const Scene& scene, const navigation::RoomGraph& graph);
// Returns "Duplex, Level 1, storey 1 of 2: 11 rooms."
std::string storey_sentence(const Scene& scene, const std::vector<StoreyOfRooms>& storeys, std::size_t which);

}  // namespace handrail::core
