// The storeys of a building as its rooms lie on them: how each is called and how many rooms are there. Pure functions
// over plain values; world metres; any thread.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "worlds/navigation/rooms.h"
#include "worlds/scene/scene.h"

namespace handrail {

struct StoreyOfRooms {
    int level = 0;                     // as Room::level counts, in which there are storeys without rooms too
    std::string file_name;             // as the file calls it, fit to be spoken; empty: it does not
    double floor_m = 0.0;              // where most of its rooms have theirs
    std::vector<std::uint32_t> rooms;  // of the graph; never empty
};

// From the lowest up. Of a file that states rooms those count that it names, of any other what is no stairs, water or
// niche.
std::vector<StoreyOfRooms> storeys_of(const Scene& scene, const RoomGraph& graph);

// The place among `storeys` of the one that a room lies on; as many as there are: on none of them.
std::size_t storey_of_room(const std::vector<StoreyOfRooms>& storeys, const RoomGraph& graph, std::uint32_t room);

// "Level 1", as the file calls it, else "Storey 1", counted from below.
std::string storey_name(const std::vector<StoreyOfRooms>& storeys, std::size_t which);
// "Duplex, Level 1, storey 1 of 2: 11 rooms."
std::string storey_sentence(const Scene& scene, const std::vector<StoreyOfRooms>& storeys, std::size_t which);

}  // namespace handrail
