// The leaves of doors where they stand open, over a walkable space in which all doors count as open and no leaf is
// anywhere: which places a body overlaps a leaf at. Pure function; any thread. Costs a look at the places round each
// leaf, and a byte for each span while any stands open.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "worlds/geometry/placement.h"
#include "worlds/navigation/walk_space.h"

namespace handrail {

struct OpenLeaf {
    Aabb own_m;    // in its own frame
    Placement at;  // where it stands, turned about the upright only
};

enum LeafMark : std::uint8_t {
    kNoLeaf,
    kBesideLeaf,  // a body has less than kLeafRoom_m beside it
    kInLeaf,      // a body here would overlap it
};
inline constexpr double kLeafRoom_m = 0.15;

// Of each span of the space; empty: no leaf is near any.
std::vector<std::uint8_t> mark_leaves(const WalkSpace& space, std::span<const OpenLeaf> leaves);

}  // namespace handrail
