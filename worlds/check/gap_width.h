// Measures the width of a passage exactly at its narrowest place. The columns of the walkable space give this width
// only to some centimetres. Only the sources of worlds/check use it.
#pragma once

#include "worlds/check/examined.h"

namespace handrail::check {

// Returns the length of the shortest horizontal line between two solids that passes near at_m, which is at the height
// of the soles. Returns about_m, the approximate width that is already known, if there is no such line within two
// columns of about_m. World metres.
double gap_width(const Examined& world, const Vec3& at_m, double about_m);

}  // namespace handrail::check
