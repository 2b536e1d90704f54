#include "tests/support/reference_proxy.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace handrail::test {
namespace {

constexpr long double kStep_m = 2e-5L;
constexpr long double kAtRest_m = 1e-13L;
constexpr int kMostSteps = 200000;  // for one goal: 4 m of way

}  // namespace

Vec3 ReferenceProxy::follow(const Vec3& goal_m) {
    const LVec goal(goal_m);
    std::vector<LHalfSpace> walls;
    for (int i = 0; i < kMostSteps; ++i) {
        ++steps_;
        const long double left = glm::length(goal - ball_);
        if (left == 0.0L) break;
        // What can be met within a step; where there is nothing, as far as the nearest thing allows.
        walls.clear();
        long double clear = left;
        for (const BruteForce::Thing& thing : judge_.things()) {
            const long double far = glm::length(ball_ - thing.centre) - thing.reach - radius_;
            if (far > kStep_m) {
                clear = std::min(clear, far);
                continue;
            }
            const Nearest n = judge_.nearest(thing, ball_);
            const long double gap = n.distance - radius_;
            clear = std::min(clear, gap);
            if (gap > kStep_m || n.distance <= 0.0L) continue;
            const LVec normal = (ball_ - n.point) / n.distance;
            walls.push_back({normal, -gap});  // relative to the ball
        }
        if (walls.empty()) {
            ball_ += (goal - ball_) * (clear < left ? clear / left : 1.0L);
            continue;
        }
        const std::optional<LVec> way = project_by_enumeration(walls, goal - ball_, 1e-15L);
        if (!way) break;
        const long double length = glm::length(*way);
        if (length < kAtRest_m) break;
        ball_ += *way * std::min(1.0L, kStep_m / length);
    }
    return Vec3(ball_);
}

}  // namespace handrail::test
