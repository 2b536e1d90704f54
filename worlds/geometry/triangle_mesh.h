// Defines triangles that share their corners. Plain data that any thread may use, in metres, in a frame that the owner
// of the mesh defines.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail {

// The corners of one triangle, as indices of points. They run counter-clockwise seen from the front.
using Corners = std::array<std::uint32_t, 3>;

// The side from which a sheet (triangle or polygon) can be touched. Its front is the side from which its corners run
// counter-clockwise. A one-sided sheet stops only a proxy that comes from the touchable side. From the other side the
// proxy passes freely and without force.
enum class TouchSide : std::uint8_t { Both, Front, Back };

struct TriangleMesh {
    std::vector<Vec3> points_m;
    std::vector<Corners> triangles;
};

}  // namespace handrail
