// Implements sequential constraint planes. The sphere moves towards the goal until its exact first contact, and the
// plane there is added as an equality constraint. The sphere then slides along one plane, or along the line where two
// planes meet, and stops at three planes. Planes are released only between ticks. This renderer simplifies the virtual
// proxy of Ruspini, Kolarov and Khatib (The haptic display of complex graphical environments, SIGGRAPH 1997). Their
// method solves a small quadratic programme for each sub-goal, so it can release planes that press only from behind.
#include <array>

#include "tests/bench/compare/contestant.h"
#include "tests/bench/compare/nearby.h"
#include "tests/bench/compare/swept.h"
#include "tests/support/names.h"

namespace handrail::bench {
namespace {

class SequentialPlanes {
public:
    SequentialPlanes(const BenchWorld& world, double)
        : scene_(*world.scene), radius_m_(world.radius_m), nearby_(scene_) {}

    TickOutcome tick(const Vec3& goal_m) {
        const Vec3 goal = goal_m - scene_.origin_m;
        if (!placed_) {
            proxy_ = goal;
            placed_ = true;
        }
        std::array<Vec3, 3> normals;
        std::size_t planes = 0;
        Vec3 wanted = goal;
        bool touched = false;
        int rounds = 0;
        while (rounds < 64) {
            ++rounds;
            const Vec3 way = wanted - proxy_;
            if (glm::dot(way, way) < 1e-24) break;
            double first = kNoHit;
            Vec3 normal(0.0);
            nearby_.within(proxy_, glm::length(way) + radius_m_, [&](std::uint32_t obstacle) {
                Vec3 n(0.0);
                const double part = time_of_impact(scene_, obstacle, proxy_, way, radius_m_, n);
                if (part < first || (part == first && part < kNoHit && glm::dot(n, way) < glm::dot(normal, way))) {
                    first = part;
                    normal = n;
                }
            });
            if (first > 1.0) {
                proxy_ = wanted;
                break;
            }
            touched = true;
            proxy_ += way * first;
            normals[planes++] = normal;
            if (planes == 3) break;
            const Vec3 pull = goal - proxy_;
            if (planes == 1) {
                wanted = goal - normals[0] * glm::dot(pull, normals[0]);
            } else {
                const Vec3 line = glm::cross(normals[0], normals[1]);
                const double length2 = glm::dot(line, line);
                if (length2 < 1e-16) break;
                wanted = proxy_ + line * (glm::dot(pull, line) / length2);
            }
        }
        return {!touched && proxy_ == goal ? goal_m : scene_.origin_m + proxy_, rounds};
    }

private:
    const HapticScene& scene_;
    double radius_m_;
    Nearby nearby_;
    Vec3 proxy_{0.0};
    bool placed_ = false;
};

}  // namespace

Contestant sequential_planes() {
    return contestant<SequentialPlanes>("sequential_planes", "Sequential constraint planes");
}

}  // namespace handrail::bench
