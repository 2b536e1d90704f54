// Defines a hierarchy of bounding boxes that finds which things are near a point. It is built once off the real-time
// path and then only read; queries neither allocate nor throw. Each node has four children, each of them another node
// or one item. The children's boxes are in single precision, relative to the middle of all items, rounded outwards, and
// tested together. Memory: about 40 bytes per item. Building: about 0.3 us per item. Sources: Wald, On fast
// construction of SAH-based bounding volume hierarchies, 2007 (binning); Hjaltason & Samet, Distance browsing in
// spatial databases, 1999 (nearest first).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "worlds/geometry/closest_point.h"
#include "worlds/geometry/convex.h"

namespace handrail {

class Bvh {
    struct Place {
        float distance2;
        std::uint32_t what;  // index of a node, or of an item if the bit kItem is set
    };

public:
    // Memory for the nodes and items that nearest_first() has yet to visit. Make a Queue off the real-time path. Its
    // size is the greatest `looks` that a call will pass.
    class Queue {
    public:
        explicit Queue(std::size_t most_looks) : places_(3 * most_looks + 4) {}

    private:
        friend class Bvh;
        std::vector<Place> places_;
    };

    Bvh() = default;
    // Builds the hierarchy; item i has bounds[i]. Allows at most 2^31 items and coordinates up to 1e9 m. Queries never
    // find an empty box.
    explicit Bvh(std::span<const Aabb> bounds);

    bool empty() const noexcept { return nodes_.empty(); }
    // Returns the box around all items; it is empty if there are none.
    Aabb bounds() const noexcept { return bounds_; }
    std::size_t bytes() const noexcept { return nodes_.capacity() * sizeof(Node); }

    // Calls visit(item, reach_m) for every item whose box is within reach_m of the point, and for some items slightly
    // farther away. visit may lower reach_m but must not raise it. The cost grows with the number of items nearby, so
    // use this in a tick only if there are few.
    template <class Visit>
    void within(const Vec3& point_m, double reach_m, Visit&& visit) const noexcept {
        if (nodes_.empty() || !(distance_squared(bounds_, point_m) <= reach_m * reach_m)) return;
        const Query query(point_m - middle_m_);
        std::array<Place, 3 * kMostDepth + 4> stack;
        std::size_t depth = 0;
        stack[depth++] = {0.0F, 0};
        float reach2 = query.squared(reach_m);
        while (depth > 0) {
            const Place place = stack[--depth];
            if (!(place.distance2 <= reach2)) continue;
            if (place.what & kItem) {
                visit(place.what & ~kItem, reach_m);
                reach2 = query.squared(reach_m);
                continue;
            }
            std::array<Place, 4> near;
            const std::size_t count = near_children(nodes_[place.what], query, reach2, near);
            for (std::size_t i = count; i-- > 0;) stack[depth++] = near[i];
        }
    }

    // Like within(), but visits boxes by rising distance and tests at most `looks` nodes and items. It lowers `looks`
    // by one for each test; the queue must have been made for at least `looks` entries. Returns the distance up to
    // which the search is complete: every item whose box is nearer was visited. If `looks` was enough, this distance is
    // the last reach_m.
    template <class Visit>
    double nearest_first(const Vec3& point_m, double reach_m, int& looks, Queue& queue, Visit&& visit) const noexcept {
        if (nodes_.empty() || !(distance_squared(bounds_, point_m) <= reach_m * reach_m)) return reach_m;
        const Query query(point_m - middle_m_);
        Place* const first = queue.places_.data();
        Place* last = first;
        const auto farther = [](const Place& a, const Place& b) { return a.distance2 > b.distance2; };
        Place place{0.0F, 0};
        float reach2 = query.squared(reach_m);
        while (place.distance2 <= reach2) {
            if (looks <= 0) return std::min(reach_m, query.at_least(place.distance2));
            --looks;
            std::array<Place, 4> near;
            const std::size_t count = near_children(nodes_[place.what], query, reach2, near);
            std::size_t nodes = 0;
            for (std::size_t i = 0; i < count; ++i) {
                if (near[i].what & kItem) {
                    if (!(near[i].distance2 <= reach2)) break;
                    if (looks <= 0) return std::min(reach_m, query.at_least(place.distance2));
                    --looks;
                    visit(near[i].what & ~kItem, reach_m);
                    reach2 = query.squared(reach_m);
                } else {
                    near[nodes++] = near[i];
                }
            }
            if (nodes > 0) {
                for (std::size_t i = 1; i < nodes; ++i) {
                    *last++ = near[i];
                    std::push_heap(first, last, farther);
                }
                place = near[0];
                if (last == first || place.distance2 <= first->distance2) continue;
                *last++ = place;
                std::push_heap(first, last, farther);
            }
            if (last == first) return reach_m;
            place = *first;
            std::pop_heap(first, last--, farther);
        }
        return reach_m;
    }

private:
    static constexpr std::size_t kMostDepth = 64;
    static constexpr std::uint32_t kItem = 0x80000000U;
    using Four = float __attribute__((vector_size(16)));

    // A node has 112 bytes. The box of a missing child runs from +infinity to -infinity.
    struct Node {
        std::array<Four, 3> low, high;  // bounds of the four children, for each axis
        std::array<std::uint32_t, 4> what;
    };

    // A query point in the single precision of the boxes. Rounding changes distances by at most slack_m.
    struct Query {
        std::array<float, 3> at;
        double slack_m;

        explicit Query(const Vec3& p) noexcept
            : at{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
              slack_m((std::abs(p.x) + std::abs(p.y) + std::abs(p.z)) * 2.4e-7 + 1e-30) {}
        // Returns an upper bound, in single precision, of the squared distance of everything within reach_m. The bound
        // is always finite, so that it excludes missing children, whose distance is infinite.
        float squared(double reach_m) const noexcept {
            const double reach = std::min(reach_m + slack_m, 1e18);
            return static_cast<float>(reach * reach * 1.000002);
        }
        double at_least(float distance2) const noexcept {
            return std::max(0.0, std::sqrt(static_cast<double>(distance2)) * 0.999999 - slack_m);
        }
    };

    static Four greater(const Four& a, const Four& b) noexcept { return a > b ? a : b; }

    // Writes the children within reach into `near`, nearest first, and returns how many there are.
    static std::size_t near_children(const Node& node, const Query& query, float reach2,
                                     std::array<Place, 4>& near) noexcept {
        Four sum{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float p = query.at[axis];
            const Four out = greater(greater(node.low[axis] - p, p - node.high[axis]), Four{});
            sum += out * out;
        }
        std::size_t count = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const float distance2 = sum[i];
            if (!(distance2 <= reach2)) continue;
            std::size_t at = count++;
            for (; at > 0 && near[at - 1].distance2 > distance2; --at) near[at] = near[at - 1];
            near[at] = {distance2, node.what[i]};
        }
        return count;
    }

    struct Item;
    struct Range;
    static std::size_t split(std::span<Item> items, std::size_t depth);
    void fill(Node& node, std::size_t child, const Aabb& box) const noexcept;

    std::vector<Node> nodes_;  // children are stored after their parents
    Vec3 middle_m_{0.0};
    Aabb bounds_;
};

}  // namespace handrail
