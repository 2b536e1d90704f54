#include "worlds/geometry/bvh.h"

namespace handrail {
namespace {

constexpr int kBins = 16;
// A range of at most this many items is cut into parts of four items, which fills the lowest nodes.
constexpr std::size_t kFewItems = 16;
// From this depth on, split() halves the number of items, so that 2^31 items end within 64 levels.
constexpr std::size_t kDepthOfPlainHalving = 32;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// rounded_down() and rounded_up() convert to single precision. The result is never above, or never below, `v`.
float rounded_down(double v) noexcept {
    const float f = static_cast<float>(v);
    return f - (std::abs(f) * 1.2e-7F + 1e-37F);
}
float rounded_up(double v) noexcept { return -rounded_down(-v); }

}  // namespace

// The bounds of one item during building. The fourth components of `low` and `high` store the item's number in two
// halves, which are exact in single precision.
struct Bvh::Item {
    Four low, high;

    std::uint32_t number() const noexcept {
        return static_cast<std::uint32_t>(low[3]) | static_cast<std::uint32_t>(high[3]) << 16;
    }
    // Returns twice the centre of the box along an axis.
    float middle(int axis) const noexcept { return low[axis] + high[axis]; }
};

struct Bvh::Range {
    std::uint32_t first = 0, count = 0;
    float area = 0.0F;
};

namespace {

template <class Four>
struct Box {
    Four low{kInfinity, kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity, -kInfinity};

    void include(const Four& l, const Four& h) noexcept {
        low = l < low ? l : low;
        high = h > high ? h : high;
    }
    float half_area() const noexcept {
        const Four s = high - low;
        return s[0] >= 0.0F ? s[0] * s[1] + s[1] * s[2] + s[2] * s[0] : 0.0F;
    }
};

}  // namespace

// Splits more than four items. Reorders them so that the items of the first part come first, and returns the size of
// the first part.
std::size_t Bvh::split(std::span<Item> items, std::size_t depth) {
    using FloatBox = Box<Four>;
    FloatBox middles;
    for (const Item& item : items) {
        const Four middle = item.low + item.high;
        middles.include(middle, middle);
    }
    const Four spread = middles.high - middles.low;
    const int axis = spread[0] >= spread[1] && spread[0] >= spread[2] ? 0 : spread[1] >= spread[2] ? 1 : 2;
    const auto before = [](int a) {
        return [a](const Item& x, const Item& y) {
            return x.middle(a) != y.middle(a) ? x.middle(a) < y.middle(a) : x.number() < y.number();
        };
    };
    if (items.size() <= kFewItems) {
        float best_cost = kInfinity;
        int best_axis = axis;
        std::size_t best = 4;
        for (int a = 0; a < 3; ++a) {
            if (!(spread[a] > 0.0F)) continue;
            std::sort(items.begin(), items.end(), before(a));
            std::array<float, kFewItems> right_cost{};
            FloatBox swept;
            for (std::size_t i = items.size(); i-- > 4;) {
                swept.include(items[i].low, items[i].high);
                right_cost[i] = swept.half_area() * static_cast<float>(items.size() - i);
            }
            swept = {};
            for (std::size_t i = 0; i + 1 < items.size(); ++i) {
                swept.include(items[i].low, items[i].high);
                if ((i + 1) % 4 != 0) continue;
                const float cost = swept.half_area() * static_cast<float>(i + 1) + right_cost[i + 1];
                if (cost < best_cost) {
                    best_cost = cost;
                    best_axis = a;
                    best = i + 1;
                }
            }
        }
        std::sort(items.begin(), items.end(), before(best_axis));
        return best;
    }
    if (spread[axis] > 0.0F && depth < kDepthOfPlainHalving) {
        struct Bin {
            FloatBox box;
            std::size_t count = 0;
        };
        std::array<Bin, kBins> bins;
        const float low = middles.low[axis], scale = static_cast<float>(kBins) / spread[axis];
        const auto bin_of = [&](const Item& item) {
            return std::clamp(static_cast<int>((item.middle(axis) - low) * scale), 0, kBins - 1);
        };
        for (const Item& item : items) {
            Bin& bin = bins[static_cast<std::size_t>(bin_of(item))];
            bin.box.include(item.low, item.high);
            ++bin.count;
        }
        std::array<float, kBins> right_cost{};
        FloatBox swept;
        std::size_t counted = 0;
        for (std::size_t b = kBins - 1; b > 0; --b) {
            swept.include(bins[b].box.low, bins[b].box.high);
            counted += bins[b].count;
            right_cost[b] = swept.half_area() * static_cast<float>(counted);
        }
        swept = {};
        counted = 0;
        float best_cost = kInfinity;
        int best = -1;
        for (std::size_t b = 0; b + 1 < kBins; ++b) {
            swept.include(bins[b].box.low, bins[b].box.high);
            counted += bins[b].count;
            const float cost = swept.half_area() * static_cast<float>(counted) + right_cost[b + 1];
            if (counted > 0 && counted < items.size() && cost < best_cost) {
                best_cost = cost;
                best = static_cast<int>(b);
            }
        }
        if (best >= 0) {
            const auto middle =
                std::partition(items.begin(), items.end(), [&](const Item& item) { return bin_of(item) <= best; });
            return static_cast<std::size_t>(middle - items.begin());
        }
    }
    const auto half = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
    std::nth_element(items.begin(), half, items.end(), before(axis));
    return items.size() / 2;
}

void Bvh::fill(Node& node, std::size_t child, const Aabb& box) const noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int a = static_cast<int>(axis);
        node.low[axis][child] = box.empty() ? kInfinity : rounded_down(box.min_m[a] - middle_m_[a]);
        node.high[axis][child] = box.empty() ? -kInfinity : rounded_up(box.max_m[a] - middle_m_[a]);
    }
}

Bvh::Bvh(std::span<const Aabb> bounds) {
    for (const Aabb& box : bounds) bounds_.include(box);
    if (bounds_.empty()) return;
    middle_m_ = bounds_.centre_m();
    std::vector<Item> items;
    items.reserve(bounds.size());
    for (std::uint32_t i = 0; i < bounds.size(); ++i) {
        if (bounds[i].empty()) continue;
        Item& item = items.emplace_back();
        for (int axis = 0; axis < 3; ++axis) {
            item.low[axis] = rounded_down(bounds[i].min_m[axis] - middle_m_[axis]);
            item.high[axis] = rounded_up(bounds[i].max_m[axis] - middle_m_[axis]);
        }
        item.low[3] = static_cast<float>(i & 0xFFFF);
        item.high[3] = static_cast<float>(i >> 16);
    }
    const std::span<Item> all(items);
    const auto part = [&](const Range& r) { return all.subspan(r.first, r.count); };
    const auto range_of = [&](std::uint32_t first, std::uint32_t count) {
        Box<Four> box;
        for (const Item& item : all.subspan(first, count)) box.include(item.low, item.high);
        return Range{first, count, box.half_area()};
    };
    struct Task {
        Range range;
        std::uint32_t parent, child;
        std::size_t depth;
    };
    nodes_.reserve(items.size() / 2 + 1);
    std::vector<Task> tasks{{range_of(0, static_cast<std::uint32_t>(items.size())), 0, 0, 0}};
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        std::array<Range, 4> ranges{task.range};
        std::size_t count = 1;
        // Splits the range with the largest area until there are four ranges. A range of up to four items is not split;
        // it becomes a node itself.
        while (count < 4) {
            std::size_t largest = count;
            for (std::size_t i = 0; i < count; ++i)
                if (ranges[i].count > 4 && (largest == count || ranges[i].area > ranges[largest].area)) largest = i;
            if (largest == count) break;
            const Range range = ranges[largest];
            const auto left = static_cast<std::uint32_t>(split(part(range), task.depth));
            ranges[largest] = range_of(range.first, left);
            ranges[count++] = range_of(range.first + left, range.count - left);
        }
        // If the items of a range fit into this node directly, they need no child node.
        for (bool more = true; more;) {
            more = false;
            for (std::size_t i = 0; i < count; ++i) {
                const Range range = ranges[i];
                if (range.count < 2 || count + range.count - 1 > 4) continue;
                ranges[i] = {range.first, 1, 0.0F};
                for (std::uint32_t k = 1; k < range.count; ++k) ranges[count++] = {range.first + k, 1, 0.0F};
                more = true;
            }
        }
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        if (index > 0) nodes_[task.parent].what[task.child] = index;
        Node& node = nodes_.emplace_back();
        for (std::uint32_t i = 0; i < 4; ++i) {
            Box<Four> box;
            node.what[i] = 0;
            if (i < count) {
                for (const Item& item : part(ranges[i])) box.include(item.low, item.high);
                if (ranges[i].count == 1) node.what[i] = kItem | all[ranges[i].first].number();
                else tasks.push_back({ranges[i], index, i, task.depth + 1});
            }
            for (std::size_t axis = 0; axis < 3; ++axis) {
                node.low[axis][i] = box.low[axis];
                node.high[axis][i] = box.high[axis];
            }
        }
    }
    nodes_.shrink_to_fit();
}

}  // namespace handrail
