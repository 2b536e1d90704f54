// Finds the surface of many overlapping and touching convex solids: the parts of each face that no other solid covers,
// and which of these parts form one flat surface. Pure functions, called on the loading thread. The cost grows with the
// number of pairs of solids that overlap or touch: 30 ms for 1,200 brushes.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"

namespace handrail {

struct SurfaceSolid {
    const ConvexSolid* shape = nullptr;
    // Only solids of the same group cover each other. For example, a door that may move away must not cover a part of
    // the wall.
    std::uint32_t group = 0;
    bool covers = true;  // false for liquids: other solids can cover them, but they cover nothing
    // If two faces coincide and have the same direction, the face with the higher rank is kept; if ranks are equal, the
    // one farther out, then the larger one.
    int rank = 0;
};

// A convex part of a face that no solid covers. It runs counter-clockwise seen from outside, like the face.
struct ExposedPiece {
    std::uint32_t solid = 0;
    std::uint32_t face = 0;
    Polygon polygon;
};

// Returns every exposed part of every face, ordered by solid and face. A face without any part is wholly covered. If
// two faces in one plane have the same direction, one of them keeps the common part, regardless of the order of the
// solids. If they have opposite directions, both faces lose the common part. After a stop request the result is
// incomplete and must not be used.
std::vector<ExposedPiece> exposed_surface(std::span<const SurfaceSolid> solids, const BoxIndex& index,
                                          const CutTolerance& tolerance, const std::stop_token& stop = {});

// A flat polygon that may continue in neighbouring polygons.
struct FlatPiece {
    const Polygon* polygon = nullptr;
    Plane plane;
    std::uint64_t look = 0;  // appearance of the piece; only pieces with equal `look` are joined
    std::uint64_t face = 0;  // identifies the face; pieces of one face are joined, however the face was cut
};

// Returns for every piece the number of its surface. Surfaces are numbered from 0 in the order of their first pieces.
// Pieces are joined if they are in one plane, have the same look, and share part of an edge (T-junctions included).
// Edges touch if they are at most `gap_m` apart.
std::vector<std::uint32_t> joined_surfaces(std::span<const FlatPiece> pieces, double gap_m,
                                           const std::stop_token& stop = {});

// Disjoint sets with path halving, used wherever polygons are joined into groups.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count);
    std::uint32_t find(std::uint32_t i);
    void join(std::uint32_t a, std::uint32_t b);  // the smaller index represents the joined set

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace handrail
