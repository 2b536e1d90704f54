// How wide a passage is at its narrowest, exactly, where the columns of the walkable space know it to some centimetres.
// For the sources of worlds/check only.
#pragma once

#include "worlds/check/examined.h"

namespace handrail {

// Near this place, at the soles, a passage is about so wide: the shortest level line between two solids through a point
// near there. `about_m`, where none is within two columns of it. World metres.
double gap_width(const Examined& world, const Vec3& at_m, double about_m);

}  // namespace handrail
