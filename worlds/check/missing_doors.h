// Finds where a door could be missing: in a wall between a room and its neighbours. Pure functions; any thread may call
// them.
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
    std::uint32_t to = navigation::kNothing;  // index of the room on the other side of the door
    MadeDoor door;                            // the door to make; its name is empty
};

// Finds up to `most` doors, at most one for each neighbour on the same storey. Only one straight wall may separate the
// neighbour from the room over the width of a door. The result is ordered in this way:
//   - Walls within arm's reach of `near_m`, the nearest first, each with the door at that place.
//   - Other walls, the longest shared wall first, each with the door in its middle.
//   - Walls to the ground outside.
// Walls may have any direction, but no bends. The time grows with the spans of the room.
std::vector<MissingDoor> missing_doors(const Scene& scene, const navigation::WalkSpace& space,
                                       const navigation::RoomGraph& graph, std::uint32_t room,
                                       const std::optional<Vec3>& near_m = std::nullopt, std::size_t most = 4);

// Returns the doorway that would make an impassable door passable, if only walls block it. It is at the place of the
// door and perpendicular to the door's leaf, or to the wall if there is no leaf. Empty for other faults, and if a thing
// is in the doorway.
std::optional<MadeDoor> doorway_cut_free(const Scene& scene, const WorldFault& fault);

}  // namespace handrail::check
