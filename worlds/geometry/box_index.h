// Finds which of many boxes meet a given one. Immutable after building; queries from any thread. Building O(n log n), a
// query O(log n + found).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "worlds/geometry/convex.h"

namespace handrail {

class BoxIndex {
public:
    explicit BoxIndex(std::span<const Aabb> boxes);
    ~BoxIndex();
    BoxIndex(BoxIndex&&) noexcept;
    BoxIndex& operator=(BoxIndex&&) noexcept;

    // Replaces `found` by the indices of all boxes that meet `box`, borders included, in rising order.
    void find(const Aabb& box, std::vector<std::uint32_t>& found) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace handrail
