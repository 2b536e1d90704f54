#include "app/core/world/trail.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/box_scene.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace trail_test {

using test::SceneBuilder;

// The result of trailing a wall until the time is up or the wall ends. The test moves the walker as Session does, and
// stores its events.
struct Trailed {
    std::vector<TrailEvent> events;
    std::vector<Vec3> feet_m;
    // Largest distance of the walker's side from the wall while the walker reports contact.
    double farthest_from_wall_m = 0.0;
};

Trailed go(const WalkerWorld& world, const WalkerSize& body, const Vec3& feet, double heading, TrailSide side,
           double seconds) {
    Trailed result;
    Walker walker(world, body);
    walker.place(feet);
    Trail trail;
    if (!trail.start(world, walker.state().feet_m, heading, body, side)) return result;
    constexpr double kDt = 1.0 / 60.0;
    for (int i = 0; i < seconds / kDt && trail.active(); ++i) {
        const TrailMotion way = trail.tick(world, walker.state().feet_m, heading, body, 1.0, kDt, result.events);
        const double off = std::remainder(way.heading_rad - heading, 2.0 * kPi);
        heading += std::clamp(off, -2.6 * kDt, 2.6 * kDt);
        walker.tick(way.intended_m_per_s, kDt);
        result.feet_m.push_back(walker.state().feet_m);
    }
    return result;
}

// Returns the events in words: the names in order, with a star before each corner.
std::vector<std::string> words(const Scene& scene, const std::vector<TrailEvent>& events) {
    std::vector<std::string> all;
    for (const TrailEvent& event : events) {
        const Feature* feature = scene.find(event.feature);
        const std::string name = feature ? feature->name : "";
        if (event.kind == TrailEvent::Kind::Corner) all.push_back("*" + name);
        else if (event.kind == TrailEvent::Kind::Meets) all.push_back(name);
        else all.push_back(event.kind == TrailEvent::Kind::Opening ? "opening" : "end");
    }
    return all;
}

void four_walls(SceneBuilder& b, const Vec3& at, double wide, double deep) {
    b.box(at + Vec3(-9, -9, -0.2), at + Vec3(wide + 9, deep + 9, 0), "floor", SolidRole::Solid, "carpet",
          FeatureKind::Floor);
    b.box(at + Vec3(-0.2, deep, 0), at + Vec3(wide + 0.2, deep + 0.2, 2.6), "north wall", SolidRole::Solid, "plaster",
          FeatureKind::Wall);
    b.box(at + Vec3(wide, 0, 0), at + Vec3(wide + 0.2, deep, 2.6), "east wall", SolidRole::Solid, "wood",
          FeatureKind::Wall);
    b.box(at + Vec3(-0.2, 0, 0), at + Vec3(0, deep, 2.6), "west wall", SolidRole::Solid, "brick", FeatureKind::Wall);
}

TEST(Trail, goes_round_a_room_both_ways_at_any_place_and_never_leaves_the_wall) {
    std::mt19937 random(static_cast<unsigned>(test::seed_of_run()));
    for (int run = 0; run < 40; ++run) {
        const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        const Vec3 at(run % 4 == 0 ? 0.0 : between(-3000, 3000), between(-3000, 3000), between(-20, 20));
        const double wide = between(2.0, 7.0), deep = between(2.0, 7.0);
        SceneBuilder b;
        four_walls(b, at, wide, deep);
        b.box(at + Vec3(-0.2, -0.2, 0), at + Vec3(wide + 0.2, 0, 2.6), "south wall", SolidRole::Solid, "plaster",
              FeatureKind::Wall);
        const auto scene = b.share();
        const WalkerWorld world(scene);
        const WalkerSize body = walker_size(*scene, 0.25);
        const bool left = run % 2 == 0;
        const Trailed lap = go(world, body, at + Vec3(0.5 * wide, 0.5, 0), 0.0,
                               left ? TrailSide::Left : TrailSide::Right, 2.0 * (wide + deep) + 8.0);
        const auto said = words(*scene, lap.events);
        std::vector<std::string> corners;
        for (const std::string& word : said) {
            EXPECT_NE(word, "opening");
            EXPECT_NE(word, "end");
            if (word[0] == '*') corners.push_back(word.substr(1));
        }
        ASSERT_GE(corners.size(), 4u) << run;
        const std::vector<std::string> order =
            left ? std::vector<std::string>{"west wall", "north wall", "east wall", "south wall"}
                 : std::vector<std::string>{"east wall", "north wall", "west wall", "south wall"};
        const auto first = std::find(order.begin(), order.end(), corners.front()) - order.begin();
        for (std::size_t i = 0; i < corners.size(); ++i)
            EXPECT_EQ(corners[i], order[(static_cast<std::size_t>(first) + i) % 4]) << run;
        // The walker has been along every wall: its path comes to within the gap of each wall, and is never farther
        // than that from all walls.
        double least[4] = {9, 9, 9, 9};
        for (std::size_t i = 120; i < lap.feet_m.size(); ++i) {
            const Vec3 p = lap.feet_m[i] - at;
            const double to[4] = {p.x, p.y, wide - p.x, deep - p.y};
            double nearest = 9.0;
            for (int k = 0; k < 4; ++k) least[k] = std::min(least[k], to[k]), nearest = std::min(nearest, to[k]);
            EXPECT_LT(nearest, body.radius_m + Trail::kGap_m + 0.03);
        }
        for (const double gap : least) EXPECT_LT(gap, body.radius_m + Trail::kGap_m + 0.03);
    }
}

TEST(Trail, crosses_doorways_straight_and_announces_them_but_follows_wide_openings_inside) {
    for (const double gap : {0.8, 1.2, 2.0, 3.0}) {
        SceneBuilder b;
        four_walls(b, Vec3(0.0), 8.0, 4.0);
        b.box({-0.2, -0.2, 0}, {3, 0, 2.6}, "south wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
        b.box({3 + gap, -0.2, 0}, {8.2, 0, 2.6}, "south wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
        const auto scene = b.share();
        const WalkerWorld world(scene);
        const WalkerSize body = walker_size(*scene, 0.25);
        const Trailed way = go(world, body, {1.5, 0.4, 0}, kPi / 2.0, TrailSide::Right, 6.0);
        const auto opening = std::find_if(way.events.begin(), way.events.end(),
                                          [](const TrailEvent& e) { return e.kind == TrailEvent::Kind::Opening; });
        double deepest = 9.0;
        for (const Vec3& p : way.feet_m) deepest = std::min(deepest, p.y);
        if (gap > Trail::kWidestOpening_m) {
            EXPECT_LT(deepest, 0.0) << gap;
            continue;
        }
        ASSERT_NE(opening, way.events.end()) << gap;
        EXPECT_NEAR(opening->width_m, gap, 0.11);
        EXPECT_NEAR(opening->place_m.x, 3.0 + 0.5 * gap, 0.1);
        EXPECT_GT(deepest, 0.25 - 1e-3) << "it goes straight on";
        EXPECT_GT(way.feet_m.back().x, 3.0 + gap);
    }
}

TEST(Trail, goes_round_the_outside_of_free_standing_straight_and_slanted_blocks) {
    for (const double gap : {0.0, 0.7}) {  // a square room, and a room with a slanted side
        SceneBuilder b;
        b.box({-9, -9, -0.2}, {9, 9, 0}, "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
        b.box({-1, -1, 0}, {1, 1, 2}, "block", SolidRole::Solid, "wood", FeatureKind::Wall);
        if (gap > 0.0) b.box({1, -0.5, 0}, {1 + gap, 0.5, 2}, "wing", SolidRole::Solid, "wood", FeatureKind::Wall);
        const auto scene = b.share();
        const WalkerWorld world(scene);
        const Trailed lap = go(world, walker_size(*scene, 0.25), {0, -1.5, 0}, kPi / 2.0, TrailSide::Left, 20.0);
        // The walker passes all four sides.
        bool side[4] = {};
        for (const Vec3& p : lap.feet_m) {
            side[0] |= p.y < -1.0;
            side[1] |= p.x > 1.0;
            side[2] |= p.y > 1.0;
            side[3] |= p.x < -1.0;
            EXPECT_LT(std::max(std::abs(p.x) - gap, std::abs(p.y)), 1.65) << "never away from it";
        }
        for (const bool passed : side) EXPECT_TRUE(passed);
        EXPECT_TRUE(std::none_of(lap.events.begin(), lap.events.end(),
                                 [](const TrailEvent& e) { return e.kind == TrailEvent::Kind::Ends; }));
    }
}

// Returns an upright brush over a polygon, whose corners are in counter-clockwise order as seen from above. Map units.
std::string prism(const std::vector<Vec3>& ring, double z0, double z1) {
    const auto point = [](double x, double y, double z) { return fmt::format("( {} {} {} ) ", x, y, z); };
    std::string faces;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec3 a = ring[i], b = ring[(i + 1) % ring.size()];
        faces += point(b.x, b.y, z0) + point(a.x, a.y, z0) + point(a.x, a.y, z1) + "plain 0 0 0 1 1\n";
    }
    faces += point(1, 0, z1) + point(0, 0, z1) + point(0, 1, z1) + "plain 0 0 0 1 1\n";
    faces += point(0, 1, z0) + point(0, 0, z0) + point(1, 0, z0) + "plain 0 0 0 1 1\n";
    return "{\n" + faces + "}\n";
}

// The rooms have six walls. In two of the three rooms, no wall is parallel to an axis.
TEST(Trail, goes_round_a_room_with_slanted_walls_at_a_constant_distance) {
    for (const double turned : {0.0, 0.2, 0.41}) {
        constexpr double kRadius = 128.0;  // 4 m in map units
        const auto corner = [&](int i, double radius) {
            return Vec3(radius * std::cos(turned + i * kPi / 3.0), radius * std::sin(turned + i * kPi / 3.0), 0.0);
        };
        std::vector<Vec3> ring;
        std::string walls;
        for (int i = 0; i < 6; ++i) {
            ring.push_back(corner(i, kRadius + 16.0));
            walls += prism(
                {corner(i, kRadius), corner(i, kRadius + 8.0), corner(i + 1, kRadius + 8.0), corner(i + 1, kRadius)}, 0,
                96);
        }
        const auto scene = read_quake_map(
            test::entity("worldspawn", test::key("building", "1"), prism(ring, -16, 0) + walls), "hexagon.map");
        ASSERT_TRUE(scene);
        const auto shared = std::make_shared<const Scene>(*scene);
        const WalkerWorld world(shared);
        const double apothem = kRadius / 32.0 * std::cos(kPi / 6.0);
        // The walker starts next to the middle of the first wall and faces along the wall.
        const double across = turned + kPi / 6.0;
        const Vec3 start((apothem - 0.6) * std::cos(across), (apothem - 0.6) * std::sin(across), 0.0);
        const Trailed lap = go(world, walker_size(*shared, 0.25), start, -across, TrailSide::Left, 27.0);
        bool passed[6] = {};
        for (std::size_t i = lap.feet_m.size() / 10; i < lap.feet_m.size(); ++i) {
            const Vec3 p = lap.feet_m[i];
            double nearest = 1e9;
            for (int wall = 0; wall < 6; ++wall) {
                const double angle = turned + (wall + 0.5) * kPi / 3.0;
                const double off = apothem - (p.x * std::cos(angle) + p.y * std::sin(angle));
                nearest = std::min(nearest, off);
                passed[wall] |= off < 0.35;
            }
            EXPECT_GT(nearest, 0.25 - 1e-3) << turned;
            EXPECT_LT(nearest, 0.45) << "never away from the walls, turned by " << turned;
        }
        for (int wall = 0; wall < 6; ++wall) EXPECT_TRUE(passed[wall]) << "wall " << wall << " turned by " << turned;
        EXPECT_GE(std::count_if(lap.events.begin(), lap.events.end(),
                                [](const TrailEvent& e) { return e.kind == TrailEvent::Kind::Corner; }),
                  6);
    }
}

TEST(Trail, names_furniture_at_the_wall_without_a_corner_and_a_door_in_its_niche) {
    SceneBuilder b;
    four_walls(b, Vec3(0.0), 8.0, 4.0);
    b.box({-0.2, -0.2, 0}, {5, 0, 2.6}, "south wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({5.9, -0.2, 0}, {8.2, 0, 2.6}, "south wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({5, -0.15, 0}, {5.9, -0.1, 2.1}, "Door", SolidRole::Solid, "wood", FeatureKind::Door);
    b.box({2, 0, 0.1}, {3.2, 0.15, 0.7}, "Radiator", SolidRole::Solid, "metal");
    const auto scene = b.share();
    const WalkerWorld world(scene);
    const Trailed way = go(world, walker_size(*scene, 0.25), {1.0, 0.4, 0}, kPi / 2.0, TrailSide::Right, 6.5);
    const auto said = words(*scene, way.events);
    const auto at = [&](const std::string& word) { return std::find(said.begin(), said.end(), word) - said.begin(); };
    const auto count = static_cast<std::ptrdiff_t>(said.size());
    EXPECT_LT(at("Radiator"), count);
    EXPECT_LT(at("Door"), count);
    EXPECT_LT(at("Radiator"), at("Door"));
    for (const std::string& word : said) {
        EXPECT_NE(word[0], '*') << word;
        EXPECT_NE(word, "opening");
    }
}

TEST(Trail, turns_round_and_reports_if_there_is_no_wall) {
    SceneBuilder b;
    b.box({-50, -50, -0.2}, {50, 50, 0}, "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
    const auto open = b.share();
    const WalkerWorld field(open);
    Trail trail;
    EXPECT_FALSE(trail.start(field, Vec3(0.0), 0.0, walker_size(*open, 0.25), TrailSide::Left));

    SceneBuilder w;
    four_walls(w, Vec3(0.0), 8.0, 4.0);
    const auto scene = w.share();
    const WalkerWorld world(scene);
    ASSERT_TRUE(trail.start(world, {0.4, 2.0, 0.0}, 0.0, walker_size(*scene, 0.25), TrailSide::Left));
    std::vector<TrailEvent> events;
    const double ahead =
        trail.tick(world, {0.28, 2.0, 0.0}, 0.0, walker_size(*scene, 0.25), 1.0, 0.02, events).heading_rad;
    trail.turn_round();
    const double back =
        trail.tick(world, {0.28, 2.0, 0.0}, 0.0, walker_size(*scene, 0.25), 1.0, 0.02, events).heading_rad;
    EXPECT_NEAR(std::abs(std::remainder(ahead - back, 2.0 * kPi)), kPi, 1e-9);
    EXPECT_EQ(trail.side(), TrailSide::Right);
}

}  // namespace trail_test
}  // namespace handrail
