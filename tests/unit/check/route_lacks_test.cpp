// Tests what route_lacks() reports about the best route to a place. The small worlds have one obstruction each. The
// reference tries walkers of different sizes one by one.
#include "worlds/check/route_lacks.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <random>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"
#include "worlds/check/faults.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/reach.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace route_lacks_test {

using ::testing::HasSubstr;

// Returns two rooms of 4 by 4 metres with a free space between x = 4 and x = 5. Each test puts an obstruction into that
// space. The floor from x = 5 on is `up_m` higher.
test::SceneBuilder two_rooms(const Vec3& at, double up_m = 0.0) {
    test::SceneBuilder b;
    const auto wall = [&](const Vec3& from, const Vec3& to) {
        b.box(at + from, at + to, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    };
    b.box(at + Vec3(0, 0, -0.2), at + Vec3(5, 4, 0), "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    b.box(at + Vec3(5, 0, -0.2), at + Vec3(9, 4, up_m), "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    wall({-0.2, -0.2, -0.2}, {9.2, 0, 4});
    wall({-0.2, 4, -0.2}, {9.2, 4.2, 4});
    wall({-0.2, 0, -0.2}, {0, 4, 4});
    wall({9, 0, -0.2}, {9.2, 4, 4});
    b.start(at + Vec3(1, 2, 0), 0.0);
    return b;
}

constexpr std::array kKinds{Lack::Headroom, Lack::Step, Lack::Width};

RouteLacks lacks_in(const Scene& scene, const Vec3& to_m) {
    const WalkerMeasures body = walker_measures(scene, 0.25, 1.8, 0.25);
    const Result<WalkSpace> space = make_walk_space(scene, body);
    EXPECT_TRUE(space.has_value());
    const std::array places{to_m};
    return route_lacks(scene, *space, scene.starts[0].feet_m, places, kKinds)[0];
}

TEST(RouteLacks, are_the_obstacles_to_a_body_and_their_extent) {
    for (const Vec3& at : {Vec3(0.0), Vec3(52'428.8, -26'214.4, 102.4)}) {
        const Vec3 there = at + Vec3(7, 2, 0);
        {  // A beam at 1.3 m.
            test::SceneBuilder b = two_rooms(at);
            b.box(at + Vec3(4, 0, 1.3), at + Vec3(5, 4, 4), "Beam", SolidRole::Solid, {}, FeatureKind::Wall);
            const RouteLacks found = lacks_in(*b.share(), there);
            EXPECT_EQ(found.lack, Lack::Headroom);
            EXPECT_NEAR(found.has_m, 1.3, 1e-3);
            EXPECT_NEAR(found.needs_m, 1.8, 1e-9);
            EXPECT_GE(found.at_m.x, at.x + 3.7);
            EXPECT_LE(found.at_m.x, at.x + 5.3);
        }
        {  // A ledge of half a metre.
            const RouteLacks found = lacks_in(*two_rooms(at, 0.5).share(), there + Vec3(0, 0, 0.5));
            EXPECT_EQ(found.lack, Lack::Step);
            EXPECT_NEAR(found.has_m, 0.5, 1e-3);
            EXPECT_NEAR(found.needs_m, 0.25, 1e-9);
            EXPECT_NEAR(found.at_m.x, at.x + 5.0, 0.35);
        }
        {  // A gap of 0.3 m.
            test::SceneBuilder b = two_rooms(at);
            b.box(at + Vec3(4, 0, 0), at + Vec3(5, 1.85, 4), "wall", SolidRole::Solid, {}, FeatureKind::Wall);
            b.box(at + Vec3(4, 2.15, 0), at + Vec3(5, 4, 4), "wall", SolidRole::Solid, {}, FeatureKind::Wall);
            const RouteLacks found = lacks_in(*b.share(), there);
            EXPECT_EQ(found.lack, Lack::Width);
            EXPECT_NEAR(found.has_m, 0.3, 0.06) << "as columns of 5 cm have it";
            EXPECT_NEAR(found.needs_m, 0.5, 1e-9);
            EXPECT_NEAR(found.at_m.y, at.y + 2.0, 0.1);
        }
        {  // A wall across the whole width.
            test::SceneBuilder b = two_rooms(at);
            b.box(at + Vec3(4, 0, 0), at + Vec3(5, 4, 4), "wall", SolidRole::Solid, {}, FeatureKind::Wall);
            EXPECT_EQ(lacks_in(*b.share(), there).lack, Lack::Nothing);
        }
        // A beam at 1.3 m over a ledge of half a metre. The route lacks headroom and has too high a step, so no single
        // lack explains it.
        {
            test::SceneBuilder b = two_rooms(at, 0.5);
            b.box(at + Vec3(4, 0, 1.8), at + Vec3(6, 4, 4), "Beam", SolidRole::Solid, {}, FeatureKind::Wall);
            EXPECT_EQ(lacks_in(*b.share(), there + Vec3(0, 0, 0.5)).lack, Lack::Nothing);
        }
    }
}

// route_lacks() must choose the better of two routes and report the worst place on it.
TEST(RouteLacks, are_those_of_the_worst_place_on_the_best_route) {
    test::SceneBuilder b = two_rooms(Vec3(0.0));
    b.box({4, 0, 1.0}, {5, 2, 4}, "Beam", SolidRole::Solid, {}, FeatureKind::Wall);
    b.box({4, 2, 1.5}, {4.5, 4, 4}, "Beam", SolidRole::Solid, {}, FeatureKind::Wall);
    b.box({4.5, 2, 1.4}, {5, 4, 4}, "Beam", SolidRole::Solid, {}, FeatureKind::Wall);
    const RouteLacks found = lacks_in(*b.share(), {7, 2, 0});
    EXPECT_EQ(found.lack, Lack::Headroom);
    EXPECT_NEAR(found.has_m, 1.4, 1e-3);
    EXPECT_GT(found.at_m.y, 2.0);
    EXPECT_GT(found.at_m.x, 4.2);
}

// Computes the walkable area for a walker with these measures. Returns whether this walker gets from the start to
// `there_m`.
bool flooded(const Scene& scene, const WalkerMeasures& body, const Vec3& there_m) {
    const Result<WalkSpace> space = make_walk_space(scene, body);
    if (!space) return false;
    const std::uint32_t first = space->nearest(scene.starts[0].feet_m, 1.0, 0.6, 1.0),
                        last = space->nearest(there_m, 1.0, 0.6, 1.0);
    if (first == kNothing || last == kNothing) return false;
    return spans_reached(*space, first)[last];
}

// The reported amount must be the limit: a slightly smaller walker arrives, and a slightly larger one does not.
TEST(RouteLacks, agree_with_trying_bodies_one_by_one) {
    std::mt19937_64 random(test::seed_of_run());
    const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    int reported = 0;
    for (int run = 0; run < test::scaled(30); ++run) {
        test::SceneBuilder b = two_rooms(Vec3(0.0), run % 2 == 0 ? 0.0 : between(0.0, 0.7));
        for (double y = 0.0; y < 4.0; y += 1.0) {
            const double x = between(3.9, 4.4);
            b.box({x, y, between(0.8, 2.2)}, {x + 0.6, y + 1.0, 4}, "Beam", SolidRole::Solid, {}, FeatureKind::Wall);
        }
        for (int i = 0; i < 6; ++i) {
            const Vec3 from(between(2.0, 5.0), between(0.0, 3.2), 0.0);
            b.box(from, from + Vec3(between(0.1, 0.4), between(0.2, 0.8), between(0.3, 2.5)), "block");
        }
        const auto scene = b.share();
        const Vec3 there(7, 2, scene->solids[1].shape.bounds_m.max_m.z);
        const WalkerMeasures body = walker_measures(*scene, 0.25, 1.8, 0.25);
        const auto comes = [&](const WalkerMeasures& tried) { return flooded(*scene, tried, there); };
        if (comes(body)) continue;
        const Result<WalkSpace> space = make_walk_space(*scene, body);
        ASSERT_TRUE(space.has_value());
        const std::array places{there};
        for (const Lack kind : {Lack::Headroom, Lack::Step}) {
            const std::array kinds{kind};
            const RouteLacks found = route_lacks(*scene, *space, scene->starts[0].feet_m, places, kinds)[0];
            WalkerMeasures most = body, less = body, more = body;
            if (kind == Lack::Headroom) {
                most.height_m *= 0.5;
                less.height_m = found.has_m - 0.01;
                more.height_m = found.has_m + 0.01;
            } else {
                most.step_up_m += 0.6;
                less.step_up_m = found.has_m + 0.005;
                more.step_up_m = found.has_m - 0.005;
            }
            EXPECT_EQ(found.lack == kind, comes(most)) << "run " << run << ", " << word_of(kind);
            if (found.lack != kind) continue;
            ++reported;
            EXPECT_TRUE(comes(less)) << "run " << run << ", " << word_of(kind) << " of " << found.has_m;
            EXPECT_FALSE(comes(more)) << "run " << run << ", " << word_of(kind) << " of " << found.has_m;
        }
    }
    EXPECT_GE(reported, test::scaled(5));
}

// Stairs that lead up under a floor without enough headroom, as in many architects' models.
TEST(RoomOutOfReach, reports_stairs_that_lead_under_a_floor_without_headroom) {
    test::SceneBuilder b;
    b.box({0, 0, -0.2}, {10, 4, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    for (const auto& [from, to] :
         {std::pair(Vec3(-0.2, -0.2, -0.2), Vec3(10.2, 0, 6)), std::pair(Vec3(-0.2, 4, -0.2), Vec3(10.2, 4.2, 6)),
          std::pair(Vec3(-0.2, 0, -0.2), Vec3(0, 4, 6)), std::pair(Vec3(10, 0, -0.2), Vec3(10.2, 4, 6))})
        b.box(from, to, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    for (int step = 0; step < 14; ++step) {
        const double top = 0.2 * (step + 1);
        b.box({3 + 0.3 * step, 0, top - 0.2}, {3 + 0.3 * (step + 1), 4, top}, "stairs");
    }
    b.box({7.2, 0, 2.6}, {10, 4, 2.8}, "Upper floor", SolidRole::Solid, {}, FeatureKind::Floor);
    b.box({0, 0, 2.8}, {5.0, 4, 6.0}, "Ceiling", SolidRole::Solid, {}, FeatureKind::Floor);
    b.start({1, 2, 0}, 0.0);
    const auto scene = b.share();
    const Result<WalkSpace> space = make_walk_space(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(space.has_value());
    const RoomGraph graph = make_rooms(*scene, *space);
    std::string said, advice;
    for (const WorldFault& fault : find_faults(*scene, &*space, &graph))
        if (fault.kind == FaultKind::RoomOutOfReach) {
            said = fault_words(*scene, fault);
            advice = fault_advice(*scene, fault);
        }
    EXPECT_THAT(said, HasSubstr("of headroom under")) << said;
    EXPECT_THAT(said, HasSubstr("eiling"));
    EXPECT_THAT(advice, HasSubstr("at least 1.8 metres of headroom"));
}

// A row of houses. Each house has a flight of stairs to its gallery, and a beam over the flight. The beams have
// different heights. For each flight, the check must report only the beam over that flight.
TEST(StairsInOneGo, report_for_each_flight_what_blocks_it) {
    constexpr int kHouses = 7, kSteps = 14;
    constexpr double kUp_m = 2.8, kEach_m = 6.0;
    test::SceneBuilder b;
    StatedBuilding stated;
    const auto room = [&](const Vec3& low, const Vec3& high) {
        StatedRoom made;
        made.name = "Room";
        made.rings = {{{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}}};
        made.floor_m = low.z;
        made.height_m = 2.5;
        made.at_m = {0.5 * (low.x + high.x), 0.5 * (low.y + high.y), low.z};
        stated.rooms.push_back(made);
        return static_cast<std::uint32_t>(stated.rooms.size() - 1);
    };
    b.box({0, 0, -0.2}, {10, kHouses * kEach_m, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    b.start({1, 2, 0}, 0.0);
    std::vector<double> headroom_m;
    for (int house = 0; house < kHouses; ++house) {
        const Vec3 at(0.0, house * kEach_m, 0.0);
        b.box(at + Vec3(7, 0, kUp_m - 0.2), at + Vec3(10, 4, kUp_m), "floor", SolidRole::Solid, {}, FeatureKind::Floor);
        StatedPortal portal;
        portal.kind = StatedPortalKind::Stairs;
        portal.rooms = {room(at, at + Vec3(7, 4, 0)), room(at + Vec3(7, 0, kUp_m), at + Vec3(10, 4, kUp_m))};
        for (int k = 0; k < kSteps; ++k) {
            const double top = kUp_m * (k + 1) / (kSteps + 1), x = 7.0 - (kSteps - k) * 0.28;
            const FeatureId own = b.box(at + Vec3(x, 1, 0), at + Vec3(x + 0.28, 3, top), "stairs");
            if (!portal.feature) portal.feature = own;
            b.scene().solids.back().feature = portal.feature;
            b.scene().features[portal.feature.value].bounds_m.include(b.scene().features[own.value].bounds_m);
        }
        stated.portals.push_back(portal);
        headroom_m.push_back(1.35 + 0.05 * house);
        // The beam is above the eighth step and as wide as the flight.
        const double step_x = 7.0 - 7 * 0.28, step_top = kUp_m * 8 / (kSteps + 1);
        b.box(at + Vec3(step_x, 0, step_top + headroom_m.back()), at + Vec3(step_x + 0.28, 4, 6), "beam",
              SolidRole::Solid, {}, FeatureKind::Wall);
    }
    b.scene().stated = std::make_shared<const StatedBuilding>(stated);
    const auto scene = b.share();
    const Result<WalkSpace> space = make_walk_space(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(space.has_value());
    const RoomGraph graph = make_rooms(*scene, *space);
    std::map<std::uint32_t, const WorldFault> reported;
    for (const WorldFault& fault : find_faults(*scene, &*space, &graph))
        if (fault.kind == FaultKind::StairsInOneGo) reported.emplace(fault.feature.value, fault);
    ASSERT_EQ(reported.size(), kHouses);
    for (int house = 0; house < kHouses; ++house) {
        const FeatureId stairs = stated.portals[static_cast<std::size_t>(house)].feature;
        ASSERT_TRUE(reported.contains(stairs.value)) << house;
        const WorldFault& fault = reported.at(stairs.value);
        EXPECT_EQ(fault.lack, Lack::Headroom) << house;
        // Part of the walker may still be on the previous or the next step, so the reported headroom may differ by the
        // height of a step.
        EXPECT_NEAR(fault.amount, headroom_m[static_cast<std::size_t>(house)], 0.45) << house;
        EXPECT_GT(fault.at_m.y, house * kEach_m) << house;
        EXPECT_LT(fault.at_m.y, house * kEach_m + 4.0) << house;
    }
}

// A trial space must have the same reachable places as the complete walkable area of the same walker.
TEST(TrialSpaces, agree_with_complete_spaces_about_reachable_places) {
    std::mt19937_64 random(test::seed_of_run());
    const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    for (int run = 0; run < test::scaled(10); ++run) {
        test::SceneBuilder b = two_rooms(Vec3(0.0), between(0.0, 0.5));
        for (int i = 0; i < 14; ++i) {
            const Vec3 from(between(1.5, 8.0), between(0.0, 3.5), between(0.0, 1.6));
            b.box(from, from + Vec3(between(0.1, 0.6), between(0.2, 1.2), between(0.2, 1.5)), "block");
        }
        const auto scene = b.share();
        const WalkerMeasures body = walker_measures(*scene, 0.25, 1.8, 0.25);
        const auto whole = make_walk_space(*scene, body);
        const auto trial = make_trial_space(*scene, body, {true, std::nullopt});
        const Vec3 start_m = scene->starts[0].feet_m;
        const auto stretch =
            make_trial_space(*scene, body, {true, WalkTrial::Stretch{start_m, Aabb{Vec3(-1.0), Vec3(10.0, 5.0, 5.0)}}});
        ASSERT_EQ(whole.has_value(), trial.has_value());
        if (!whole || !stretch) continue;
        for (const auto* tried : {&*trial, &*stretch}) {
            const std::uint32_t first = whole->at(start_m), same = tried->at(start_m);
            ASSERT_EQ(first == kNothing, same == kNothing) << "run " << run;
            if (first == kNothing) continue;
            const std::vector<bool> reached = spans_reached(*whole, first), again = spans_reached(*tried, same);
            EXPECT_EQ(std::count(reached.begin(), reached.end(), true), std::count(again.begin(), again.end(), true))
                << "run " << run;
        }
    }
}

// The house has a spiral staircase. Its lower turns are under the edge of the floor to which it leads, with 1.8 m of
// headroom.
TEST(StairsInOneGo, are_not_needed_under_low_headroom_in_a_family_house) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the stairs under a floor";
    const auto path = test::real_world("fzk-haus.ifc");
    if (!path) GTEST_SKIP() << test::needs_real_world("fzk-haus.ifc");
    const Result<Scene> scene = read_world(*path);
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    const Result<WalkSpace> space = make_walk_space(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(space.has_value());
    const RoomGraph graph = make_rooms(*scene, *space);
    for (const WorldFault& fault : find_faults(*scene, &*space, &graph)) {
        EXPECT_NE(fault.kind, FaultKind::RoomOutOfReach) << fault_words(*scene, fault);
        EXPECT_NE(fault.kind, FaultKind::StairsInOneGo) << fault_words(*scene, fault);
    }
    const auto gallery =
        std::find_if(graph.rooms.begin(), graph.rooms.end(), [](const Room& room) { return room.name == "Galerie"; });
    ASSERT_NE(gallery, graph.rooms.end());
    const std::uint32_t at = space->nearest(gallery->middle_m, 1.0, 0.6, 0.6),
                        base = space->at(scene->starts[0].feet_m);
    ASSERT_NE(at, kNothing);
    ASSERT_NE(base, kNothing);
    EXPECT_TRUE(spans_reached(*space, base)[at]);
}

// The reader generates the ground around a building together with the building, so the ground may be below the
// building's floors.
TEST(ThingFaults, are_not_reported_for_the_ground_that_was_added_around_a_building) {
    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "two.rooms";
    std::ofstream(file) << "Hall, 5 by 4 metres.\n\nDen, 4 by 4 metres, east of Hall. Opening to Hall.\n";
    const auto read = read_world(file);
    ASSERT_TRUE(read);
    const Result<WalkSpace> space = make_walk_space(*read, walker_measures(*read, 0.25, 1.8, 0.25));
    ASSERT_TRUE(space.has_value());
    const RoomGraph graph = make_rooms(*read, *space);
    for (const WorldFault& fault : find_faults(*read, &*space, &graph))
        EXPECT_TRUE(fault.kind == FaultKind::NoLandmark) << fault_words(*read, fault);
}

}  // namespace route_lacks_test
}  // namespace handrail
