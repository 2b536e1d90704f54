// Finds a place to stand in a mesh, for formats without a start. The place is on a floor of sheets or solids, with room
// for a person and space to walk on from there. Pure functions; any thread may call them.
#pragma once

#include <optional>
#include <stop_token>

#include "worlds/scene/scene.h"

namespace handrail::readers {

// True if solid and box overlap by more than a micrometre. The result may be wrongly true near an edge of the solid.
bool meets(const Solid& solid, const Aabb& box);

// Returns the position of the soles at the free place nearest to the middle of the scene. Places under a roof are
// preferred, and then lower places. From there the person must be able to walk on to most sides on level ground, so
// that nobody starts on a table or within a wall. Empty if there is no such place. Tests some hundred columns and
// checks `stop` at each.
std::optional<Vec3> place_to_stand(const Scene& scene, const std::stop_token& stop = {});
// Makes the result of place_to_stand the scene's start, if there is one, and mentions it in the scene's report.
void start_on_floor(Scene& scene, const std::stop_token& stop);

}  // namespace handrail::readers
