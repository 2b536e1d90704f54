// Finds where a door could be missing: in a wall between a room and its neighbours. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "worlds/check/faults.h"
#include "worlds/navigation/rooms.h"
#include "worlds/scene/made_door.h"
#include "worlds/scene/scene.h"

namespace handrail::check {

struct MissingDoor {
    std::uint32_t to = navigation::kNothing;  // index of the room on the other side
    MadeDoor door;                            // the door to make; without a name
};

// Finds up to `most` doors, one for each neighbour on the same storey. Only one straight wall may separate it from the
// room over the width of a door. A wall within arm's reach of `near_m` comes first, the nearest one before others, with
// the door there. Then come the neighbours by length of the shared wall, with the door in its middle. The ground
// outside comes last. Walls may have any direction, but no bends. The time grows with the spans of the room.
std::vector<MissingDoor> missing_doors(const Scene& scene, const navigation::WalkSpace& space,
                                       const navigation::RoomGraph& graph, std::uint32_t room,
                                       const std::optional<Vec3>& near_m = std::nullopt, std::size_t most = 4);

// The doorway that would make an impassable door passable, if only walls block it. It is at the place of the door,
// perpendicular to its leaf, else to the wall. Empty for other faults, and if a thing is in the doorway.
std::optional<MadeDoor> doorway_cut_free(const Scene& scene, const WorldFault& fault);

}  // namespace handrail::check
