// Tests stairs that a file states. Routes must lead over their steps wherever a walker's body can walk them. Elsewhere
// a link must join the two ends of the stairs.
#include "worlds/navigation/stated_stairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/support/stair_house.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/reach.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace stated_stairs_test {

constexpr double kUp_m = 2.8;

StatedRoom room(const std::string& name, const Vec3& least, const Vec3& most) {
    StatedRoom stated;
    stated.name = name;
    stated.rings = {{{least.x, least.y}, {most.x, least.y}, {most.x, most.y}, {least.x, most.y}}};
    stated.floor_m = least.z;
    stated.height_m = 2.5;
    stated.at_m = {0.5 * (least.x + most.x), 0.5 * (least.y + most.y), least.z};
    return stated;
}

// A ground of 10 by 4 m, and an upper floor over its eastern end. The stated stairs join the two.
struct House {
    test::SceneBuilder b;
    StatedBuilding stated;

    explicit House(const Vec3& by = Vec3(0.0)) : by_(by) {
        b.box(by + Vec3(0, 0, -0.2), by + Vec3(10, 4, 0), "floor", SolidRole::Solid, {}, FeatureKind::Floor);
        b.box(by + Vec3(7, 0, kUp_m - 0.2), by + Vec3(10, 4, kUp_m), "floor", SolidRole::Solid, {}, FeatureKind::Floor);
        b.start(by + Vec3(1, 2, 0), 0.0);
        stated.rooms = {room("Hall", by, by + Vec3(7, 4, 0)),
                        room("Gallery", by + Vec3(7, 0, kUp_m), by + Vec3(10, 4, kUp_m))};
    }
    void state(FeatureId stairs) {
        StatedPortal portal;
        portal.kind = StatedPortalKind::Stairs;
        portal.feature = stairs;
        portal.rooms = {0, 1};
        stated.portals.push_back(portal);
    }
    // Adds a flight with this many steps, which leads from the west up to the upper floor.
    FeatureId flight(int steps, double going_m) {
        FeatureId made = kNoFeature;
        for (int k = 0; k < steps; ++k) {
            const double top = kUp_m * (k + 1) / (steps + 1), x = 7.0 - (steps - k) * going_m;
            const FeatureId own =
                b.box(by_ + Vec3(x, 1, 0), by_ + Vec3(x + going_m, 3, top), "stairs", SolidRole::Solid, {});
            if (!made) made = own;
            b.scene().solids.back().feature = made;
            b.scene().features[made.value].bounds_m.include(b.scene().features[own.value].bounds_m);
        }
        return made;
    }
    Result<WalkSpace> space() {
        b.scene().stated = std::make_shared<const StatedBuilding>(stated);
        const auto scene = b.share();
        return make_walk_space(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
    }

private:
    Vec3 by_;
};

std::vector<WalkLink> climbs(const WalkSpace& space) {
    std::vector<WalkLink> found;
    for (const WalkLink& link : space.links)
        if (link.kind == PassageKind::Climb) found.push_back(link);
    return found;
}

bool walks(const WalkSpace& space, const Vec3& from_m, const Vec3& to_m) {
    const std::uint32_t from = space.nearest(from_m, 0.5, 0.3, 0.3), to = space.nearest(to_m, 0.5, 0.3, 0.3);
    if (from == kNothing || to == kNothing) return false;
    std::vector<bool> seen(space.spans.size(), false);
    std::vector<std::uint32_t> open{from};
    seen[from] = true;
    for (std::size_t i = 0; i < open.size(); ++i)
        for (const std::uint32_t next : space.spans[open[i]].next)
            if (next != kNothing && !seen[next]) {
                seen[next] = true;
                open.push_back(next);
            }
    return seen[to];
}

bool walks_up(const WalkSpace& space, const Vec3& by) {
    return walks(space, by + Vec3(1, 2, 0), by + Vec3(9, 2, kUp_m));
}

TEST(StatedStairs, that_can_be_walked_make_no_link) {
    House house;
    house.state(house.flight(15, 0.28));
    const Result<WalkSpace> space = house.space();
    ASSERT_TRUE(space.has_value());
    EXPECT_TRUE(walks_up(*space, Vec3(0.0)));
    EXPECT_TRUE(climbs(*space).empty());
}

// A walker half a metre wide must be able to walk these stairs. When its toes are two risers up, its back is still
// under the floor above.
TEST(StatedStairs, of_each_form_can_be_walked_up_and_down) {
    for (const test::StairForm form : test::kStairForms) {
        const test::StairHouse house(form);
        const auto scene = house.share();
        const Result<WalkSpace> space = make_walk_space(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
        ASSERT_TRUE(space.has_value());
        EXPECT_TRUE(walks(*space, house.hall_m(), house.gallery_m())) << test::form_name(form);
        EXPECT_TRUE(walks(*space, house.gallery_m(), house.hall_m())) << test::form_name(form);
        EXPECT_TRUE(climbs(*space).empty()) << test::form_name(form);
    }
}

// If the file does not state the stairs, no walker of that width and height can walk the same treads. In architects'
// models, walls often consist of pieces on top of each other. A foot that passes the upper piece must not meet the
// lower piece as a ledge.
TEST(StatedStairs, next_to_walls_in_pieces_work_like_next_to_whole_walls) {
    std::mt19937 random(20261129);
    const int rounds = test::kSanitizerScale < 1.0 ? 1 : 3;
    for (const test::StairForm form : test::kStairForms)
        for (int round = 0; round < rounds; ++round) {
            SCOPED_TRACE(test::form_name(form));
            constexpr double kTop_m = 2.9;
            std::vector<double> tops_m{std::uniform_real_distribution(1.2, 2.0)(random),
                                       std::uniform_real_distribution(2.0, 2.8)(random), kTop_m};
            SCOPED_TRACE(testing::PrintToString(tops_m));
            const auto whole = test::StairHouse(form, {kTop_m}).share(),
                       pieces = test::StairHouse(form, tops_m).share();
            const Result<WalkSpace> a = make_walk_space(*whole, WalkerMeasures{}),
                                    b = make_walk_space(*pieces, WalkerMeasures{});
            ASSERT_TRUE(a && b);
            ASSERT_EQ(a->spans.size(), b->spans.size());
            for (std::uint32_t s = 0; s < a->spans.size(); ++s) ASSERT_EQ(a->place_m(s), b->place_m(s));
        }
}

TEST(StatedStairs, are_necessary_to_climb_the_stairs_of_the_test_houses) {
    for (const test::StairForm form : test::kStairForms) {
        const test::StairHouse house(form);
        Scene unstated = *house.share();
        unstated.stated.reset();
        const Result<WalkSpace> space = make_walk_space(unstated, walker_measures(unstated, 0.25, 1.8, 0.25));
        ASSERT_TRUE(space.has_value());
        EXPECT_FALSE(walks(*space, house.hall_m(), house.gallery_m())) << test::form_name(form);
    }
}

TEST(StatedStairs, too_steep_to_walk_are_taken_in_one_go_from_bottom_to_top) {
    House house;
    const FeatureId stairs = house.flight(5, 0.3);
    house.state(stairs);
    const Result<WalkSpace> space = house.space();
    ASSERT_TRUE(space.has_value());
    EXPECT_FALSE(walks_up(*space, Vec3(0.0)));
    const std::vector<WalkLink> links = climbs(*space);
    ASSERT_EQ(links.size(), 1U);
    EXPECT_EQ(links[0].feature, stairs);
    EXPECT_TRUE(links[0].both_ways);
    const Vec3 foot = space->place_m(links[0].from), head = space->place_m(links[0].to);
    EXPECT_NEAR(foot.z, 0.0, 0.01);
    EXPECT_NEAR(head.z, kUp_m, 0.01);
    EXPECT_NEAR(foot.x, 7.0 - 5 * 0.3, 0.8) << "before the first step";
    EXPECT_NEAR(head.x, 7.0, 0.8) << "behind the last";

    // The route to the gallery and back must use the link in both directions and never walk the stairs.
    const auto scene = house.b.share();
    const auto ways = Navigation::make(*scene, space->body);
    ASSERT_TRUE(ways.has_value());
    for (const bool up : {true, false}) {
        const Vec3 from = up ? Vec3(1, 2, 0) : Vec3(9, 2, kUp_m), to = up ? Vec3(9, 2, kUp_m) : Vec3(1, 2, 0);
        const Route route = (*ways)->plan(from, to);
        EXPECT_TRUE(route.reaches);
        const auto passage = std::find_if(route.passages.begin(), route.passages.end(),
                                          [](const RoutePassage& p) { return p.kind == PassageKind::Climb; });
        ASSERT_NE(passage, route.passages.end());
        EXPECT_NEAR(passage->rise_m, up ? kUp_m : -kUp_m, 0.01);
        EXPECT_EQ(passage->feature, stairs);
        EXPECT_NEAR(glm::length(route.points_m.back() - to), 0.0, 0.1);
        for (const RoutePassage& p : (*ways)->plan(from, to, RoutePreference::OnFoot).passages)
            EXPECT_NE(p.kind, PassageKind::Climb);
    }
    const RoomGraph graph = make_rooms(*scene, *space);
    EXPECT_TRUE(rooms_out_of_reach(*scene, *space, graph).empty());
}

TEST(StatedStairs, without_geometry_lead_from_the_middle_of_one_room_to_the_middle_of_the_other) {
    House house;
    house.state(kNoFeature);
    const Result<WalkSpace> space = house.space();
    ASSERT_TRUE(space.has_value());
    const std::vector<WalkLink> links = climbs(*space);
    ASSERT_EQ(links.size(), 1U);
    EXPECT_FALSE(links[0].feature);
    EXPECT_NEAR(glm::length(space->place_m(links[0].from) - house.stated.rooms[0].at_m), 0.0, 0.1);
    EXPECT_NEAR(glm::length(space->place_m(links[0].to) - house.stated.rooms[1].at_m), 0.0, 0.1);
}

TEST(StatedStairs, that_join_nothing_or_lead_to_an_unreachable_place_make_no_link) {
    House level;
    level.stated.rooms[1].floor_m = 0.1;
    level.state(kNoFeature);
    House alone;
    alone.state(kNoFeature);
    alone.stated.portals[0].rooms = {0};
    House wrong;
    wrong.state(kNoFeature);
    wrong.stated.portals[0].rooms = {0, 7};
    House high;
    high.state(kNoFeature);
    high.stated.rooms[1].at_m.z = high.stated.rooms[1].floor_m = 9.0;
    House no_stairs;
    no_stairs.state(kNoFeature);
    no_stairs.stated.portals[0].kind = StatedPortalKind::Opening;
    House part;  // one step of a flight is stated as separate stairs
    (void)part.flight(6, 0.3);
    part.state(part.b.box({6.7, 3, 2.0}, {7.0, 4, 2.4}, "stairs"));
    for (House* house : {&level, &alone, &wrong, &high, &no_stairs, &part}) {
        const Result<WalkSpace> space = house->space();
        ASSERT_TRUE(space.has_value());
        EXPECT_TRUE(climbs(*space).empty());
    }
}

// The test finds out by walking whether a walker gets up. A link must exist if the walker does not get up, and only
// then. This must be so near the origin and far from it.
TEST(StatedStairs, of_any_step_size_become_a_link_exactly_if_nobody_can_walk_up) {
    std::mt19937 random(17);
    int walked = 0, taken = 0;
    const int runs = test::scaled(60);
    for (int run = 0; run < runs; ++run) {
        const Vec3 by = run % 3 == 2 ? Vec3(4.0e4, -7.0e4, 300.0) : Vec3(0.0);
        House house(by);
        const int steps = std::uniform_int_distribution<int>(5, 17)(random);
        house.state(house.flight(steps, std::uniform_real_distribution<double>(0.2, 0.35)(random)));
        if (run % 4 == 3)  // a beam leaves too little headroom half-way up
            house.b.box(by + Vec3(4, 0, 2.4), by + Vec3(6, 4, 2.5), "beam");
        const Result<WalkSpace> space = house.space();
        ASSERT_TRUE(space.has_value());
        const bool walks = walks_up(*space, by);
        EXPECT_EQ(climbs(*space).size(), walks ? 0U : 1U) << "run " << run << ", " << steps << " steps";
        (walks ? walked : taken) += 1;
    }
    EXPECT_GT(walked, runs / 10);
    EXPECT_GT(taken, runs / 10);
}

}  // namespace stated_stairs_test
}  // namespace handrail
