// Finds a place to stand in a mesh, for formats without a start: on a floor of sheets or solids, with room for a body
// and space to walk on from there. Pure function; any thread.
#pragma once

#include <optional>
#include <stop_token>

#include "worlds/scene/scene.h"

namespace handrail::readers {

// True if they overlap by more than a micrometre. May be wrongly true near an edge of the solid.
bool meets(const Solid& solid, const Aabb& box);

// Returns where the soles are, at the free place nearest to the middle. It prefers places under a roof, and then lower
// ones. From there the person must be able to walk on to most sides on level ground, so that nobody starts on a table
// or within a wall. Empty if there is no such place. Tests some hundred columns and checks `stop` at each.
std::optional<Vec3> place_to_stand(const Scene& scene, const std::stop_token& stop = {});
// Makes that place the scene's start, if there is one, and says so in the scene's report.
void start_on_floor(Scene& scene, const std::stop_token& stop);

}  // namespace handrail::readers
