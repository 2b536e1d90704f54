// Where a door could be missing: a wall that stands between a room and its neighbours. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "worlds/check/faults.h"
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
// door there; else those that share the longest wall, and the door in its middle; the ground outside last. Walls may
// run in any direction, but not bend. Time goes with the spans of the room.
std::vector<MissingDoor> missing_doors(const Scene& scene, const WalkSpace& space, const RoomGraph& graph,
                                       std::uint32_t room, const std::optional<Vec3>& near_m = std::nullopt,
                                       std::size_t most = 4);

// The doorway that makes a door passable, where nothing but walls keeps a body from going through it: around its place,
// square to its leaf or else to the wall. Nothing for other faults, and where a thing stands in it.
std::optional<MadeDoor> doorway_cut_free(const Scene& scene, const WorldFault& fault);

}  // namespace handrail
