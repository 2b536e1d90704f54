// Triangles that share their corners. Plain data: no thread, no state. Metres, in a frame that the owner defines.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail {

// Corners of one triangle as indices of points; counter-clockwise seen from the front.
using Corners = std::array<std::uint32_t, 3>;

// The side from which a sheet (triangle or polygon) can be touched. Its front is the side from which its corners run
// counter-clockwise. A one-sided sheet stops only a proxy that came from that side; from the other side the proxy
// passes freely and without force.
enum class TouchSide : std::uint8_t { Both, Front, Back };

struct TriangleMesh {
    std::vector<Vec3> points_m;
    std::vector<Corners> triangles;
};

}  // namespace handrail
