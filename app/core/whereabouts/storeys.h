// The storeys of a building by its rooms: their names and numbers of rooms. Pure functions over plain values; world
// metres; any thread.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "worlds/navigation/rooms.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

struct StoreyOfRooms {
    int level = 0;                     // as in Room::level, which also counts storeys without rooms
    std::string file_name;             // its name in the file, fit to be spoken; empty: none
    double floor_m = 0.0;              // floor height of most of its rooms
    std::vector<std::uint32_t> rooms;  // of the graph; never empty
};

// From the lowest up. If the file states rooms, only those that it names count; otherwise all except stairs, water and
// niches.
std::vector<StoreyOfRooms> storeys_of(const Scene& scene, const navigation::RoomGraph& graph);

// Index in `storeys` of the storey of a room; their number if it is on none.
std::size_t storey_of_room(const std::vector<StoreyOfRooms>& storeys, const navigation::RoomGraph& graph,
                           std::uint32_t room);

// "Level 1", as the file calls it, otherwise "Storey 1", counted from below.
std::string storey_name(const std::vector<StoreyOfRooms>& storeys, std::size_t which);
// "Duplex, Level 1, storey 1 of 2: 11 rooms."
std::string storey_sentence(const Scene& scene, const std::vector<StoreyOfRooms>& storeys, std::size_t which);

}  // namespace handrail::core
