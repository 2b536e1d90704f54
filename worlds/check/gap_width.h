// Measures the exact width of a passage at its narrowest place. The columns of the walkable space give this width only
// to some centimetres. Only the sources of worlds/check use it.
#pragma once

#include "worlds/check/examined.h"

namespace handrail::check {

// Returns the length of the shortest horizontal line between two solids that passes near at_m, which is at the height
// of the soles. `about_m` is the approximate width that is already known. Returns `about_m` if the shortest line
// differs from it by more than two columns. World metres.
double gap_width(const Examined& world, const Vec3& at_m, double about_m);

}  // namespace handrail::check
