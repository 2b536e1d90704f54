#include "worlds/geometry/box_index.h"

#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
// Boost 1.83 needs it for rtree.hpp, which does not include it; Boost 1.74 does not have it.
#if __has_include(<boost/geometry/strategies/relate/cartesian.hpp>)
#include <boost/geometry/strategies/relate/cartesian.hpp>
#endif

namespace handrail {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using IndexBox = bg::model::box<Point>;
using Entry = std::pair<IndexBox, std::uint32_t>;

IndexBox box_of(const Aabb& box) {
    return {Point(box.min_m.x, box.min_m.y, box.min_m.z), Point(box.max_m.x, box.max_m.y, box.max_m.z)};
}

std::vector<Entry> entries_of(std::span<const Aabb> boxes) {
    std::vector<Entry> entries;
    entries.reserve(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (!boxes[i].empty()) entries.emplace_back(box_of(boxes[i]), i);
    return entries;
}

}  // namespace

struct BoxIndex::Tree {
    explicit Tree(const std::vector<Entry>& entries) : rtree(entries) {}
    bg::index::rtree<Entry, bg::index::linear<16>> rtree;  // built from a range: packed, whatever the insertion rule
};

BoxIndex::BoxIndex(std::span<const Aabb> boxes) : tree_(std::make_unique<Tree>(entries_of(boxes))) {}
BoxIndex::~BoxIndex() = default;
BoxIndex::BoxIndex(BoxIndex&&) noexcept = default;
BoxIndex& BoxIndex::operator=(BoxIndex&&) noexcept = default;

void BoxIndex::find(const Aabb& box, std::vector<std::uint32_t>& found) const {
    found.clear();
    if (box.empty()) return;
    tree_->rtree.query(
        bg::index::intersects(box_of(box)),
        boost::make_function_output_iterator([&](const Entry& entry) { found.push_back(entry.second); }));
    std::sort(found.begin(), found.end());
}

}  // namespace handrail
