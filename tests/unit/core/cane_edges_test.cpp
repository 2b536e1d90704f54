// Measures how many drops the virtual cane finds in time. The truth comes from a dense grid of heights, which shares
// nothing with the cane.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <random>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/random_families.h"
#include "tests/support/scale.h"
#include "tests/support/worlds_once.h"
#include "tests/unit/features/with_cane.h"

namespace handrail {
namespace cane_edges_test {

using settings::CaneTechnique;
using test::WithCane;

constexpr std::array kTechniques{CaneTechnique::ConstantContact, CaneTechnique::TwoPoint, CaneTechnique::Shoreline};
constexpr std::array kNames{"constant contact", "two-point touch", "shoreline"};

// An edge between two places of the grid: level ground before it, and lower ground or none behind it.
struct Edge {
    Vec3 top_m{0.0};
    double across_rad = 0.0;  // direction of the fall
};
constexpr double kGrid_m = 0.1, kLeastFall_m = 0.1;

std::optional<double> ground_under(const WalkerWorld& world, double x, double y, double z) {
    const TraceHit hit = world.trace({x, y, z + 0.3}, {x, y, z - 30.0}, WalkerShape{});
    if (!hit.hit) return std::nullopt;
    return hit.end_m.z;
}

// Returns how far a person on the line walks until the ground falls. Returns no value if the ground rises or falls a
// little before, if there is no such fall within `most_m`, or if something is in the way of the body.
std::optional<double> fall_after_m(const WalkerWorld& world, const Vec3& from_m, double heading_rad, double most_m) {
    const Vec3 way = forward_of_heading(heading_rad);
    for (double at = 0.0; at <= most_m; at += 0.01) {
        const Vec3 here = from_m + way * at;
        const auto z = ground_under(world, here.x, here.y, from_m.z);
        if (!z || *z < from_m.z - kLeastFall_m) return at;
        if (std::abs(*z - from_m.z) > 0.03) return std::nullopt;
    }
    return std::nullopt;
}

std::vector<Edge> edges_of(const WalkerWorld& world, const Aabb& box) {
    std::vector<Edge> edges;
    for (double x = box.min_m.x; x < box.max_m.x; x += kGrid_m)
        for (double y = box.min_m.y; y < box.max_m.y; y += kGrid_m)
            for (double z = box.max_m.z + 1.0; z > box.min_m.z;) {
                const TraceHit hit = world.trace({x, y, z}, {x, y, box.min_m.z - 1.0}, WalkerShape{});
                if (!hit.hit) break;
                z = hit.end_m.z - 0.3;
                const Vec3 top = hit.end_m;
                if (world.blocked(top + Vec3(0.0, 0.0, 0.02), {0.02, 1.8})) continue;
                for (int side = 0; side < 4; ++side) {
                    const double across = side * 0.5 * kPi;
                    const Vec3 way = forward_of_heading(across), next = top + way * kGrid_m;
                    const auto below = ground_under(world, next.x, next.y, top.z);
                    if (below && *below > top.z - kLeastFall_m) continue;
                    // A person comes from level ground, at least two metres of it.
                    if (fall_after_m(world, top - way * 2.0, across, 2.1 + kGrid_m)) edges.push_back({top, across});
                }
            }
    return edges;
}

struct Found {
    int in_time = 0, late = 0, missed = 0;
    int all() const { return in_time + late + missed; }
};

// Approaches edges of a world at random angles with each technique.
std::map<CaneTechnique, Found> approaches(const std::string& map, std::size_t most) {
    std::mt19937 random(static_cast<unsigned>(test::seed_of_run()));
    const auto scene = test::world_once(test::project_root() / "worlds" / "maps" / map);
    WithCane person(scene);
    person.plain.person.settings.walk.stop_at_drops = false;
    const WalkerWorld& world = *person.plain.world.solids;
    std::vector<Edge> edges = edges_of(world, person.plain.world.building_m);
    std::shuffle(edges.begin(), edges.end(), random);
    std::map<CaneTechnique, Found> found;
    std::size_t tried = 0;
    for (const Edge& edge : edges) {
        if (tried == most) break;
        const double heading = edge.across_rad + std::uniform_real_distribution(-0.8, 0.8)(random);
        const Vec3 from = edge.top_m - forward_of_heading(heading) * std::uniform_real_distribution(2.0, 3.5)(random);
        const auto until_m = fall_after_m(world, from, heading, 4.0);
        const Vec3 chest(0.0, 0.0, 0.3);
        if (!until_m || *until_m < 1.8 ||
            world.trace(from + chest, from + chest + forward_of_heading(heading) * *until_m, {0.27, 1.45}).hit ||
            world.blocked(from + chest, {0.27, 1.45}))
            continue;
        ++tried;
        for (const CaneTechnique technique : kTechniques) {
            person.stand(from, heading);
            person.take_out(technique);
            person.said.clear();
            std::optional<double> left_m;
            person.keys.press(Command::Forward);
            double walked_m = 0.0;
            for (int i = 0; i < 60 * 6 && walked_m < *until_m && !left_m; ++i) {
                person.tick();
                walked_m = glm::length(Vec2(person.plain.avatar.feet_m() - from));
                const bool announced = std::any_of(person.said.begin(), person.said.end(), [](const std::string& s) {
                    return s.starts_with("Drop at") || s.starts_with("Step down at");
                });
                if (announced) left_m = *until_m - walked_m;
            }
            person.keys.release(Command::Forward);
            person.walking.halt();
            Found& count = found[technique];
            if (!left_m) ++count.missed;
            else ++(*left_m >= person.plain.person.settings.walk.step_length_m ? count.in_time : count.late);
        }
    }
    return found;
}

TEST(CaneEdges, of_house_and_school_are_found_before_the_foot_is_within_one_step) {
    for (const char* map : {"house.map", "school.map"}) {
        const auto found = approaches(map, test::kSanitizerScale < 1.0 ? 4 : 60);
        for (const auto& [technique, count] : found)
            std::cout << map << ", " << kNames.at(static_cast<std::size_t>(technique)) << ": " << count.all()
                      << " approaches, " << count.in_time << " found in time, " << count.late << " within one step, "
                      << count.missed << " missed\n";
        ASSERT_FALSE(found.empty()) << map;
        const Found& constant = found.at(CaneTechnique::ConstantContact);
        EXPECT_GE(constant.all(), test::kSanitizerScale < 1.0 ? 1 : 20);
        EXPECT_EQ(constant.missed, 0);
        EXPECT_LE(constant.late, std::max(1, constant.all() / 20)) << "an approach along an edge";
        EXPECT_EQ(found.at(CaneTechnique::Shoreline).missed, 0);
        EXPECT_EQ(found.at(CaneTechnique::TwoPoint).missed, 0);
    }
}

}  // namespace cane_edges_test
}  // namespace handrail
