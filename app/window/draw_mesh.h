// What the graphics card is given of a Scene: triangles, outlines and how bright each surface is. Built once per scene,
// pure, any thread. Kinds of surface differ in luminance or pattern, never in hue alone, so that they can be told apart
// with any colour vision.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail {

enum class DrawPattern : std::uint8_t { Plain, UprightStripes, LevelStripes, Slanted, Checks };

struct DrawLook {
    std::array<std::uint8_t, 3> rgb{};
    DrawPattern pattern = DrawPattern::Plain;
    bool translucent = false;
};

// The vertex as the card reads it. Float is enough once the origin is inside the building: 128 m away values are 0.008
// mm apart.
struct DrawVertex {
    std::array<float, 3> position_m;  // from DrawMesh::origin_m
    std::array<float, 2> surface_m;   // place in the surface's own plane, for patterns
    std::array<std::uint8_t, 3> rgb;
    DrawPattern pattern;
};

struct DrawEdge {
    std::array<float, 3> a_m, b_m;  // from DrawMesh::origin_m
};

// A part of the building that is drawn or left out as a whole.
struct DrawChunk {
    Aabb bounds_m;                                   // from DrawMesh::origin_m
    std::uint32_t first_index = 0, index_count = 0;  // in DrawMesh::opaque
    std::uint32_t first_edge = 0, edge_count = 0;
};
inline constexpr double kChunk_m = 8.0;

struct DrawMesh {
    Vec3 origin_m{0.0};
    std::vector<DrawVertex> vertices;
    std::vector<std::uint32_t>
        opaque;  // triples of vertex indices, counter-clockwise seen from outside; sheets have both sides
    std::vector<std::uint32_t> translucent;  // likewise, but to be seen from both sides; drawn last
    std::vector<DrawEdge> edges;
    std::vector<DrawChunk> chunks;  // together all of `opaque` and `edges`
};

// Walls bright, doors brightest with upright stripes, floors dark, ceilings between; liquids slanted and translucent.
DrawLook look_of(FeatureKind kind, SolidRole role, const Vec3& normal);

// Luminance as seen, 0 to 255 (weights of ITU-R BT.709 on the encoded values).
double luminance(const std::array<std::uint8_t, 3>& rgb);

// Volumes without a visible surface (triggers, clips) are left out. Outlines are the borders of surfaces; where two
// pieces of one feature in one plane meet there is none. About 25 ms for a map of 7,000 polygons.
// drawn: which features are; empty: all.
DrawMesh build_draw_mesh(const Scene& scene, const std::function<bool(FeatureId)>& drawn = {});

}  // namespace handrail
