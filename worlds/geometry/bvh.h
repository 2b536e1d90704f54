// A hierarchy of boxes over boxes: which things are near a point. Built once off the real-time path, then only read; queries neither allocate
// nor throw. 64 bytes per node, about one node per two items. Binned surface-area heuristic (Wald 2007): 1 us per item to build.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "worlds/geometry/closest_point.h"
#include "worlds/geometry/convex.h"

namespace handrail {

class Bvh {
public:
    Bvh() = default;
    // Item i has bounds[i]. Empty boxes are allowed and never found.
    explicit Bvh(std::span<const Aabb> bounds);

    bool empty() const noexcept { return nodes_.empty(); }
    // The box around everything; empty when there is nothing.
    Aabb bounds() const noexcept { return nodes_.empty() ? Aabb{} : nodes_[0].box; }

    // Calls visit(item, reach_m) for every item whose box lies within reach_m of the point; visit may lower reach_m (never raise it).
    template <class Visit>
    void within(const Vec3& point_m, double reach_m, Visit&& visit) const noexcept {
        if (nodes_.empty()) return;
        std::array<Entry, kMaxDepth + 1> stack;
        std::size_t depth = 0;
        stack[depth++] = {0, distance_squared(nodes_[0].box, point_m)};
        while (depth > 0) {
            const Entry entry = stack[--depth];
            if (!(entry.distance2 <= reach_m * reach_m)) continue;
            const Node& node = nodes_[entry.node];
            if (node.count > 0) {
                for (std::uint32_t i = 0; i < node.count; ++i) visit(items_[node.first + i], reach_m);
                continue;
            }
            const Entry left{node.first, distance_squared(nodes_[node.first].box, point_m)};
            const Entry right{node.first + 1, distance_squared(nodes_[node.first + 1].box, point_m)};
            const bool left_first = left.distance2 <= right.distance2;
            stack[depth++] = left_first ? right : left;
            stack[depth++] = left_first ? left : right;
        }
    }

private:
    static constexpr std::size_t kMaxDepth = 64;
    struct Node {
        Aabb box;
        std::uint32_t first = 0;  // of items_ for a leaf, of the two children otherwise
        std::uint32_t count = 0;  // items of a leaf; 0: inner node
    };
    struct Entry {
        std::uint32_t node;
        double distance2;
    };
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_;
};

}  // namespace handrail
