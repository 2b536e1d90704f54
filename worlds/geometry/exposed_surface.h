// The surface of many overlapping and touching convex solids: what of each face is not covered by another solid, and
// which of the rest belongs together as one flat surface. Pure functions, loading thread. Cost grows with the pairs of
// solids that meet: 30 ms for 1,200 brushes.
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
    // Only solids of the same group cover each other: a door that may move away covers nothing of the wall.
    std::uint32_t group = 0;
    bool covers = true;  // false for liquids: they are covered, but cover nothing
    int rank = 0;        // of two coinciding faces that look the same way the higher rank stays, then the larger
};

// A convex part of a face that nothing covers. Counter-clockwise from outside like the face.
struct ExposedPiece {
    std::uint32_t solid = 0;
    std::uint32_t face = 0;
    Polygon polygon;
};

// Every exposed part of every face, by rising solid and face. A face without any is wholly covered. Of two faces that
// lie in one plane and look the same way one keeps the common part, independent of the order of the solids; two that
// look at each other both lose it. Stopped in the middle it gives what it has by then, which is of no use.
std::vector<ExposedPiece> exposed_surface(std::span<const SurfaceSolid> solids, const BoxIndex& index,
                                          const CutTolerance& tolerance, const std::stop_token& stop = {});

// A flat polygon that may continue in its neighbours.
struct FlatPiece {
    const Polygon* polygon = nullptr;
    Plane plane;
    std::uint64_t look = 0;  // only pieces that look the same are joined
    std::uint64_t face = 0;  // pieces of one face are one, however they were cut apart
};

// For every piece the number of its surface, counted from 0 by first piece: pieces are joined when they lie in one
// plane, look alike, and share part of an edge (T-junctions included). `gap_m` is how far apart touching edges may lie.
std::vector<std::uint32_t> joined_surfaces(std::span<const FlatPiece> pieces, double gap_m,
                                           const std::stop_token& stop = {});

// Union by index with path halving; small helper for everything here that is joined.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count);
    std::uint32_t find(std::uint32_t i);
    void join(std::uint32_t a, std::uint32_t b);  // the smaller index stays the representative

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace handrail
