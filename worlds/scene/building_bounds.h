// Computes the size of the building in world metres. It excludes the ground that readers add around the building and
// outdoor parts of the file, such as paths and lawns. Pure functions; any thread may call them.
#pragma once

#include "worlds/scene/scene.h"

namespace handrail {

// Returns the bounds of the rooms that the file states and of the building parts next to them. If the file states no
// rooms, returns the bounds of everything except the ground that readers added. Empty if the scene has nothing but that
// ground.
Aabb building_bounds_m(const Scene& scene);
// Returns the bounds of the table of a labyrinth game: its borders, holes and goals. Empty if the scene has no game.
Aabb labyrinth_table_m(const Scene& scene);

}  // namespace handrail
