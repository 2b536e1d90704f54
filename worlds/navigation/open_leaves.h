// Finds where walkers would overlap the leaves of open doors, over a walkable space that was made as if all doors were
// open and had no leaves. Pure function; any thread. Costs a search around each leaf, and a byte for each span while
// any door is open.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "worlds/geometry/placement.h"
#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

struct OpenLeaf {
    Aabb own_m;    // in the leaf's own frame
    Placement at;  // placement of the leaf, rotated about the vertical axis only
};

enum LeafMark : std::uint8_t {
    kNoLeaf,
    kBesideLeaf,  // a walker here has less than kLeafRoom_m to the leaf
    kInLeaf,      // a walker here would overlap the leaf
};
inline constexpr double kLeafRoom_m = 0.15;

// Returns a mark for each span of the space; empty if no leaf is near any span.
std::vector<std::uint8_t> mark_leaves(const WalkSpace& space, std::span<const OpenLeaf> leaves);

}  // namespace handrail::navigation
