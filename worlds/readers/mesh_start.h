// Where somebody can stand in a mesh whose format knows no start: on a floor of sheets or solids with room for a body
// and to go on from. Pure function; any thread.
#pragma once

#include <optional>
#include <stop_token>

#include "worlds/scene/scene.h"

namespace handrail {

// They overlap by more than a micrometre; wrongly true only near an edge of the solid.
bool meets(const Solid& solid, const Aabb& box);

// The soles, at the free place nearest to the middle: under something before under the sky, lower before higher. From
// it one must be able to go on to most sides, on level ground, so that nobody begins on a table or within a wall.
// Nothing: there is no such place. Looks at some hundred columns; `stop` is asked at each.
std::optional<Vec3> place_to_stand(const Scene& scene, const std::stop_token& stop = {});
// Makes it the start of the scene, where there is one, and says so in its report.
void start_on_floor(Scene& scene, const std::stop_token& stop);

}  // namespace handrail
