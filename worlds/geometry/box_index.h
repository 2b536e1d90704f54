// Defines a hierarchy over boxes in double precision. It finds the boxes that overlap a given box, and the boxes that a
// straight line may enter before it hits something. After construction the hierarchy is only read, from any thread.
// Building costs O(n log n), a query O(log n + found). Bvh, which the haptic tick uses instead, answers queries about
// points in single precision.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "worlds/geometry/convex.h"

namespace handrail {

class BoxIndex {
public:
    struct Node {
        Aabb box;
        // For a leaf: index into items(). For an inner node: the first of its two adjacent children.
        std::uint32_t first = 0;
        std::uint32_t items = 0;  // number of items in a leaf; 0: the node is an inner node
    };

    BoxIndex() = default;
    // Builds the hierarchy. Queries never find an empty box.
    explicit BoxIndex(std::span<const Aabb> boxes);

    bool empty() const noexcept { return nodes_.empty(); }
    // Returns all nodes; node 0 is the root.
    const std::vector<Node>& nodes() const noexcept { return nodes_; }
    const std::vector<std::uint32_t>& items() const noexcept { return items_; }

    // Replaces `found` with the indices of all boxes that overlap or touch `box`, in rising order.
    void find(const Aabb& box, std::vector<std::uint32_t>& found) const;

    // Calls visit(item) for every item whose box overlaps or touches `box`, in the order of the hierarchy.
    template <class Visit>
    void meeting(const Aabb& box, Visit&& visit) const {
        std::array<std::uint32_t, kMostDepth> stack;
        std::size_t depth = 0;
        if (!nodes_.empty()) stack[depth++] = 0;
        while (depth > 0) {
            const Node& node = nodes_[stack[--depth]];
            if (!meets(node.box, box)) continue;
            for (std::uint32_t i = node.first; i < node.first + node.items; ++i)
                if (meets(boxes_[i], box)) visit(items_[i]);
            if (node.items > 0) continue;
            stack[depth++] = node.first + 1;
            stack[depth++] = node.first;
        }
    }

    // Follows the line from + (to - from) t, for t from 0 to `reach`. `reach` begins at 1, and visit may lower it. Each
    // item's box is first enlarged along every axis by low_m in the negative and high_m in the positive direction.
    // Calls visit(item, reach) for every item whose enlarged box the line enters, roughly in order of distance.
    template <class Visit>
    void along(const Vec3& from_m, const Vec3& to_m, const Vec3& low_m, const Vec3& high_m, Visit&& visit) const {
        const Vec3 way = to_m - from_m;
        double reach = 1.0;
        // Returns the t at which the line enters a box, or more than 1 if the line does not enter it.
        const auto enters = [&](const Aabb& box) {
            double in = 0.0, out = reach;
            for (int axis = 0; axis < 3; ++axis) {
                const double low = box.min_m[axis] - low_m[axis] - from_m[axis],
                             high = box.max_m[axis] + high_m[axis] - from_m[axis];
                if (way[axis] == 0.0) {
                    if (low > 0.0 || high < 0.0) return kMissed;
                    continue;
                }
                const double a = low / way[axis], b = high / way[axis];
                in = std::max(in, std::min(a, b));
                out = std::min(out, std::max(a, b));
            }
            return in <= out ? in : kMissed;
        };
        std::array<std::pair<double, std::uint32_t>, kMostDepth> stack;
        std::size_t depth = 0;
        if (!nodes_.empty()) stack[depth++] = {enters(nodes_[0].box), 0};
        while (depth > 0) {
            const auto [in, which] = stack[--depth];
            if (in > reach) continue;
            const Node& node = nodes_[which];
            for (std::uint32_t i = 0; i < node.items; ++i) visit(items_[node.first + i], reach);
            if (node.items > 0) continue;
            std::pair<double, std::uint32_t> near{enters(nodes_[node.first].box), node.first},
                far{enters(nodes_[node.first + 1].box), node.first + 1};
            if (near.first > far.first) std::swap(near, far);
            if (far.first <= reach) stack[depth++] = far;
            if (near.first <= reach) stack[depth++] = near;
        }
    }

    static bool meets(const Aabb& a, const Aabb& b) noexcept {
        return a.min_m.x <= b.max_m.x && b.min_m.x <= a.max_m.x && a.min_m.y <= b.max_m.y && b.min_m.y <= a.max_m.y &&
               a.min_m.z <= b.max_m.z && b.min_m.z <= a.max_m.z;
    }

private:
    // Splitting halves the number of items, so 2^32 items need only 32 levels.
    static constexpr std::size_t kMostDepth = 80;
    static constexpr double kMissed = 2.0;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_;
    std::vector<Aabb> boxes_;  // boxes of the items, in the order of items_
};

}  // namespace handrail
