// Converts a Scene to data for the graphics card: triangles, outlines and the brightness of each surface. These pure
// functions run once for each scene, on any thread. Kinds of surface always differ in luminance or pattern, and not
// only in hue, so that people with any colour vision can tell them apart.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail::window {

enum class DrawPattern : std::uint8_t { Plain, UprightStripes, LevelStripes, Slanted, Checks };

struct DrawLook {
    std::array<std::uint8_t, 3> rgb{};
    DrawPattern pattern = DrawPattern::Plain;
    bool translucent = false;
};

// A vertex in the layout that the graphics card reads. Float is precise enough if the origin is inside the building: at
// a distance of 128 m, neighbouring values differ by 0.008 mm.
struct DrawVertex {
    std::array<float, 3> position_m;  // position relative to DrawMesh::origin_m
    std::array<float, 2> surface_m;   // position in the axes of the surface, for patterns
    std::array<std::uint8_t, 3> rgb;
    DrawPattern pattern;
};

struct DrawEdge {
    std::array<float, 3> a_m, b_m;  // ends of the edge, relative to DrawMesh::origin_m
};

// A part of the building that is drawn or left out as a whole.
struct DrawChunk {
    Aabb bounds_m;                                   // relative to DrawMesh::origin_m
    std::uint32_t first_index = 0, index_count = 0;  // range in DrawMesh::opaque
    std::uint32_t first_edge = 0, edge_count = 0;
};
inline constexpr double kChunk_m = 8.0;

struct DrawMesh {
    Vec3 origin_m{0.0};
    std::vector<DrawVertex> vertices;
    std::vector<std::uint32_t>
        // Corners of triangles as vertex indices, counter-clockwise as seen from outside. Sheets have triangles for
        // both sides.
        opaque;
    std::vector<std::uint32_t> translucent;  // corners of triangles that are visible from both sides; drawn last
    std::vector<DrawEdge> edges;
    std::vector<DrawChunk> chunks;  // parts that together cover all of `opaque` and `edges`
};

// Returns how a surface looks. Walls are bright, doors brightest with upright stripes, floors dark, and ceilings in
// between. Liquids have slanted stripes and are translucent.
DrawLook look_of(FeatureKind kind, SolidRole role, const Vec3& normal);

// Returns the perceived luminance, 0 to 255: the encoded values weighted as in ITU-R BT.709.
double luminance(const std::array<std::uint8_t, 3>& rgb);

// Makes the mesh. Leaves out volumes without a visible surface, such as triggers and clips. Draws outlines at the
// borders of surfaces, but not where two pieces of one feature meet in one plane. Takes about 25 ms for a map of 7,000
// polygons. `drawn` selects the features; an empty function selects all.
DrawMesh build_draw_mesh(const Scene& scene, const std::function<bool(FeatureId)>& drawn = {});

}  // namespace handrail::window
