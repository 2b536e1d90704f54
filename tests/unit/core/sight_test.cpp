// Tests what is in sight in large worlds, and compares it with a simple method that uses eight straight lines to every
// thing. Also tests WalkerWorld objects that share a building.
#include <random>

#include "app/core/world/surroundings.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/office_world.h"
#include "tests/support/project_root.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/models.h"

namespace handrail::test {
namespace sight_test {

constexpr std::uint32_t kSeed = 7;

// The simple method: returns everything within range, the nearest first, with eight lines to each thing and without
// shortcuts.
std::vector<Seen> plainly_in_sight(const WalkerWorld& world, const Vec3& feet_m, double height_m, std::size_t most) {
    const Scene& scene = world.scene();
    const Vec3 eye = feet_m + Vec3(0.0, 0.0, height_m);
    const auto level_m = [&](const Vec3& point) { return std::hypot(point.x - eye.x, point.y - eye.y); };
    std::vector<std::pair<double, std::uint32_t>> candidates;
    for (std::uint32_t i = 0; i < scene.features.size(); ++i) {
        if (!named_when_seen(scene.features[i])) continue;
        const Aabb& box = scene.features[i].bounds_m;
        const double nearest_m = level_m(glm::clamp(eye, box.min_m, box.max_m));
        if (nearest_m <= kSightRange_m) candidates.emplace_back(nearest_m, i);
    }
    std::sort(candidates.begin(), candidates.end());
    std::vector<Seen> found;
    for (const auto& [nearest_m, i] : candidates) {
        if (found.size() >= most && nearest_m > found[most - 1].distance_m) break;
        const Feature& feature = scene.features[i];
        const bool volume = feature.kind == FeatureKind::Liquid || feature.kind == FeatureKind::Teleport;
        const Vec3 middle = feature.bounds_m.centre_m(), half = 0.5 * feature.bounds_m.size_m();
        std::vector<Vec3> points{middle, glm::clamp(eye, feature.bounds_m.min_m, feature.bounds_m.max_m)};
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {1.0, -1.0}) {
                points.push_back(middle);
                points.back()[axis] += side * half[axis];
            }
        for (std::size_t p = 1; p < points.size(); ++p) points[p] = middle + (points[p] - middle) * 0.98;
        for (const Vec3& point : points) {
            const Vec3 way = point - eye;
            const double distance_m = glm::length(way);
            if (distance_m < 1e-6 || distance_m > kSightRange_m) continue;
            const TraceHit hit = world.trace(eye, point, WalkerShape{}, true);
            if (hit.hit ? hit.feature.value != i : !volume) continue;
            const Vec3 seen_m = hit.hit ? hit.end_m : point;
            const Seen seen{std::atan2(way.x, way.y), level_m(seen_m), FeatureId{i}, seen_m};
            found.insert(std::upper_bound(found.begin(), found.end(), seen,
                                          [](const Seen& a, const Seen& b) { return a.distance_m < b.distance_m; }),
                         seen);
            break;
        }
    }
    if (found.size() > most) found.resize(most);
    return found;
}

void expect_same(const WalkerWorld& world, const Vec3& feet_m, const std::string& where) {
    SCOPED_TRACE(fmt::format("{} at {} {} {}, seed {}", where, feet_m.x, feet_m.y, feet_m.z, kSeed));
    for (const std::size_t most : {std::size_t{2}, std::size_t{24}}) {
        const std::vector<Seen> seen = things_in_sight(world, feet_m, 1.2, most),
                                plainly = plainly_in_sight(world, feet_m, 1.2, most);
        ASSERT_EQ(seen.size(), plainly.size());
        for (const Seen& one : plainly)
            if (std::none_of(seen.begin(), seen.end(),
                             [&](const Seen& other) { return other.feature == one.feature; })) {
                const Feature& f = world.scene().features[one.feature.value];
                ADD_FAILURE() << "not told: " << f.name << ", of kind " << static_cast<int>(f.kind) << ", "
                              << f.bounds_m.min_m.x << ' ' << f.bounds_m.min_m.y << ' ' << f.bounds_m.min_m.z << " to "
                              << f.bounds_m.max_m.x << ' ' << f.bounds_m.max_m.y << ' ' << f.bounds_m.max_m.z
                              << ", seen at " << one.point_m.x << ' ' << one.point_m.y << ' ' << one.point_m.z;
            }
        for (std::size_t i = 0; i < seen.size(); ++i) {
            EXPECT_EQ(seen[i].feature, plainly[i].feature) << i;
            EXPECT_EQ(seen[i].distance_m, plainly[i].distance_m) << i;
            EXPECT_EQ(seen[i].bearing_rad, plainly[i].bearing_rad) << i;
            EXPECT_EQ(seen[i].point_m, plainly[i].point_m) << i;
        }
    }
}

std::shared_ptr<const Scene> shipped(const char* name) {
    return std::make_shared<const Scene>(*read_world(test::project_root() / "worlds/maps" / name));
}

Vec3 somewhere(std::mt19937& random, const Aabb& box) {
    const auto part = [&] { return static_cast<double>(random()) / 4294967296.0; };
    const double x = part(), y = part(), z = part();
    return box.min_m + box.size_m() * Vec3(x, y, z);
}

TEST(Sight, agrees_with_eight_exhaustive_ray_casts_in_the_bundled_worlds) {
    for (const char* name : {"house.map", "school.map"}) {
        std::vector<int> thing_of_mover;
        const auto scene = std::make_shared<const Scene>(with_movers_apart(*shipped(name), 128, thing_of_mover));
        const WalkerWorld world(scene);
        for (const Start& start : scene->starts) expect_same(world, start.feet_m, name);
        std::mt19937 random(kSeed);
        for (int i = 0; i < 25; ++i) expect_same(world, somewhere(random, scene->bounds_m), name);
    }
}

TEST(Sight, gives_the_same_answers_among_slanted_solids_and_sheets_far_from_the_origin) {
    std::mt19937 random(kSeed);
    for (const Vec3 shift : {Vec3(0.0), Vec3(4e4, -3e4, 100.0)}) {
        SceneBuilder some;
        const Aabb all{Vec3(-12.0, -12.0, 0.0) + shift, Vec3(12.0, 12.0, 4.0) + shift};
        for (int i = 0; i < 60; ++i) {
            const Vec3 a = somewhere(random, all);
            if (i % 3 == 0) some.ramp(a, a + Vec3(3.0, 2.0, 1.5));
            else some.box(a, a + (i % 2 ? Vec3(0.2, 6.0, 3.0) : Vec3(0.4, 0.3, 0.5)));
        }
        Scene& scene = some.scene();
        for (int i = 0; i < 20; ++i) {
            const Vec3 a = somewhere(random, all), b = a + Vec3(0.0, 4.0, 0.0), c = a + Vec3(0.5, 0.0, 4.0);
            scene.triangles.push_back({a, b, c, scene.solids[0].feature, kDefaultMaterial, TouchSide::Both});
        }
        const WalkerWorld world(some.share());
        for (int i = 0; i < 60; ++i) expect_same(world, somewhere(random, all), "slanted");
    }
}

TEST(Sight, uses_a_limited_number_of_rays_in_a_world_of_any_size) {
    const auto read = read_quake_map(office_world(office_size(3000)).map, "office.map");
    const auto office = std::make_shared<const Scene>(*read);
    const WalkerWorld world(office);
    std::mt19937 random(kSeed);
    int most = 0;
    for (int i = 0; i < 40; ++i) {
        int rays = 0;
        (void)things_in_sight(world, somewhere(random, office->bounds_m), 1.2, 24, &rays);
        most = std::max(most, rays);
    }
    EXPECT_LT(most, kMostRays + 16);
    // In a hall with 1,600 things in sight, only the nearest are checked.
    SceneBuilder hall;
    for (int i = 0; i < 1600; ++i) {
        const Vec3 a(-38.0 + 1.9 * (i % 40), -38.0 + 1.9 * (i / 40), 0.0);
        hall.box(a, a + Vec3(0.3, 0.3, i % 2 ? 0.3 : 0.8));
    }
    const WalkerWorld things(hall.share());
    int rays = 0;
    EXPECT_EQ(things_in_sight(things, Vec3(0.4, 0.4, 0.0), 1.2, 24, &rays).size(), 24U);
    EXPECT_LT(rays, 400);
}

TEST(WalkerWorld, hits_the_same_obstacles_whether_the_building_is_shared_or_private) {
    std::vector<int> thing_of_mover;
    const auto scene = std::make_shared<const Scene>(with_movers_apart(*shipped("house.map"), 128, thing_of_mover));
    ASSERT_GT(scene->placed.size(), 5U);
    const WalkerWorld before(scene);
    std::vector<Placement> moved;
    for (const PlacedModel& thing : scene->placed) {
        moved.push_back(thing.at);
        moved.back().position_m += Vec3(0.3, -0.2, 0.1);
    }
    const WalkerWorld shared(before, scene, moved), own(scene, moved);
    std::mt19937 random(kSeed);
    for (int i = 0; i < 500; ++i) {
        const Vec3 from = somewhere(random, scene->bounds_m), to = somewhere(random, scene->bounds_m);
        const WalkerShape body{i % 2 ? 0.25 : 0.0, i % 2 ? 1.5 : 0.0};
        const TraceHit a = shared.trace(from, to, body), b = own.trace(from, to, body);
        EXPECT_EQ(a.fraction, b.fraction);
        EXPECT_EQ(a.feature, b.feature);
        EXPECT_EQ(shared.blocked(from, body), own.blocked(from, body));
        EXPECT_EQ(shared.crossings(from, to).size(), own.crossings(from, to).size());
    }
}

// Finds where a path meets each solid alone. For all solids together, the result must be the first of these hits.
TEST(WalkerWorld, reports_the_first_obstacle_that_a_search_of_all_solids_finds) {
    std::mt19937 random(kSeed);
    const Aabb all{Vec3(-6.0), Vec3(6.0)};
    SceneBuilder some;
    std::vector<std::unique_ptr<WalkerWorld>> alone;
    for (int i = 0; i < 40; ++i) {
        const Vec3 a = somewhere(random, all),
                   b = a + Vec3(0.2) + somewhere(random, {Vec3(0.0), Vec3(i % 9 == 0 ? 6.0 : 1.5)});
        SceneBuilder one;
        one.box(a, b);
        some.box(a, b);
        alone.push_back(std::make_unique<WalkerWorld>(one.share()));
    }
    const WalkerWorld world(some.share());
    for (int i = 0; i < 2000; ++i) {
        const Vec3 from = somewhere(random, all) * 1.5,
                   to = i % 5 ? somewhere(random, all) * 1.5 : from + Vec3(0.0, 0.0, 4.0);
        const WalkerShape body{i % 2 ? 0.3 : 0.0, i % 2 ? 1.2 : 0.0};
        double first = 1.0;
        for (const auto& one : alone) first = std::min(first, one->trace(from, to, body).fraction);
        EXPECT_EQ(world.trace(from, to, body).fraction, first) << "way " << i << ", seed " << kSeed;
    }
}

}  // namespace sight_test
}  // namespace handrail::test
