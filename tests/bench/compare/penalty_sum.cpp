// Implements a penalty method without memory. Each object pushes the hand out along its deepest contact with K times
// the depth, and the forces of all objects are added. The program from which Handrail was developed used this method,
// and so have many others since. Each solid is an object; triangles that share corners form one object.
#include <map>
#include <numeric>
#include <tuple>

#include "tests/bench/compare/contestant.h"
#include "tests/bench/compare/nearby.h"
#include "tests/support/names.h"

namespace handrail::bench {
namespace {

// Groups obstacles into objects. Triangles with a common corner belong to the same object.
std::vector<std::uint32_t> objects_of(const BenchWorld& world) {
    std::vector<std::uint32_t> object(world.scene->obstacles.size());
    std::iota(object.begin(), object.end(), 0U);
    const auto root = [&](std::uint32_t i) {
        while (object[i] != i) i = object[i] = object[object[i]];
        return i;
    };
    std::map<std::tuple<long double, long double, long double>, std::uint32_t> first_at;
    for (std::uint32_t i = 0; i < object.size(); ++i) {
        const test::BruteForce::Thing* t = world.thing(i);
        if (world.sphere_radius_m > 0.0) {
            object[i] = 0;
            continue;
        }
        if (!t || t->solid || world.scene->obstacles[i].kind != ObstacleKind::Triangle) continue;
        for (const test::LVec& corner : {t->a, t->b, t->c}) {
            const auto [found, is_new] = first_at.try_emplace({corner.x, corner.y, corner.z}, i);
            if (!is_new) object[root(i)] = root(found->second);
        }
    }
    for (std::uint32_t i = 0; i < object.size(); ++i) object[i] = root(i);
    return object;
}

class PenaltySum {
public:
    PenaltySum(const BenchWorld& world, double)
        : scene_(*world.scene), radius_m_(world.radius_m), object_(objects_of(world)), nearby_(scene_) {}

    TickOutcome tick(const Vec3& goal_m) {
        const Vec3 at = goal_m - scene_.origin_m;
        contacts_.clear();
        nearby_.within(at, radius_m_, [&](std::uint32_t obstacle) {
            const ClosestPoint closest = scene_.closest(obstacle, at);
            const double depth_m = radius_m_ - closest.distance_m;
            if (depth_m <= 0.0) return;
            for (Contact& known : contacts_)
                if (known.object == object_[obstacle]) {
                    if (depth_m > known.depth_m) known = {known.object, depth_m, closest.normal};
                    return;
                }
            contacts_.push_back({object_[obstacle], depth_m, closest.normal});
        });
        Vec3 out(0.0);
        for (const Contact& contact : contacts_) out += contact.normal * contact.depth_m;
        return {goal_m + out, 1};
    }

private:
    struct Contact {
        std::uint32_t object;
        double depth_m;
        Vec3 normal;
    };
    const HapticScene& scene_;
    double radius_m_;
    std::vector<std::uint32_t> object_;
    Nearby nearby_;
    std::vector<Contact> contacts_;
};

}  // namespace

Contestant penalty_sum() { return contestant<PenaltySum>("penalty_sum", "Penalty, objects summed", "", 0.0, false); }

}  // namespace handrail::bench
