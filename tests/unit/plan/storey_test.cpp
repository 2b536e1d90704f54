// Tests the floor plan of a storey: its walls, windows, doors, rooms and objects.
#include "worlds/plan/storey.h"
#include "tests/support/project_root.h"

#include <filesystem>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/office_ifc.h"
#include "tests/support/real_worlds.h"
#include "tests/support/temporary_folder.h"
#include "worlds/navigation/navigation.h"
#include "worlds/readers/reader.h"

namespace handrail::test {
namespace storey_test {

struct Plans {
    Scene scene;
    RoomGraph graph;
    std::vector<Storey> storeys;
    std::vector<Storey> uppers;  // second plans of the storeys that have two
};

Plans plans_of(Scene scene) {
    Plans plans;
    const auto made = Navigation::make(scene, walker_measures(scene, 0.25, 1.8, 0.25));
    EXPECT_TRUE(made) << made.error().sentence();
    if (!made) return plans;
    const RoomGraph graph = make_rooms(scene, (*made)->space());
    for (int i = 1; i <= storey_count(graph); ++i) {
        Result<Storey> storey = storey_of(scene, graph, (*made)->space(), i);
        EXPECT_TRUE(storey) << storey.error().sentence();
        if (!storey) continue;
        if (auto upper = upper_part_of(scene, graph, (*made)->space(), *storey))
            plans.uppers.push_back(std::move(*upper));
        plans.storeys.push_back(std::move(*storey));
    }
    EXPECT_FALSE(storey_of(scene, graph, (*made)->space(), storey_count(graph) + 1));
    EXPECT_FALSE(storey_of(scene, graph, (*made)->space(), 0));
    plans.scene = std::move(scene);
    plans.graph = graph;
    return plans;
}

Plans plans_of(const std::filesystem::path& path) {
    auto scene = read_world(path);
    EXPECT_TRUE(scene) << path;
    return scene ? plans_of(std::move(*scene)) : Plans{};
}

std::filesystem::path bundled(const std::string& name) { return test::project_root() / "worlds" / "maps" / name; }

bool walled(const Storey& storey, const Vec2& at) {
    return std::any_of(storey.walls_m.begin(), storey.walls_m.end(),
                       [&](const PlanOutline& wall) { return within(wall, at); });
}

// A room of 6 by 4 m with walls of 0.2 m. Its south wall has a window of 1 m over a sill; its north wall has a window
// that begins at the floor. A door of 1 m in the east wall leads to a second room of 3 by 4 m.
struct TwoRooms {
    SceneBuilder build;
    FeatureId pane, low_pane, table, ball;
    TwoRooms() {
        const auto wall = [&](double x0, double y0, double x1, double y1, double z0 = 0.0, double z1 = 2.5) {
            build.box({x0, y0, z0}, {x1, y1, z1}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
        };
        build.box({-0.2, -0.2, -0.2}, {9.4, 4.2, 0.0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
        wall(-0.2, -0.2, 0.0, 4.2);
        wall(0.0, -0.2, 2.0, 0.0);
        wall(2.0, -0.2, 3.0, 0.0, 0.0, 0.9);
        wall(3.0, -0.2, 9.4, 0.0);
        wall(0.0, 4.0, 2.0, 4.2);
        wall(3.0, 4.0, 9.4, 4.2);
        wall(6.0, 0.0, 6.2, 1.5);
        wall(6.0, 2.5, 6.2, 4.0);
        wall(9.2, 0.0, 9.4, 4.0);
        pane = build.box({2.0, -0.11, 0.9}, {3.0, -0.09, 2.0}, "window");
        low_pane = build.box({2.0, 4.09, 0.0}, {3.0, 4.11, 2.0}, "window");
        table = build.box({1.0, 1.0, 0.0}, {2.0, 3.0, 0.75}, "table");
        build.start({4.0, 2.0, 0.0}, kPi / 2.0);
    }
};

TEST(StoreyPlan, closes_windows_and_leaves_doors_open) {
    const Plans plans = plans_of(std::move(TwoRooms().build.scene()));
    ASSERT_EQ(plans.storeys.size(), 1U);
    const Storey& storey = plans.storeys.front();
    EXPECT_TRUE(walled(storey, {2.5, -0.1})) << "over its sill";
    EXPECT_TRUE(walled(storey, {2.5, 4.1})) << "glass from the floor up";
    EXPECT_FALSE(walled(storey, {6.1, 2.0})) << "a way through";
    ASSERT_EQ(storey.rooms.size(), 2U);
    ASSERT_EQ(storey.gaps.size(), 1U);
    EXPECT_NEAR(storey.gaps[0].width_m, 1.0, 1e-6);
    EXPECT_NEAR(storey.gaps[0].place_m.y, 2.0, 1e-6);
    EXPECT_NEAR(std::abs(storey.gaps[0].along.y), 1.0, 1e-6);
    ASSERT_EQ(storey.things.size(), 1U) << "neither pane is a thing";
    EXPECT_NEAR(storey.things[0].box.half_m.x, 1.0, 1e-9);
    EXPECT_NEAR(storey.things[0].box.half_m.y, 0.5, 1e-9);
    EXPECT_EQ(floor_at(storey, {1.5, 2.0}), kNothing) << "the table stands there";
    EXPECT_NE(floor_at(storey, {4.0, 2.0}), floor_at(storey, {7.5, 2.0}));
    EXPECT_EQ(floor_at(storey, {-50.0, 2.0}), kNothing);
    ASSERT_TRUE(storey.base);
    EXPECT_NEAR(storey.base->place_m.x, 4.0, 1e-9);
}

TEST(StoreyPlan, treats_a_glass_front_without_adjoining_walls_as_closed) {
    TwoRooms world;
    // In the western room: a pane of glass in the middle, without walls next to it; a banister, which is not glass; and
    // a rail that is too low.
    world.build.box({4.0, 0.5, 0.0}, {4.05, 1.5, 2.2}, "pane", SolidRole::Solid, "glass");
    world.build.box({5.0, 2.5, 0.0}, {5.05, 3.5, 2.2}, "banister");
    world.build.box({5.0, 0.5, 0.0}, {5.05, 1.5, 0.9}, "rail");
    const Plans plans = plans_of(std::move(world.build.scene()));
    ASSERT_EQ(plans.storeys.size(), 1U);
    EXPECT_TRUE(walled(plans.storeys[0], {4.02, 1.0}));
    EXPECT_FALSE(walled(plans.storeys[0], {5.02, 1.0}));
    EXPECT_EQ(plans.storeys[0].things.size(), 3U) << "table, rail, banister";
}

std::vector<std::string> names_of(const Storey& storey, bool elsewhere) {
    std::vector<std::string> names;
    for (const StoreyRoom& room : storey.rooms)
        if (room.elsewhere == elsewhere) names.push_back(room.name);
    return names;
}

bool joins(const Storey& storey, const Portal& portal) {
    return std::any_of(storey.portals.begin(), storey.portals.end(), [&](const StoreyPortal& shown) {
        const std::array<std::uint32_t, 2> rooms{storey.rooms[shown.rooms[0]].room, storey.rooms[shown.rooms[1]].room};
        return rooms == portal.rooms && glm::distance(shown.place_m, Vec2(portal.place_m.x, portal.place_m.y)) < 1e-9;
    });
}

// A hall of 16 by 8 m. A deck crosses it, with two rooms that a door joins. Steps lead up to the deck.
TEST(StoreyPlan, of_floors_above_each_other_has_two_parts) {
    SceneBuilder build;
    const auto wall = [&](double x0, double y0, double x1, double y1, double z0) {
        build.box({x0, y0, z0}, {x1, y1, 4.5}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    };
    build.box({-0.2, -0.2, -0.2}, {16.2, 8.2, 0.0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    wall(-0.2, -0.2, 0.0, 8.2, 0.0);
    wall(16.0, -0.2, 16.2, 8.2, 0.0);
    wall(0.0, -0.2, 16.0, 0.0, 0.0);
    wall(0.0, 8.0, 16.0, 8.2, 0.0);
    constexpr double kDeck_m = 1.95;
    build.box({4.0, 0.0, kDeck_m - 0.1}, {8.0, 8.0, kDeck_m}, "deck", SolidRole::Solid, {}, FeatureKind::Floor);
    wall(4.0, 3.9, 5.5, 4.1, kDeck_m);
    wall(6.5, 3.9, 8.0, 4.1, kDeck_m);
    for (int i = 0; i < 9; ++i)
        build.box({8.0 + 0.3 * i, 6.5, 0.0}, {8.3 + 0.3 * i, 8.0, kDeck_m * (9 - i) / 10.0}, "step", SolidRole::Solid,
                  {}, FeatureKind::Floor);
    build.start({2.0, 2.0, 0.0}, 0.0);
    const Plans plans = plans_of(std::move(build.scene()));
    ASSERT_EQ(plans.storeys.size(), 1U) << "the deck is not high enough for a storey";
    ASSERT_EQ(plans.uppers.size(), 1U);
    const Storey &lower = plans.storeys[0], &upper = plans.uppers[0];
    EXPECT_TRUE(upper.upper);
    EXPECT_EQ(lower.hidden.size(), 2U);
    EXPECT_EQ(names_of(lower, true), names_of(upper, false)) << "each is shown whole on one of them";
    EXPECT_NEAR(upper.floor_m, kDeck_m, 0.01);
    EXPECT_LT(lower.floor_m, 0.5);
    EXPECT_TRUE(walled(upper, {4.5, 4.0}));
    EXPECT_FALSE(walled(lower, {4.5, 4.0})) << "that wall stands on the deck";
    std::size_t doors = 0;
    for (const Portal& portal : plans.graph.portals) {
        EXPECT_TRUE(joins(lower, portal) || joins(upper, portal));
        doors += !joins(lower, portal) && std::abs(portal.place_m.y - 4.0) < 0.5 ? 1 : 0;
    }
    EXPECT_EQ(doors, 1U) << "between the two rooms of the deck";
    // If no floors of a storey are above each other, the storey must have only one plan.
    EXPECT_TRUE(plans_of(std::move(TwoRooms().build.scene())).uppers.empty());
}

// The roof comes down beyond the walkable area. There it stops a walker's head, but nothing is near at hand height.
TEST(StoreyPlan, is_closed_where_a_roof_is_too_low_for_a_body) {
    SceneBuilder build;
    const auto wall = [&](double x0, double y0, double x1, double y1) {
        build.box({x0, y0, 0.0}, {x1, y1, 2.5}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    };
    build.box({-0.2, -0.6, -0.2}, {6.2, 4.2, 0.0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    wall(-0.2, -0.6, 0.0, 4.2);
    wall(6.0, -0.6, 6.2, 4.2);
    wall(0.0, 4.0, 6.0, 4.2);
    build.box({-0.2, -0.6, 1.5}, {6.2, 0.0, 2.5}, "roof", SolidRole::Solid, {}, FeatureKind::Slope);
    build.start({3.0, 2.0, 0.0}, 0.0);
    const Plans plans = plans_of(std::move(build.scene()));
    ASSERT_EQ(plans.storeys.size(), 1U);
    EXPECT_TRUE(walled(plans.storeys[0], {3.0, -0.3}));
    EXPECT_FALSE(walled(plans.storeys[0], {3.0, 1.0}));
}

TEST(StoreyPlan, contains_no_unreachable_room_on_an_outside_ledge) {
    TwoRooms world;
    world.build.box({3.5, 4.2, -0.2}, {5.5, 5.0, 0.0}, "ledge", SolidRole::Solid, {}, FeatureKind::Floor);
    const Plans plans = plans_of(std::move(world.build.scene()));
    ASSERT_EQ(plans.storeys.size(), 1U);
    ASSERT_EQ(plans.graph.rooms.size(), 3U) << "somebody can stand there";
    ASSERT_EQ(plans.storeys[0].rooms.size(), 2U);
    ASSERT_EQ(plans.storeys[0].portals.size(), 1U);
    EXPECT_NE(floor_at(plans.storeys[0], {1.0, 3.5}), floor_at(plans.storeys[0], {8.0, 2.0}));
    EXPECT_EQ(floor_at(plans.storeys[0], {4.5, 4.6}), kNothing);
}

// Returns a hall with wide steps along its middle, 0.2 m high and 1 m deep. The steps lead up to a gallery at 2 m with
// walls on either side. `first_step_m` is the height of the first step.
Scene hall_with_wide_steps(double first_step_m) {
    SceneBuilder build;
    const auto wall = [&](double x0, double y0, double x1, double y1) {
        build.box({x0, y0, 0.0}, {x1, y1, 5.0}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    };
    build.box({-0.2, -0.2, -0.2}, {20.2, 4.2, 0.0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    wall(-0.2, -0.2, 0.0, 4.2);
    wall(20.0, -0.2, 20.2, 4.2);
    wall(0.0, -0.2, 20.0, 0.0);
    wall(0.0, 4.0, 20.0, 4.2);
    for (int i = 0; i < 9; ++i) {
        const double x = 6.0 + i, top = first_step_m + 0.2 * i;
        build.box({x, 0.0, top - 0.15}, {x + 1.0, 4.0, top}, "", SolidRole::Solid, {}, FeatureKind::Floor);
    }
    build.box({15.0, 0.0, 0.0}, {20.0, 4.0, first_step_m + 1.8}, "", SolidRole::Solid, {}, FeatureKind::Floor);
    build.start({3.0, 2.0, 0.0}, 0.0);
    return std::move(build.scene());
}

TEST(StoreyPlan, has_no_wall_across_wide_steps_that_rise_through_the_section_plane) {
    const auto wall_on_steps = [](const Plans& plans) {
        const Storey& storey = plans.storeys.at(0);
        for (double x = 6.1; x < 15.0; x += 0.1)
            if (walled(storey, {x, 2.0})) return true;
        return false;
    };
    EXPECT_FALSE(wall_on_steps(plans_of(hall_with_wide_steps(0.2))));
    EXPECT_TRUE(wall_on_steps(plans_of(hall_with_wide_steps(1.0)))) << "nobody climbs the first of these";
}

// Checks that no wall stands anywhere between the jambs of a door, that all walls are within the plan, and that the
// middle of a room is in no other room.
void is_sound(const Plans& plans, const std::string& world) {
    for (const Storey& storey : plans.storeys) {
        EXPECT_FALSE(storey.rooms.empty());
        EXPECT_LT(storey.min_m.x, storey.max_m.x);
        for (std::uint32_t room = 0; room < storey.rooms.size(); ++room) {
            const std::uint32_t there = floor_at(storey, storey.rooms[room].middle_m);
            EXPECT_TRUE(there == room || there == kNothing)
                << world << ": the middle of " << storey.rooms[room].name << " lies in another room";
        }
        for (const StoreyGap& gap : storey.gaps)
            for (const double part : {-0.48, -0.25, 0.0, 0.25, 0.48})
                EXPECT_FALSE(walled(storey, gap.place_m + gap.along * (part * gap.width_m)))
                    << world << " " << storey.number << ": " << gap.name << " at " << gap.place_m.x << " "
                    << gap.place_m.y;
        for (const PlanOutline& outline : storey.walls_m) {
            ASSERT_GE(outline.size(), 3U);
            for (const Vec2& p : outline) {
                EXPECT_GE(p.x, storey.min_m.x - 1e-9);
                EXPECT_LE(p.y, storey.max_m.y + 1e-9);
            }
        }
    }
}

TEST(StoreyPlan, of_our_house_and_school_has_doors_between_connected_rooms) {
    const Plans house = plans_of(bundled("house.map"));
    ASSERT_EQ(house.storeys.size(), 2U);
    is_sound(house, "house");
    EXPECT_GE(house.storeys[0].gaps.size(), 6U);
    EXPECT_TRUE(house.storeys[0].base);
    const Plans school = plans_of(bundled("school.map"));
    ASSERT_EQ(school.storeys.size(), 2U);
    is_sound(school, "school");
}

TEST(StoreyPlan, of_architects_buildings_is_not_enlarged_by_the_ground_around_them) {
    const TemporaryFolder folder;
    const auto office = folder.write("office.ifc", office_ifc({2, 1, 3}).text);
    for (const auto& path : with_real_worlds({office}, {"duplex-apartment.ifc"})) {
        SCOPED_TRACE(path);
        const Plans building = plans_of(path);
        ASSERT_GE(building.storeys.size(), 2U);
        is_sound(building, path.filename().string());
        for (const Storey& storey : building.storeys) {
            EXPECT_LT(storey.max_m.x - storey.min_m.x, 30.0);
            EXPECT_LT(storey.max_m.y - storey.min_m.y, 30.0);
        }
        EXPECT_FALSE(building.storeys[0].windows_m.empty());
    }
}

TEST(BoxAround, finds_the_smallest_box_around_a_slanted_shape) {
    const double turn = 0.4;
    const Vec2 x(std::cos(turn), std::sin(turn)), y(-std::sin(turn), std::cos(turn));
    const PlanBox found = box_around(convex_hull({x * 3.0, x * 3.0 + y, y, Vec2(0.0), x + y * 0.5}));
    EXPECT_NEAR(found.half_m.x, 1.5, 1e-9);
    EXPECT_NEAR(found.half_m.y, 0.5, 1e-9);
    EXPECT_NEAR(std::abs(cross_of(found.along, x)), 0.0, 1e-9);
    for (const Vec2& corner : found.corners_m())
        EXPECT_NEAR(glm::length(corner - found.middle_m), std::hypot(1.5, 0.5), 1e-9);
}

}  // namespace storey_test
}  // namespace handrail::test
