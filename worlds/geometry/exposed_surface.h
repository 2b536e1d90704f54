// Finds the surface of many overlapping and touching convex solids: the parts of each face that no other solid covers,
// and which of these form one flat surface. Pure functions, loading thread. The cost grows with the number of pairs of
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
    // Only solids of the same group cover each other: a door that may move away covers no part of the wall.
    std::uint32_t group = 0;
    bool covers = true;  // false for liquids: they can be covered, but cover nothing
    // Of two coinciding faces that look the same way, the one with the higher rank stays, then the larger.
    int rank = 0;
};

// A convex part of a face that nothing covers. Counter-clockwise seen from outside, like the face.
struct ExposedPiece {
    std::uint32_t solid = 0;
    std::uint32_t face = 0;
    Polygon polygon;
};

// Returns every exposed part of every face, by rising solid and face. A face without any part is wholly covered. If two
// faces in one plane look the same way, one of them keeps the common part, whatever the order of the solids. If they
// look at each other, both lose it. If stopped, it returns an incomplete result that must not be used.
std::vector<ExposedPiece> exposed_surface(std::span<const SurfaceSolid> solids, const BoxIndex& index,
                                          const CutTolerance& tolerance, const std::stop_token& stop = {});

// A flat polygon that may continue in its neighbours.
struct FlatPiece {
    const Polygon* polygon = nullptr;
    Plane plane;
    std::uint64_t look = 0;  // only pieces that look the same are joined
    std::uint64_t face = 0;  // pieces of one face belong together, however they were cut apart
};

// Returns for every piece the number of its surface, counted from 0 in the order of first pieces. Pieces are joined if
// they are in one plane, look alike, and share part of an edge (T-junctions included). `gap_m` is how far apart
// touching edges may be.
std::vector<std::uint32_t> joined_surfaces(std::span<const FlatPiece> pieces, double gap_m,
                                           const std::stop_token& stop = {});

// Disjoint sets with path halving; a small helper for everything here that is joined.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count);
    std::uint32_t find(std::uint32_t i);
    void join(std::uint32_t a, std::uint32_t b);  // the smaller index stays the representative

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace handrail
