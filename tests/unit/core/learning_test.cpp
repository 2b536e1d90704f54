#include "app/core/learning.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "app/core/app_core.h"
#include "app/core/session_log.h"
#include "tests/support/box_scene.h"
#include "tests/support/random_families.h"

namespace handrail {
namespace {

using test::SceneBuilder;

// A room with its south-west corner at `at`, a door of a metre in the south wall and a block that stands free.
struct Room {
    Room(const Vec3& at, double wide, double deep, bool block = false) : at_m(at), wide_m(wide), deep_m(deep) {
        SceneBuilder b;
        b.box(at + Vec3(-1, -1, -0.2), at + Vec3(wide + 1, deep + 1, 0), "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
        b.box(at + Vec3(-0.2, deep, 0), at + Vec3(wide + 0.2, deep + 0.2, 2.6), "north wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
        b.box(at + Vec3(-0.2, -0.2, 0), at + Vec3(1, 0, 2.6), "south wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
        b.box(at + Vec3(2, -0.2, 0), at + Vec3(wide + 0.2, 0, 2.6), "south wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
        b.box(at + Vec3(1, -0.15, 0), at + Vec3(2, 0, 2.6), "Door", SolidRole::Solid, "wood", FeatureKind::Door);
        b.box(at + Vec3(wide, 0, 0), at + Vec3(wide + 0.2, deep, 2.6), "east wall", SolidRole::Solid, "wood", FeatureKind::Wall);
        b.box(at + Vec3(-0.2, 0, 0), at + Vec3(0, deep, 2.6), "west wall", SolidRole::Solid, "brick", FeatureKind::Wall);
        if (block) b.box(at + Vec3(2, 2, 0), at + Vec3(2.8, 2.8, 0.9), "Table", SolidRole::Solid, "wood", FeatureKind::Object);
        b.start(at + Vec3(1.5, 0.5, 0), 0.0);
        scene = b.share();
        world = std::make_unique<BodyWorld>(scene);
        place = place_around(*world, at + Vec3(1.5, 0.5, 0), body_size(*scene, 0.25));
    }
    Vec3 at_m;
    double wide_m, deep_m;
    std::shared_ptr<const Scene> scene;
    std::unique_ptr<BodyWorld> world;
    Place place;
};

TEST(Learning, perimeter_and_floor_are_as_large_as_the_room_and_what_stands_free_is_no_wall) {
    std::mt19937 random(test::seed_of_run());
    for (int run = 0; run < 20; ++run) {
        const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        const Room room(run % 3 == 0 ? Vec3(0.0) : Vec3(between(-900, 900), between(-900, 900), between(-9, 9)), between(4, 9), between(4, 9), run % 2 == 1);
        const Progress none = progress_of(room.place, {}, *room.scene);
        const double perimeter = 2.0 * (room.wide_m + room.deep_m), table = run % 2 == 1 ? 0.64 : 0.0;
        // A row of cells more or less each way.
        EXPECT_NEAR(none.perimeter_m, perimeter, 4.0 * Place::kCell_m);
        EXPECT_NEAR(none.floor_m2, room.wide_m * room.deep_m - table, Place::kCell_m * (room.wide_m + room.deep_m) + 0.2);
        EXPECT_EQ(none.doors, 1);
        EXPECT_EQ(none.doors_found, 0);
        EXPECT_EQ(none.touched_m, 0.0);
        EXPECT_TRUE(room.place.whole);
    }
}

TEST(Learning, the_share_of_the_walls_that_was_touched_is_the_truth_within_two_percent) {
    std::mt19937 random(test::seed_of_run());
    for (int run = 0; run < 40; ++run) {
        const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        const Room room(Vec3(between(-900, 900), between(-900, 900), 0.0), between(4, 9), between(4, 9));
        LearningNotes notes;
        double truth_m = 0.0;
        const double reach = between(0.05, 0.3);
        const struct {
            Vec3 from, along, normal;
            double length;
        } walls[] = {{{0, room.deep_m, 0}, {1, 0, 0}, {0, -1, 0}, room.wide_m}, {{room.wide_m, 0, 0}, {0, 1, 0}, {-1, 0, 0}, room.deep_m},
                     {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, room.deep_m}};
        for (const auto& wall : walls) {
            const double begin = between(0, 0.6 * wall.length), end = between(begin, wall.length);
            for (double s = begin; s <= end; s += 0.05) notes.touched(room.at_m + wall.from + wall.along * s + Vec3(0, 0, 1), wall.normal, reach);
            truth_m += std::min(wall.length, begin + std::floor((end - begin) / 0.05) * 0.05 + reach) - std::max(0.0, begin - reach);
        }
        const double perimeter = 2.0 * (room.wide_m + room.deep_m);
        EXPECT_NEAR(progress_of(room.place, notes, *room.scene).perimeter_share(), truth_m / perimeter, 0.02) << run;
    }
}

TEST(Learning, the_share_of_the_floor_that_was_walked_is_the_truth_within_two_percent) {
    std::mt19937 random(test::seed_of_run());
    for (int run = 0; run < 10; ++run) {
        const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        const Room room(Vec3(between(-900, 900), between(-900, 900), 0.0), between(4, 8), between(4, 8));
        LearningNotes notes;
        std::vector<Vec3> way;
        Vec3 at(1.5, 0.5, 0.0);
        for (int leg = 0; leg < 4; ++leg) {
            const Vec3 to(between(0.3, room.wide_m - 0.3), between(0.3, room.deep_m - 0.3), 0.0);
            const int pieces = static_cast<int>(glm::length(to - at) / 0.05) + 1;
            for (int i = 0; i <= pieces; ++i) {
                way.push_back(room.at_m + at + (to - at) * (static_cast<double>(i) / pieces));
                notes.walked(way.back());
            }
            at = to;
        }
        // The truth: points three centimetres apart.
        int all = 0, walked = 0;
        for (double x = 0.015; x < room.wide_m; x += 0.03)
            for (double y = 0.015; y < room.deep_m; y += 0.03) {
                const Vec3 p = room.at_m + Vec3(x, y, 0.0);
                ++all;
                walked += std::any_of(way.begin(), way.end(), [&](const Vec3& w) { return glm::length(w - p) <= kFloorReach_m; });
            }
        EXPECT_NEAR(progress_of(room.place, notes, *room.scene).floor_share(), static_cast<double>(walked) / all, 0.02) << run;
    }
}

TEST(Learning, what_is_not_known_yet_is_found_nearest_first_and_nothing_is_left_at_the_end) {
    const Room room(Vec3(0.0), 6.0, 4.0);
    LearningNotes notes;
    const Vec3 feet(1.5, 0.5, 0.0);
    auto left = nearest_unexplored(room.place, notes, feet);
    ASSERT_TRUE(left);
    for (double x = 0.25; x < 6.0; x += 0.5)
        for (double y = 0.1; y < 4.0; y += 0.1) notes.walked({x, y, 0.0});
    left = nearest_unexplored(room.place, notes, feet);
    ASSERT_TRUE(left);
    EXPECT_TRUE(left->wall) << "the floor is done";
    for (double s = 0.0; s <= 6.0; s += 0.05) notes.touched({s, 0, 1}, {0, 1, 0}, 0.1), notes.touched({s, 4, 1}, {0, -1, 0}, 0.1);
    for (double s = 0.0; s <= 4.0; s += 0.05) notes.touched({0, s, 1}, {1, 0, 0}, 0.1);
    left = nearest_unexplored(room.place, notes, feet);
    ASSERT_TRUE(left);
    EXPECT_EQ(room.scene->features[left->feature.value].name, "east wall");
    for (double s = 0.0; s <= 4.0; s += 0.05) notes.touched({6, s, 1}, {-1, 0, 0}, 0.1);
    EXPECT_FALSE(nearest_unexplored(room.place, notes, feet));
    const Progress all = progress_of(room.place, notes, *room.scene);
    EXPECT_GT(all.perimeter_share(), 0.99);
    EXPECT_GT(all.floor_share(), 0.99);
    EXPECT_EQ(all.doors_found, 1);
    for (const Lane& lane : lanes_of(room.place, notes)) EXPECT_TRUE(lane.done() || !lane.north);
}

TEST(Learning, lanes_lie_a_metre_apart_both_ways) {
    const Room room(Vec3(0.0), 6.0, 4.0);
    const std::vector<Lane> lanes = lanes_of(room.place, {});
    EXPECT_EQ(std::count_if(lanes.begin(), lanes.end(), [](const Lane& lane) { return lane.north; }), 6);
    EXPECT_EQ(lanes.size(), 10U);
    EXPECT_NEAR(lanes[1].at_m - lanes[0].at_m, 1.0, 0.11);
    LearningNotes notes;
    for (double y = 0.3; y < 3.8; y += 0.05) notes.walked({lanes[2].at_m, y, 0.0});
    const std::vector<Lane> after = lanes_of(room.place, notes);
    for (std::size_t i = 0; i < after.size(); ++i) EXPECT_EQ(after[i].done(), i == 2) << i;
}

// A lap by the keys: what the session says equals what its way on the floor makes true.
TEST(Learning, a_lap_by_keys_is_told_as_it_was_within_two_percent_at_every_part_of_it) {
    const Room room(Vec3(0.0), 6.0, 4.0);
    for (const double seconds : {5.0, 9.0, 14.0, 26.0}) {
        AppCore app(Settings{}, HandFacts{});
        app.enter_world(room.scene, 0.0);
        double now = 0.0;
        std::vector<Vec3> feet;
        std::vector<std::string> said;
        const auto run = [&](double for_s) {
            for (const double until = now + for_s; now < until - 1e-9;) {
                now += 1.0 / 60.0;
                app.tick(now, ToolState{});
                feet.push_back(app.feet_m());
                for (const CueRequest& cue : app.take_cues())
                    if (cue.kind == CueRequestKind::Say) said.push_back(cue.text);
            }
        };
        app.press(Command::LearnPlace, now);
        run(0.1);
        app.release(Command::LearnPlace);
        app.press(Command::TrailLeft, now);
        run(seconds);
        app.release(Command::TrailLeft);
        run(0.5);
        app.press(Command::ProgressReport, now);
        run(0.1);
        // The truth: points of the walls a centimetre apart that the side of the body was at.
        int all = 0, touched = 0;
        const auto look = [&](const Vec3& wall, const Vec3& normal) {
            ++all;
            touched += std::any_of(feet.begin(), feet.end(), [&](const Vec3& f) {
                const Vec3 way = f - wall;
                return glm::dot(way, normal) < 0.25 + Trail::kGap_m + 0.02 && std::abs(-way.x * normal.y + way.y * normal.x) <= 0.25;
            });
        };
        for (double s = 0.005; s < 6.0; s += 0.01) look({s, 0, 0}, {0, 1, 0}), look({s, 4, 0}, {0, -1, 0});
        for (double s = 0.005; s < 4.0; s += 0.01) look({0, s, 0}, {1, 0, 0}), look({6, s, 0}, {-1, 0, 0});
        const std::string& report = said.back();
        ASSERT_EQ(report.rfind("Walls ", 0), 0U) << report;
        EXPECT_NEAR(std::stod(report.substr(6)), 100.0 * touched / all, 2.0) << report;
        if (seconds > 20.0) {
            EXPECT_GT(100.0 * touched / all, 95.0);
            EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const std::string& line) { return words_in_order("North wall done", line); }));
            EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const std::string& line) { return words_in_order("All walls done", line); }));
            EXPECT_NE(report.find("1 of 1 door"), std::string::npos) << report;
        }
    }
}

}  // namespace
}  // namespace handrail
