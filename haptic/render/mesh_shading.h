// Force shading of tessellated curves (S30) as a height field, so that it conserves energy. Over each facet lies the
// curve that its corners' normals suggest. Edge ij rises in its middle by the sagitta s = 1/8 (n_j - n_i).(p_j - p_i),
// and a facet by 4 s l_i l_j summed over its edges (l: barycentric). Neighbours share this rise along their edge. The
// potential is 1/2 K (press + rise)^2. The force is its gradient and turns with the curve instead of the facet. While
// the proxy rolls round an edge, the force keeps to the edge's own normal: see surface_field.cpp. Corner normals are
// weighted by angle and taken only across edges flatter than the crease, so real corners stay sharp. Source: Vlachos et
// al., Curved PN triangles, I3D 2001, triangular surface patches with normals at corners; here only the height along
// the normal is kept. Built at set-up; 24 bytes a triangle.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "worlds/geometry/triangle_mesh.h"

namespace handrail::render {

struct MeshShading {
    static constexpr double kCreaseCosine = 0.8660254037844386;  // 30 degrees
    static constexpr double kSteepest = 0.6;  // the edges of facets that would rise more steeply are left flat
    static constexpr std::uint32_t kNone = 0xffffffffU;

    struct Facet {
        std::array<float, 3> sagitta_m{};  // of the edges 01, 12, 20; positive towards the front
        // For each edge the facet on its other side, if the edge is smooth.
        std::array<std::uint32_t, 3> across{kNone, kNone, kNone};
    };
    std::vector<Facet> facets;  // one per triangle; empty: no shading
    double highest_m = 0.0;     // no facet rises or sinks by more
};

// Points at the same place count as one. Edges with one facet or more than two, facets that face opposite ways, and
// needles stay flat.
MeshShading shade_mesh(std::span<const Vec3> points_m, std::span<const Corners> triangles,
                       double crease_cosine = MeshShading::kCreaseCosine);

}  // namespace handrail::render
