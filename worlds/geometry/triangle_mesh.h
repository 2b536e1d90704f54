// Triangles that share their corners. Plain data: no thread, no state. Metres, in whose frame the owner says.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail {

// Corners of one triangle as indices of points; counter-clockwise seen from the front.
using Corners = std::array<std::uint32_t, 3>;

struct TriangleMesh {
    std::vector<Vec3> points_m;
    std::vector<Corners> triangles;
};

}  // namespace handrail
