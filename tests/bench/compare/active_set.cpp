// Implements a god-object with an active set and exact time of impact. The planes of all obstacles that the proxy
// touches form a quadratic programme. The programme's active set, at most three planes with non-negative multipliers,
// gives the next sub-goal. The proxy is swept towards the sub-goal until it touches another obstacle, and the step
// repeats. Sources: the god-object of Zilles and Salisbury (A constraint-based god-object method for haptic display,
// IROS 1995), the finite ball of Ruspini et al. (1997), and the contact-set solution of Ortega, Redon and Coquillart (A
// six degree-of-freedom god-object method, 2006), here for three degrees of freedom.
#include "tests/bench/compare/contestant.h"
#include "tests/bench/compare/nearby.h"
#include "tests/bench/compare/swept.h"
#include "tests/support/names.h"
#include "worlds/geometry/half_space_projection.h"

namespace handrail::bench {
namespace {

class ActiveSet {
public:
    ActiveSet(const BenchWorld& world, double most_rounds)
        : scene_(*world.scene),
          radius_m_(world.radius_m),
          most_rounds_(static_cast<int>(most_rounds)),
          nearby_(scene_) {}

    TickOutcome tick(const Vec3& goal_m) {
        constexpr double kArrived_m = 1e-9;
        const Vec3 goal = goal_m - scene_.origin_m;
        if (!placed_) {
            proxy_ = goal;
            placed_ = true;
        }
        bool touched = false;
        int rounds = 0;
        while (rounds < most_rounds_) {
            ++rounds;
            walls_.clear();
            nearby_.within(proxy_, radius_m_ + kTouched_m, [&](std::uint32_t obstacle) {
                const ClosestPoint closest = scene_.closest(obstacle, proxy_);
                if (closest.distance_m - radius_m_ > kTouched_m) return;
                // The plane is relative to the proxy's centre and offset by the skin.
                walls_.push_back({closest.normal, kSkin_m - (closest.distance_m - radius_m_)});
            });
            touched = touched || !walls_.empty();
            ProjectionBasis basis;
            const bool solved = project_on_half_spaces(
                goal - proxy_, static_cast<int>(walls_.size()),
                [this](int i) { return walls_[static_cast<std::size_t>(i)]; }, basis);
            const Vec3 way = basis.point_m;
            if (!solved || glm::dot(way, way) < kArrived_m * kArrived_m) break;
            double first = kNoHit;
            nearby_.within(proxy_, glm::length(way) + radius_m_, [&](std::uint32_t obstacle) {
                Vec3 normal(0.0);
                first = std::min(first, time_of_impact(scene_, obstacle, proxy_, way, radius_m_, normal));
            });
            proxy_ += way * std::min(first, 1.0);
            if (first > 1.0 && walls_.empty()) break;
        }
        return {!touched && proxy_ == goal ? goal_m : scene_.origin_m + proxy_, rounds};
    }

private:
    const HapticScene& scene_;
    double radius_m_;
    int most_rounds_;
    Nearby nearby_;
    std::vector<HalfSpace> walls_;
    Vec3 proxy_{0.0};
    bool placed_ = false;
};

}  // namespace

Contestant active_set(int most_rounds) {
    if (most_rounds == 64) return contestant<ActiveSet>("active_set", "Active-set god-object", "rounds", 64);
    return contestant<ActiveSet>(fmt::format("active_set_{}", most_rounds),
                                 fmt::format("Active-set god-object, at most {} rounds", most_rounds), "rounds",
                                 most_rounds);
}

}  // namespace handrail::bench
