// Marks the spans where walkers would overlap the leaves of open doors. The walkable space itself is made as if all
// doors were open and had no leaves. Pure function; any thread may call it. It searches around each leaf, and needs a
// byte for each span while any door is open.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "worlds/geometry/placement.h"
#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

struct OpenLeaf {
    Aabb own_m;    // box of the leaf in its own coordinate frame
    Placement at;  // placement of the leaf; it is rotated about the vertical axis only
};

enum LeafMark : std::uint8_t {
    kNoLeaf,
    kNextToLeaf,  // a walker here is less than kLeafRoom_m away from the leaf
    kInLeaf,      // a walker here would overlap the leaf
};
inline constexpr double kLeafRoom_m = 0.15;

// Returns a mark for each span of the space; empty if no leaf is near any span.
std::vector<std::uint8_t> mark_leaves(const WalkSpace& space, std::span<const OpenLeaf> leaves);

}  // namespace handrail::navigation
