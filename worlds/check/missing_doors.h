// Where a door could be missing: a wall that stands between a room and its neighbours. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "worlds/navigation/rooms.h"
#include "worlds/scene/made_door.h"
#include "worlds/scene/scene.h"

namespace handrail {

struct MissingDoor {
    std::uint32_t to = kNothing;  // the room on the other side
    MadeDoor door;                // as it would be made; no name
};

// One for each neighbour on the same storey that nothing but one straight wall parts from the room over the width of a
// door, at most `most`: the wall that is nearest to `near_m` first, where that is within arm's reach of it, and the
// door there; else those that share the longest wall, and the door in its middle; the ground outside last. Walls that
// run north and south or east and west are looked at. Time goes with the spans of the room.
std::vector<MissingDoor> missing_doors(const Scene& scene, const WalkSpace& space, const RoomGraph& graph,
                                       std::uint32_t room, const std::optional<Vec3>& near_m = std::nullopt,
                                       std::size_t most = 4);

}  // namespace handrail
