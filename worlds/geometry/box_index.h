// A hierarchy over boxes in double precision. It finds the boxes that meet a given box, and those that a straight line
// may enter before it hits something. Built once, then only read, from any thread. Building costs O(n log n), a query
// O(log n + found). Bvh, which the haptic tick queries, works on points and in single precision.
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
        std::uint32_t first = 0;  // index into items(), or the first of two adjacent child nodes
        std::uint32_t items = 0;  // number of items; 0: an inner node
    };

    BoxIndex() = default;
    // Empty boxes are never found.
    explicit BoxIndex(std::span<const Aabb> boxes);

    bool empty() const noexcept { return nodes_.empty(); }
    // Node 0 is the root.
    const std::vector<Node>& nodes() const noexcept { return nodes_; }
    const std::vector<std::uint32_t>& items() const noexcept { return items_; }

    // Replaces `found` with the indices of all boxes that meet `box`, in rising order. Boxes that only touch count.
    void find(const Aabb& box, std::vector<std::uint32_t>& found) const;

    // Calls visit(item) for every item whose box meets this one, in the order of the hierarchy.
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

    // Follows the line from + (to - from) t for t from 0 to `reach`, which is 1 at first. Each item's box is grown by
    // low_m downwards and high_m upwards along each axis. Calls visit(item, reach) for every item whose grown box the
    // line enters; visit may lower `reach`. Near items come first, roughly.
    template <class Visit>
    void along(const Vec3& from_m, const Vec3& to_m, const Vec3& low_m, const Vec3& high_m, Visit&& visit) const {
        const Vec3 way = to_m - from_m;
        double reach = 1.0;
        // Returns the t at which the line enters a box; above 1 if it does not.
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
    static constexpr std::size_t kMostDepth = 80;  // boxes are halved, so 2^32 items need 32 levels
    static constexpr double kMissed = 2.0;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_;
    std::vector<Aabb> boxes_;  // in the order of items_
};

}  // namespace handrail
