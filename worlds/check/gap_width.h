// Measures a passage exactly at its narrowest place; the columns of the walkable space know its width only to some
// centimetres. Only for the sources of worlds/check.
#pragma once

#include "worlds/check/examined.h"

namespace handrail::check {

// The shortest horizontal line between two solids through a point near at_m, which is at the soles. Returns about_m,
// the width known so far, if no such line is within two columns of it. World metres.
double gap_width(const Examined& world, const Vec3& at_m, double about_m);

}  // namespace handrail::check
