// Implements the broad phase that all rival renderers share, so that none is at a disadvantage without one. Nearby
// gathers the obstacles near a place from the scene's own hierarchy, nearest first. It keeps them until the place has
// moved by the margin. As in Handrail's renderer, the margin shrinks where obstacles are dense.
#pragma once

#include <algorithm>
#include <vector>

#include "tests/bench/compare/bench_world.h"
#include "tests/support/names.h"

namespace handrail::bench {

class Nearby {
public:
    // Greatest margin, which Handrail's renderer uses too, and least margin.
    static constexpr double kMargin_m = 0.02, kLeastMargin_m = 0.5e-3;
    // Number of obstacles above which the margin shrinks, as in Handrail's renderer.
    static constexpr std::size_t kComfortable = 48;

    explicit Nearby(const HapticScene& scene) : scene_(scene) {}

    // Calls visit(obstacle) for all obstacles within `reach_m` of a place, and for some that are farther away. The
    // place is in scene coordinates.
    template <class Visit>
    void within(const Vec3& at, double reach_m, Visit&& visit) {
        double moved = glm::length(at - centre_);
        if (!(moved + reach_m <= known_m_)) {
            gather(at, reach_m + margin_m_);
            moved = 0.0;
            if (near_.size() > kComfortable) margin_m_ = std::max(kLeastMargin_m, 0.5 * margin_m_);
            if (near_.size() < kComfortable / 3) margin_m_ = std::min(kMargin_m, 2.0 * margin_m_);
        }
        for (const Near& near : near_) {
            if (near.distance_m > moved + reach_m) break;
            visit(near.obstacle);
        }
    }

private:
    struct Near {
        std::uint32_t obstacle;
        double distance_m;
    };

    void gather(const Vec3& at, double reach_m) {
        near_.clear();
        scene_.obstacle_bvh.within(at, reach_m, [&](std::uint32_t item, double&) {
            const double distance_m = scene_.closest(item, at).distance_m;
            if (distance_m <= reach_m) near_.push_back({item, distance_m});
        });
        std::sort(near_.begin(), near_.end(), [](const Near& a, const Near& b) {
            return a.distance_m != b.distance_m ? a.distance_m < b.distance_m : a.obstacle < b.obstacle;
        });
        centre_ = at;
        known_m_ = reach_m;
    }

    const HapticScene& scene_;
    std::vector<Near> near_;
    Vec3 centre_{0.0};
    double known_m_ = -1.0;
    double margin_m_ = kMargin_m;
};

}  // namespace handrail::bench
