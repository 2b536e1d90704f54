#include "tests/support/reference_proxy.h"
#include "tests/support/names.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace handrail::test {
namespace {

constexpr long double kStep_m = 2e-5L;
constexpr long double kAtRest_m = 1e-13L;
constexpr long double kLook_m = 0.01L;
constexpr int kMostSteps = 200000;  // greatest number of steps for one goal, which corresponds to a path of 4 m

}  // namespace

double judging_work(const BruteForce::Thing& thing) {
    const double n = static_cast<double>(thing.planes.size());
    return 8.0 + n * n + n * n * n * n / 24.0;
}

// Examines all things, but only once per centimetre of movement. Keeps those that the proxy can meet before the next
// time.
void ReferenceProxy::look_around() {
    if (looked_ && glm::length(proxy_ - looked_from_) <= kLook_m) return;
    looked_ = true;
    looked_from_ = proxy_;
    near_.clear();
    for (const BruteForce::Thing& thing : judge_.things())
        if (glm::length(proxy_ - thing.centre) - thing.reach - radius_ <= 2.0L * kLook_m) near_.push_back(&thing);
    work_ += static_cast<double>(judge_.things().size());
}

Vec3 ReferenceProxy::follow(const Vec3& goal_m) {
    const LVec goal(goal_m);
    std::vector<LHalfSpace> walls;
    for (int i = 0; i < kMostSteps; ++i) {
        ++steps_;
        const long double left = glm::length(goal - proxy_);
        if (left == 0.0L) break;
        // Collects the obstacles that the proxy can meet within a step. If there are none, the step may be as long as
        // the distance to the nearest obstacle.
        look_around();
        walls.clear();
        long double clear = std::min(left, kLook_m);
        for (const BruteForce::Thing* near : near_) {
            const BruteForce::Thing& thing = *near;
            const long double far = glm::length(proxy_ - thing.centre) - thing.reach - radius_;
            if (far > kStep_m) {
                clear = std::min(clear, far);
                continue;
            }
            const Nearest n = judge_.nearest(thing, proxy_);
            work_ += judging_work(thing);
            const long double gap = n.distance - radius_;
            clear = std::min(clear, gap);
            if (gap > kStep_m || n.distance <= 0.0L) continue;
            const LVec normal = (proxy_ - n.point) / n.distance;
            const LHalfSpace wall{normal, -gap};  // the half-space is relative to the proxy
            const auto known = std::find_if(walls.begin(), walls.end(), [&](const LHalfSpace& w) {
                return glm::dot(w.normal, wall.normal) > 1.0L - 1e-17L;
            });
            if (known == walls.end()) walls.push_back(wall);
            else known->offset = std::max(known->offset, wall.offset);
        }
        const double count = static_cast<double>(walls.size());
        work_ += count * count * count * count / 24.0 + static_cast<double>(near_.size());
        if (walls.empty()) {
            proxy_ += (goal - proxy_) * (clear < left ? clear / left : 1.0L);
            continue;
        }
        const std::optional<LVec> way = project_by_enumeration(walls, goal - proxy_, 1e-15L);
        if (!way) break;
        const long double length = glm::length(*way);
        if (length < kAtRest_m) break;
        proxy_ += *way * std::min(1.0L, kStep_m / length);
    }
    return Vec3(proxy_);
}

}  // namespace handrail::test
