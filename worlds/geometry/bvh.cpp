#include "worlds/geometry/bvh.h"

#include <algorithm>
#include <numeric>

namespace handrail {
namespace {

constexpr std::uint32_t kLeafSize = 2;
constexpr int kBins = 12;
constexpr std::size_t kDepthOfPlainHalving = 32;  // beyond it items are halved by count, so that 2^32 items end within 64 levels

double half_area(const Aabb& box) noexcept {
    if (box.empty()) return 0.0;
    const Vec3 s = box.size_m();
    return s.x * s.y + s.y * s.z + s.z * s.x;
}

}  // namespace

Bvh::Bvh(std::span<const Aabb> bounds) {
    for (std::uint32_t i = 0; i < bounds.size(); ++i)
        if (!bounds[i].empty()) items_.push_back(i);
    if (items_.empty()) return;
    nodes_.reserve(items_.size() + 1);
    struct Task {
        std::uint32_t node, first, count;
        std::size_t depth;
    };
    std::vector<Task> tasks{{0, 0, static_cast<std::uint32_t>(items_.size()), 1}};
    nodes_.emplace_back();
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        const auto begin = items_.begin() + task.first, end = begin + task.count;
        Aabb box, centres;
        for (auto it = begin; it != end; ++it) {
            box.include(bounds[*it]);
            centres.include(bounds[*it].centre_m());
        }
        nodes_[task.node].box = box;
        if (task.count <= kLeafSize) {
            nodes_[task.node].first = task.first;
            nodes_[task.node].count = task.count;
            continue;
        }
        const Vec3 spread = centres.size_m();
        const int axis = spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
        auto middle = begin + task.count / 2;
        bool split = false;
        if (spread[axis] > 0.0 && task.depth < kDepthOfPlainHalving) {
            struct Bin {
                Aabb box;
                std::size_t count = 0;
            };
            std::array<Bin, kBins> bins;
            const double scale = kBins / spread[axis];
            const auto bin_of = [&](std::uint32_t item) {
                return std::clamp(static_cast<int>((bounds[item].centre_m()[axis] - centres.min_m[axis]) * scale), 0, kBins - 1);
            };
            for (auto it = begin; it != end; ++it) {
                Bin& bin = bins[static_cast<std::size_t>(bin_of(*it))];
                bin.box.include(bounds[*it]);
                ++bin.count;
            }
            std::array<double, kBins> right_cost{};
            Aabb swept;
            std::size_t counted = 0;
            for (std::size_t b = kBins - 1; b > 0; --b) {
                swept.include(bins[b].box);
                counted += bins[b].count;
                right_cost[b] = half_area(swept) * static_cast<double>(counted);
            }
            swept = {};
            counted = 0;
            double best_cost = std::numeric_limits<double>::infinity();
            int best = 0;
            for (std::size_t b = 0; b + 1 < kBins; ++b) {
                swept.include(bins[b].box);
                counted += bins[b].count;
                const double cost = half_area(swept) * static_cast<double>(counted) + right_cost[b + 1];
                if (counted > 0 && counted < task.count && cost < best_cost) {
                    best_cost = cost;
                    best = static_cast<int>(b);
                    split = true;
                }
            }
            if (split) middle = std::stable_partition(begin, end, [&](std::uint32_t item) { return bin_of(item) <= best; });
        }
        if (!split)
            std::nth_element(begin, middle, end, [&](std::uint32_t a, std::uint32_t b) {
                const double ca = bounds[a].centre_m()[axis], cb = bounds[b].centre_m()[axis];
                return ca != cb ? ca < cb : a < b;
            });
        const auto left = static_cast<std::uint32_t>(nodes_.size());
        const auto left_count = static_cast<std::uint32_t>(middle - begin);
        nodes_[task.node].first = left;
        nodes_.emplace_back();
        nodes_.emplace_back();
        tasks.push_back({left, task.first, left_count, task.depth + 1});
        tasks.push_back({left + 1, task.first + left_count, task.count - left_count, task.depth + 1});
    }
}

}  // namespace handrail
