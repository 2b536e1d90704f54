#include "tests/bench/compare/reference.h"

#include "tests/support/reference_proxy.h"

namespace handrail::bench {

std::vector<Vec3> reference_walk(const BenchWorld& world, double most_work) {
    std::vector<Vec3> proxies;
    if (!world.judged || world.goals_m.empty() || world.judge.distance(world.goals_m.front(), 1.0L) < world.radius_m)
        return proxies;
    test::ReferenceProxy proxy(world.judge, world.goals_m.front(), world.radius_m);
    proxies.reserve(world.goals_m.size());
    for (const Vec3& goal : world.goals_m) {
        proxies.push_back(proxy.follow(goal));
        if (proxy.work() > most_work) return {};
    }
    return proxies;
}

}  // namespace handrail::bench
