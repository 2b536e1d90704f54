// Computes force shading of tessellated curves as a height field, so that it conserves energy. Each facet gets a height
// above its plane, computed from the normals at its corners, which approximates the original curve. Edge ij rises in
// its middle by the sagitta s = 1/8 (n_j - n_i).(p_j - p_i). A facet rises by 4 s l_i l_j summed over its edges (l:
// barycentric). Neighbouring facets have the same rise along their common edge.
//
// The potential is 1/2 K (press + rise)^2. The force is the potential's gradient and turns with the curve instead of
// the facet. While the proxy rolls round an edge, the force has the direction of the edge's own normal: see
// surface_field.cpp. Corner normals are weighted by angle and averaged only across edges flatter than the crease angle,
// so real corners stay sharp. Source: Vlachos et al., Curved PN triangles, I3D 2001, triangular surface patches with
// normals at corners; this code keeps only the height along the normal. Built at set-up; 24 bytes a triangle.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "worlds/geometry/triangle_mesh.h"

namespace handrail::render {

struct MeshShading {
    static constexpr double kCreaseCosine = 0.8660254037844386;  // crease angle: cosine of 30 degrees
    static constexpr double kSteepest = 0.6;  // greatest slope of a facet's rise; steeper facets get flat edges
    static constexpr std::uint32_t kNone = 0xffffffffU;

    struct Facet {
        std::array<float, 3> sagitta_m{};  // sagittas of the edges 01, 12, 20; positive towards the front
        // For each edge the facet on its other side if the edge is smooth, otherwise kNone.
        std::array<std::uint32_t, 3> across{kNone, kNone, kNone};
    };
    std::vector<Facet> facets;  // one for each triangle; empty: no shading
    double highest_m = 0.0;     // greatest rise or sink of any facet
};

// Computes the shading of a mesh. Points at the same place are treated as one. Degenerate needles get no rise. Nor do
// edges with one facet or more than two, or between facets that face opposite ways.
MeshShading shade_mesh(std::span<const Vec3> points_m, std::span<const Corners> triangles,
                       double crease_cosine = MeshShading::kCreaseCosine);

}  // namespace handrail::render
