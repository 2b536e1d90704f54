#include "worlds/geometry/box_index.h"

#include <numeric>

namespace handrail {
namespace {

constexpr std::uint32_t kLeaf = 4;

}  // namespace

// Splits each node at the median item along the axis on which the centres of the boxes spread most. If two centres are
// equal, the earlier item sorts first.
BoxIndex::BoxIndex(std::span<const Aabb> boxes) {
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (!boxes[i].empty()) items_.push_back(i);
    if (items_.empty()) return;
    std::vector<Vec3> middles(boxes.size());
    for (const std::uint32_t i : items_) middles[i] = boxes[i].centre_m();
    struct Range {
        std::uint32_t node, first, count;
    };
    nodes_.emplace_back();
    std::vector<Range> open{{0, 0, static_cast<std::uint32_t>(items_.size())}};
    while (!open.empty()) {
        const Range range = open.back();
        open.pop_back();
        Aabb box, spread;
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            box.include(boxes[items_[i]]);
            spread.include(middles[items_[i]]);
        }
        nodes_[range.node].box = box;
        if (range.count <= kLeaf) {
            nodes_[range.node].first = range.first;
            nodes_[range.node].items = range.count;
            continue;
        }
        const Vec3 size = spread.size_m();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto begin = items_.begin() + range.first;
        const std::uint32_t half = range.count / 2;
        std::nth_element(begin, begin + half, begin + range.count, [&](std::uint32_t a, std::uint32_t b) {
            return middles[a][axis] != middles[b][axis] ? middles[a][axis] < middles[b][axis] : a < b;
        });
        const auto children = static_cast<std::uint32_t>(nodes_.size());
        nodes_[range.node].first = children;
        nodes_.resize(nodes_.size() + 2);
        open.push_back({children + 1, range.first + half, range.count - half});
        open.push_back({children, range.first, half});
    }
    boxes_.reserve(items_.size());
    for (const std::uint32_t i : items_) boxes_.push_back(boxes[i]);
}

void BoxIndex::find(const Aabb& box, std::vector<std::uint32_t>& found) const {
    found.clear();
    if (box.empty()) return;
    meeting(box, [&](std::uint32_t item) { found.push_back(item); });
    std::sort(found.begin(), found.end());
}

}  // namespace handrail
