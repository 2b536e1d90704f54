#include "haptic/compile/simplify_scene.h"

#include <algorithm>
#include <random>

#include "haptic/compile/compile_haptic.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/random_families.h"
#include "worlds/geometry/clip.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/models.h"

namespace handrail {
namespace simplify_scene_test {

// Scale of the building. At this scale, the hand can feel only gaps of at least 1.6256 m and things of at least 0.8128
// m.
constexpr double kBuilding = 254.0;

SimplifyOptions at_scale(double scale) { return {scale, {}, {}}; }

// A building with two rooms of 8 by 6 metres, south and north of a wall that is 0.2 m thick. The wall has a doorway of
// 0.9 m with a door. The lintel is at 2.1 m and the ceiling at 2.6 m.
struct TwoRooms {
    explicit TwoRooms(double door_low_m = 3.5, const Vec3& at_m = Vec3(0.0), bool with_door = true)
        : low_m(door_low_m), zero_m(at_m) {
        wall({0, 0, -0.3}, {8, 12.2, 0}, FeatureKind::Floor);
        wall({0, 0, 2.6}, {8, 12.2, 2.8}, FeatureKind::Ceiling);
        wall({-0.2, 0, 0}, {0, 12.2, 2.6});
        wall({8, 0, 0}, {8.2, 12.2, 2.6});
        wall({0, -0.2, 0}, {8, 0, 2.6});
        wall({0, 12.2, 0}, {8, 12.4, 2.6});
        wall({0, 6, 0}, {low_m, 6.2, 2.6});
        wall({low_m + 0.9, 6, 0}, {8, 6.2, 2.6});
        wall({low_m, 6, 2.1}, {low_m + 0.9, 6.2, 2.6});
        if (with_door)
            door = builder.box(Vec3(low_m, 6.0, 0) + zero_m, Vec3(low_m + 0.9, 6.05, 2.08) + zero_m, "Door",
                               SolidRole::Mover, "wood", FeatureKind::Door);
    }
    FeatureId wall(const Vec3& low, const Vec3& high, FeatureKind kind = FeatureKind::Wall) {
        return builder.box(low + zero_m, high + zero_m, "wall", SolidRole::Solid, "plaster", kind);
    }
    FeatureId thing(const Vec3& low, const Vec3& high, const std::string& name) {
        return builder.box(low + zero_m, high + zero_m, name);
    }
    Scene& scene() {
        Scene& made = builder.scene();
        made.bounds_m = {};
        for (const Solid& solid : made.solids) made.bounds_m.include(solid.shape.bounds_m);
        return made;
    }

    double low_m;
    Vec3 zero_m;
    test::SceneBuilder builder;
    FeatureId door = kNoFeature;
};

bool is_solid(const Scene& scene, const Vec3& p, bool with_leaves = true) {
    return std::any_of(scene.solids.begin(), scene.solids.end(), [&](const Solid& solid) {
        const Feature* feature = scene.find(solid.feature);
        return (with_leaves || !feature || feature->kind != FeatureKind::Door) && contains(solid.shape, p);
    });
}

// Many small things, a door and openings without doors, because plan_simplification() checks for a cancellation at each
// of them.
TEST(SimplifyScene, stops_at_once_when_cancelled_at_any_step) {
    TwoRooms rooms;
    for (int i = 0; i < 30; ++i)
        rooms.thing({0.2 * i, 1.0, 0.0}, {0.2 * i + 0.1, 1.1, 0.5}, "cup " + std::to_string(i));
    SimplifyOptions options = at_scale(kBuilding);
    options.openings_m = {Vec3(4.0, 6.1, 0.0), Vec3(2.0, 3.0, 0.0)};
    const Scene& scene = rooms.scene();
    std::size_t all = 0;
    const Simplification plan = plan_simplification(scene, options, {}, [&] { ++all; });
    EXPECT_FALSE(plan.changes_nothing());
    EXPECT_EQ(plan, plan_simplification(scene, options));
    ASSERT_GT(all, 100U);
    for (std::size_t wanted = 1; wanted <= all; ++wanted) {
        std::stop_source stop;
        std::size_t looks = 0;
        const Simplification stopped = plan_simplification(scene, options, stop.get_token(), [&] {
            if (++looks == wanted) stop.request_stop();
        });
        ASSERT_EQ(looks, wanted) << "what was begun is all that was done after it";
        ASSERT_EQ(stopped, Simplification{}) << wanted;
    }
}

TEST(SimplifyScene, widens_a_doorway_to_both_sides_together_with_its_leaf) {
    TwoRooms rooms;
    const Simplification plan = plan_simplification(rooms.scene(), at_scale(kBuilding));
    ASSERT_EQ(plan.openings.size(), 1U);
    const NarrowOpening& opening = plan.openings[0];
    EXPECT_EQ(opening.doors, std::vector<FeatureId>{rooms.door});
    EXPECT_TRUE(opening.widened());
    EXPECT_FALSE(opening.stays_narrow());
    EXPECT_NEAR(opening.width_m(), 0.9, 1e-9);
    EXPECT_NEAR(opening.felt_width_m(), 0.0064 * kBuilding, 1e-9);
    EXPECT_NEAR(opening.felt_low_m + opening.felt_high_m, 2.0 * 3.95, 1e-9);
    const Scene felt = simplified(rooms.scene(), plan);
    EXPECT_TRUE(is_solid(rooms.scene(), {3.3, 6.1, 1.0}));
    EXPECT_FALSE(is_solid(felt, {3.3, 6.1, 1.0})) << "beside the true doorway";
    EXPECT_FALSE(is_solid(felt, {4.6, 6.1, 2.05}));
    EXPECT_TRUE(is_solid(felt, {3.3, 6.1, 2.15})) << "the wall above goes on";
    EXPECT_TRUE(is_solid(felt, {3.3, 6.1, -0.1})) << "and the floor";
    EXPECT_TRUE(is_solid(felt, {3.3, 6.02, 1.0})) << "the leaf closes it";
    EXPECT_TRUE(is_solid(felt, {4.7, 6.02, 1.0}));
    EXPECT_TRUE(is_solid(felt, {3.1, 6.1, 1.0})) << "3.1372 is where it ends";
}

TEST(SimplifyScene, does_nothing_if_everything_can_be_felt) {
    TwoRooms rooms;
    rooms.thing({1, 1, 0}, {1.3, 1.2, 0.5}, "stool");
    for (const double scale : {15.0, 60.0, 90.0, 0.0, -1.0, std::numeric_limits<double>::infinity()}) {
        const Simplification plan = plan_simplification(rooms.scene(), at_scale(scale));
        EXPECT_TRUE(plan.changes_nothing()) << scale;
        EXPECT_TRUE(plan.openings.empty()) << scale;
    }
    EXPECT_TRUE(plan_simplification(Scene{}, at_scale(500.0)).changes_nothing());
}

TEST(SimplifyScene, omits_unneeded_things_under_an_eighth_of_an_inch) {
    TwoRooms rooms;
    const FeatureId stool = rooms.thing({1, 1, 0}, {1.3, 1.2, 0.5}, "stool"),
                    pole = rooms.thing({2, 1, 0}, {2.1, 1.1, 2.5}, "pole");
    const FeatureId shelf = rooms.thing({3, 0, 0}, {5, 0.3, 1}, "shelf"),
                    fountain = rooms.thing({5, 3, 0}, {5.4, 3.4, 1}, "fountain");
    const FeatureId clue = rooms.thing({6, 3, 0}, {6.4, 3.4, 1}, "clue"),
                    marked = rooms.thing({7, 3, 0}, {7.4, 3.4, 1}, "marked");
    const FeatureId ticks = rooms.thing({7, 5, 0}, {7.4, 5.4, 1}, "clock");
    const FeatureId button =
        rooms.builder.box({1, 3, 0}, {1.1, 3.1, 1}, "button", SolidRole::Solid, "", FeatureKind::Button);
    rooms.scene().features[fountain.value].landmark = true;
    rooms.scene().features[clue.value].clue = true;
    rooms.scene().sounds.push_back({{7.2, 5.2, 1.1}, "tick", "tick", 1.0});
    SimplifyOptions options = at_scale(kBuilding);
    options.kept_m = {{7.2, 2.9, 0.5}};
    const Simplification plan = plan_simplification(rooms.scene(), options);
    EXPECT_EQ(plan.left_out, (std::vector<FeatureId>{stool, pole}));
    const Scene felt = simplified(rooms.scene(), plan);
    for (const FeatureId out : {stool, pole})
        EXPECT_FALSE(is_solid(felt, rooms.scene().features[out.value].bounds_m.centre_m()));
    for (const FeatureId in : {shelf, fountain, clue, marked, ticks, button})
        EXPECT_TRUE(is_solid(felt, rooms.scene().features[in.value].bounds_m.centre_m()));
    // At 1:60, the pole's 0.3 m are 5 mm of hand movement.
    EXPECT_EQ(plan_simplification(rooms.scene(), at_scale(60.0)).left_out, std::vector<FeatureId>{pole});
}

TEST(SimplifyScene, keeps_a_thing_that_makes_up_most_of_the_world) {
    test::SceneBuilder builder;
    builder.box({0, 0, 0}, {0.1, 0.1, 0.1}, "figure");
    builder.scene().bounds_m = {{0, 0, 0}, {0.1, 0.1, 0.1}};
    EXPECT_TRUE(plan_simplification(builder.scene(), at_scale(60.0)).changes_nothing());
}

TEST(SimplifyScene, leaves_no_hole_where_a_window_or_a_piece_of_wall_is_small) {
    TwoRooms rooms;
    std::erase_if(rooms.scene().solids, [](const Solid& s) { return s.shape.bounds_m.min_m == Vec3(4.4, 6.0, 0.0); });
    rooms.wall({4.4, 6, 0}, {6, 6.2, 2.6});
    rooms.wall({6.5, 6, 0}, {8, 6.2, 2.6});
    rooms.wall({6, 6, 0}, {6.5, 6.2, 1.0});
    rooms.wall({6, 6, 1.6}, {6.5, 6.2, 2.6});
    const FeatureId window = rooms.thing({6, 6.05, 1.0}, {6.5, 6.1, 1.6}, "Window");
    // The bin is next to the east wall, and the stand is in a corner.
    const FeatureId bin = rooms.thing({7.6, 3, 0}, {8, 3.4, 0.5}, "Bin"),
                    stand = rooms.thing({7.6, 0, 0}, {8, 0.4, 0.5}, "Stand");
    const FeatureId stub = rooms.wall({1.0, 6.2, 0}, {1.4, 6.6, 2.6}, FeatureKind::Object),
                    pillar = rooms.wall({1.0, 9.2, 0}, {1.4, 9.6, 2.6}, FeatureKind::Object);
    for (const FeatureId made : {stub, pillar}) rooms.scene().features[made.value].made_name = true;
    EXPECT_EQ(plan_simplification(rooms.scene(), at_scale(kBuilding)).left_out,
              (std::vector<FeatureId>{bin, stand, pillar}))
        << window.value << stub.value;
}

TEST(SimplifyScene, stops_widening_at_a_crossing_wall_and_widens_to_the_other_side) {
    // A third room in the north-west. Its wall meets the wall with the doorway 0.1 m west of the doorway.
    TwoRooms rooms;
    rooms.wall({3.2, 6.2, 0}, {3.4, 12.2, 2.6});
    const Simplification plan = plan_simplification(rooms.scene(), at_scale(kBuilding));
    ASSERT_EQ(plan.openings.size(), 1U);
    EXPECT_NEAR(plan.openings[0].felt_low_m, 3.4, 1e-9);
    EXPECT_NEAR(plan.openings[0].felt_high_m, 3.4 + 0.0064 * kBuilding, 1e-9);
    EXPECT_FALSE(plan.openings[0].stays_narrow());
}

TEST(SimplifyScene, reports_an_opening_that_stays_narrow_between_two_crossing_walls) {
    TwoRooms rooms;
    rooms.wall({3.2, 6.2, 0}, {3.4, 12.2, 2.6});
    rooms.wall({4.5, 0, 0}, {4.7, 6.0, 2.6});
    const Simplification plan = plan_simplification(rooms.scene(), at_scale(kBuilding));
    ASSERT_EQ(plan.openings.size(), 1U);
    EXPECT_TRUE(plan.openings[0].widened());
    EXPECT_TRUE(plan.openings[0].stays_narrow());
    EXPECT_EQ(plan.staying_narrow(), 1U);
    EXPECT_NEAR(plan.openings[0].felt_width_m(), 1.1, 1e-9);
}

TEST(SimplifyScene, never_cuts_into_a_separately_named_thing) {
    TwoRooms rooms;
    rooms.thing({4.6, 6, 0}, {5.8, 6.2, 2.0}, "Window");  // the window is inside the wall
    const Simplification plan = plan_simplification(rooms.scene(), at_scale(kBuilding));
    ASSERT_EQ(plan.openings.size(), 1U);
    EXPECT_NEAR(plan.openings[0].felt_high_m, 4.6, 1e-9);
    EXPECT_NEAR(plan.openings[0].felt_width_m(), 0.0064 * kBuilding, 1e-9);
}

TEST(SimplifyScene, keeps_a_piece_of_wall_between_two_doorways) {
    TwoRooms rooms(3.5);
    // A second doorway in the same wall, from x = 5.4 to 6.3.
    std::erase_if(rooms.scene().solids,
                  [](const Solid& s) { return s.shape.bounds_m.min_m.x == 4.4 && s.shape.bounds_m.min_m.y == 6.0; });
    rooms.wall({4.4, 6, 0}, {5.4, 6.2, 2.6});
    rooms.wall({6.3, 6, 0}, {8, 6.2, 2.6});
    rooms.wall({5.4, 6, 2.1}, {6.3, 6.2, 2.6});
    rooms.builder.box({5.4, 6, 0}, {6.3, 6.05, 2.08}, "Other door", SolidRole::Mover, "wood", FeatureKind::Door);
    const Simplification plan = plan_simplification(rooms.scene(), at_scale(kBuilding));
    ASSERT_EQ(plan.openings.size(), 2U);
    const auto [west, east] = std::minmax(plan.openings[0].felt_high_m, plan.openings[1].felt_low_m);
    EXPECT_NEAR(plan.openings[1].felt_low_m - plan.openings[0].felt_high_m, 0.0032 * kBuilding, 1e-9) << west << east;
    EXPECT_FALSE(plan.openings[0].stays_narrow()) << "there is room to the west";
    EXPECT_FALSE(plan.openings[1].stays_narrow()) << "and to the east";
}

TEST(SimplifyScene, widens_doorless_openings_only_at_the_given_places) {
    TwoRooms rooms(3.5, Vec3(0.0), false);
    EXPECT_TRUE(plan_simplification(rooms.scene(), at_scale(kBuilding)).openings.empty());
    SimplifyOptions options = at_scale(kBuilding);
    // The first place is the doorway; the second is in the middle of a room.
    options.openings_m = {{4.1, 6.15, 0.0}, {2.0, 3.0, 0.0}};
    const Simplification plan = plan_simplification(rooms.scene(), options);
    ASSERT_EQ(plan.openings.size(), 1U);
    EXPECT_EQ(plan.openings[0].place, 0);
    EXPECT_NEAR(plan.openings[0].felt_width_m(), 0.0064 * kBuilding, 1e-9);
    EXPECT_NEAR(plan.openings[0].felt_low_m + plan.openings[0].felt_high_m, 2.0 * 3.95, 1e-9);
    const Scene felt = simplified(rooms.scene(), plan);
    EXPECT_FALSE(is_solid(felt, {3.2, 6.1, 1.0}));
}

TEST(SimplifyScene, stretches_sliding_and_swinging_leaves_so_that_both_end_positions_fit) {
    for (const bool swings : {false, true}) {
        TwoRooms rooms;
        Mover mover;
        mover.feature = rooms.door;
        mover.pivot_m = swings ? Vec3(3.5, 6.05, 0.0) : Vec3(3.95, 6.025, 1.04);
        if (swings) mover.swing_rad = 0.5 * kPi;
        else mover.slide_m = {0.9, 0.0, 0.0};
        rooms.scene().movers.push_back(mover);
        std::vector<int> thing;
        Scene apart = with_movers_apart(rooms.scene(), 8, thing);
        ASSERT_EQ(thing, std::vector<int>{0});
        const Simplification plan = plan_simplification(apart, at_scale(kBuilding));
        ASSERT_EQ(plan.widened(), 1U);
        for (const double part : {0.0, 0.5, 1.0}) {
            apart.placed[0].at = mover.at(part);
            EXPECT_EQ(plan_simplification(apart, at_scale(kBuilding)), plan) << "wherever the leaf is";
            const Scene felt = simplified(apart, plan);
            const PlacedModel& leaf = felt.placed[0];
            EXPECT_EQ(leaf.at, felt_placement(plan, rooms.door, mover.at(part)));
            const Aabb box = placed_bounds(leaf.model->solids[0].shape.bounds_m, leaf.at);
            const double low = plan.openings[0].felt_low_m, width = plan.openings[0].felt_width_m();
            if (part == 0.0 || !swings) {
                EXPECT_NEAR(box.min_m.x, low + width * part, 1e-9);
                EXPECT_NEAR(box.max_m.x, low + width * (1.0 + part), 1e-9);
            } else if (part == 1.0) {
                EXPECT_NEAR(box.min_m.x, low, 1e-9) << "it hangs at the felt jamb";
                EXPECT_LT(box.max_m.x, low + 0.06);
                EXPECT_NEAR(box.size_m().y, width, 1e-9) << "and is as long as the opening is wide";
            }
        }
    }
}

TEST(SimplifyScene, widens_a_doorway_above_a_hole_in_the_floor) {
    TwoRooms rooms;
    std::erase_if(rooms.scene().solids, [](const Solid& s) { return s.shape.bounds_m.max_m.z == 0.0; });
    rooms.wall({0, 0, -0.4}, {8, 6, 0}, FeatureKind::Floor);
    rooms.wall({0, 6.2, -0.4}, {8, 12.2, 0}, FeatureKind::Floor);
    rooms.wall({0, 6, -3}, {8, 6.2, -0.4});  // the wall of the storey below
    const Simplification plan = plan_simplification(rooms.scene(), at_scale(kBuilding));
    ASSERT_EQ(plan.openings.size(), 1U);
    EXPECT_NEAR(plan.openings[0].felt_width_m(), 0.0064 * kBuilding, 1e-9);
    EXPECT_EQ(plan.openings[0].floor_m, 0.0);
}

// Returns the building rotated about the vertical axis.
Scene turned(Scene scene, double angle_rad) {
    const double c = std::cos(angle_rad), k = std::sin(angle_rad);
    const auto turn = [&](const Vec3& p) { return Vec3(c * p.x - k * p.y, k * p.x + c * p.y, p.z); };
    scene.bounds_m = {};
    for (Solid& solid : scene.solids) {
        solid.shape.bounds_m = {};
        for (Plane& plane : solid.shape.planes) plane.normal = turn(plane.normal);
        for (Polygon& face : solid.shape.faces)
            for (Vec3& p : face.points_m) {
                p = turn(p);
                solid.shape.bounds_m.include(p);
            }
        scene.features[solid.feature.value].bounds_m = solid.shape.bounds_m;
        scene.bounds_m.include(solid.shape.bounds_m);
    }
    return scene;
}

TEST(SimplifyScene, widens_slanted_doorways_like_straight_ones) {
    for (const double degrees : {7.0, 45.0, 90.0, 133.0, 200.0}) {
        TwoRooms rooms;
        rooms.wall({3.2, 6.2, 0}, {3.4, 12.2, 2.6});
        const double angle = radians_from_degrees(degrees);
        const Scene scene = turned(rooms.scene(), angle);
        const Simplification plan = plan_simplification(scene, at_scale(kBuilding));
        ASSERT_EQ(plan.openings.size(), 1U) << degrees;
        EXPECT_NEAR(plan.openings[0].width_m(), 0.9, 1e-6) << degrees;
        EXPECT_NEAR(plan.openings[0].felt_width_m(), 0.0064 * kBuilding, 1e-6) << degrees;
        const Scene felt = simplified(scene, plan);
        const auto at = [&](double x, double y) {
            return Vec3(std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y, 1.0);
        };
        EXPECT_TRUE(is_solid(scene, at(4.8, 6.1))) << degrees;
        EXPECT_FALSE(is_solid(felt, at(4.8, 6.1))) << degrees;
        EXPECT_TRUE(is_solid(felt, at(4.8, 6.02))) << "the leaf, " << degrees;
        EXPECT_TRUE(is_solid(felt, at(3.35, 6.1))) << "before the wall across, " << degrees;
    }
}

TEST(SimplifyScene, does_not_change_doors_that_are_not_in_a_doorway) {
    test::SceneBuilder builder;
    builder.box({0, 0, -0.3}, {20, 20, 0}, "floor", SolidRole::Solid, "", FeatureKind::Floor);
    builder.box({2, 2, 0}, {2.9, 2.05, 2}, "in the open", SolidRole::Mover, "", FeatureKind::Door);
    builder.box({5, 4, 0}, {9, 4.4, 3}, "wall", SolidRole::Solid, "", FeatureKind::Wall);
    builder.box({6, 4.1, 0}, {6.9, 4.2, 2}, "wholly in a wall", SolidRole::Mover, "", FeatureKind::Door);
    builder.box({12, 4, 0}, {12.9, 4.9, 0.1}, "hatch", SolidRole::Mover, "", FeatureKind::Door);
    builder.box({14, 4, 0}, {14.9, 4.0, 2}, "of no thickness", SolidRole::Mover, "", FeatureKind::Door);
    builder.box({16, 4, 0}, {16, 4, 0}, "nothing", SolidRole::Mover, "", FeatureKind::Door);
    // A corridor 0.9 m wide and 6 m long, with a door in its middle.
    builder.box({4, 10, 0}, {8, 16, 3}, "rock", SolidRole::Solid, "", FeatureKind::Wall);
    builder.box({8.9, 10, 0}, {13, 16, 3}, "rock", SolidRole::Solid, "", FeatureKind::Wall);
    const FeatureId deep =
        builder.box({8, 13, 0}, {8.9, 13.05, 2}, "in a corridor", SolidRole::Mover, "", FeatureKind::Door);
    const Simplification plan = plan_simplification(builder.scene(), at_scale(kBuilding));
    EXPECT_EQ(plan.widened(), 0U);
    EXPECT_EQ(plan.staying_narrow(), 1U) << "it is told of";
    ASSERT_EQ(plan.openings.size(), 1U);
    EXPECT_EQ(plan.openings[0].doors, std::vector<FeatureId>{deep});
}

TEST(SimplifyScene, treats_two_leaves_in_one_doorway_as_one) {
    TwoRooms rooms(3.5, Vec3(0.0), false);
    const FeatureId west =
        rooms.builder.box({3.5, 6.0, 0}, {3.95, 6.05, 2.08}, "West leaf", SolidRole::Mover, "wood", FeatureKind::Door);
    const FeatureId east =
        rooms.builder.box({3.95, 6.0, 0}, {4.4, 6.05, 2.08}, "East leaf", SolidRole::Mover, "wood", FeatureKind::Door);
    const Simplification plan = plan_simplification(rooms.scene(), at_scale(kBuilding));
    ASSERT_EQ(plan.openings.size(), 1U);
    EXPECT_EQ(plan.openings[0].doors, (std::vector<FeatureId>{west, east}));
    EXPECT_NEAR(plan.openings[0].width_m(), 0.9, 1e-9);
    const Scene felt = simplified(rooms.scene(), plan);
    const auto leaf = [&](FeatureId id) {
        return std::find_if(felt.solids.begin(), felt.solids.end(), [&](const Solid& s) { return s.feature == id; })
            ->shape.bounds_m;
    };
    EXPECT_NEAR(leaf(west).max_m.x, leaf(east).min_m.x, 1e-9) << "they still meet";
    EXPECT_NEAR(leaf(east).max_m.x - leaf(west).min_m.x, 0.0064 * kBuilding, 1e-9);
}

// Compares random places all over the building with a brute-force computation.
TEST(SimplifyScene, changes_only_cuts_door_leaves_and_omitted_things) {
    const std::uint32_t seed = test::seed_of_run();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int round = 0; round < 40; ++round) {
        const Vec3 far = round % 3 == 0 ? Vec3(12000.0, -7000.0, 300.0) : Vec3(0.0);
        TwoRooms rooms(0.3 + 6.7 * unit(random), far);
        if (round % 2 == 0) rooms.wall({2.0 + 3.0 * unit(random), 6.2, 0}, {5.2, 12.2, 2.6});
        for (int i = 0; i < 5; ++i) {
            const Vec3 low(7.0 * unit(random), 5.0 * unit(random), 0.0);
            rooms.thing(low, low + Vec3(0.05 + unit(random), 0.05 + unit(random), 0.5), "thing");
        }
        const double scale = 100.0 + 400.0 * unit(random);
        const Scene& whole = rooms.scene();
        const Simplification plan = plan_simplification(whole, at_scale(scale));

        Scene shuffled = whole;
        std::shuffle(shuffled.solids.begin(), shuffled.solids.end(), random);
        EXPECT_EQ(plan_simplification(shuffled, at_scale(scale)), plan) << "round " << round;

        if (plan.changes_nothing()) continue;
        const Scene felt = simplified(whole, plan), felt_shuffled = simplified(shuffled, plan);
        std::vector<Plane> cut;
        if (plan.widened() > 0) cut = plan.openings[0].cut();
        for (int i = 0; i < 4000; ++i) {
            const Vec3 p =
                far + Vec3(-0.5 + 9.0 * unit(random), (i % 2 ? 5.7 + 0.8 * unit(random) : 13.0 * unit(random)),
                           -0.5 + 3.5 * unit(random));
            const auto left_out = [&](const Solid& s) {
                return std::find(plan.left_out.begin(), plan.left_out.end(), s.feature) != plan.left_out.end();
            };
            bool near_border = false, wanted = false;
            const auto in_cut = !cut.empty() && std::all_of(cut.begin(), cut.end(), [&](const Plane& plane) {
                return signed_distance(plane, p) < 0.0;
            });
            for (const Plane& plane : cut) near_border = near_border || std::abs(signed_distance(plane, p)) < 1e-5;
            for (const Solid& solid : whole.solids) {
                if (solid.feature == rooms.door || left_out(solid)) continue;
                for (const Plane& plane : solid.shape.planes)
                    near_border = near_border || std::abs(signed_distance(plane, p)) < 1e-5;
                const bool wall = whole.features[solid.feature.value].kind == FeatureKind::Wall;
                wanted = wanted || (contains(solid.shape, p) && !(wall && in_cut));
            }
            if (near_border) continue;
            EXPECT_EQ(is_solid(felt, p, false), wanted)
                << "round " << round << " at " << p.x - far.x << " " << p.y - far.y << " " << p.z - far.z;
            EXPECT_EQ(is_solid(felt_shuffled, p, false), wanted);
            // With door leaves included, the leaf must close the opening from jamb to jamb, at the leaf's own depth and
            // height.
            const bool in_leaf = in_cut && p.y > far.y + 6.0 && p.y < far.y + 6.05 && p.z < far.z + 2.08;
            EXPECT_EQ(is_solid(felt, p), wanted || in_leaf || (!in_cut && is_solid(felt, p)));
        }
        for (const Solid& solid : felt.solids) {
            EXPECT_EQ(solid.face_features.size(), solid.shape.planes.size());
            EXPECT_EQ(solid.face_materials.size(), solid.shape.planes.size());
            EXPECT_EQ(solid.face_hidden.size(), solid.shape.planes.size());
        }
    }
}

TEST(SimplifyScene, omits_a_placed_thing_and_keeps_the_numbers_of_all_others) {
    TwoRooms rooms;
    Scene world = *with_placed(rooms.scene(), "crumb", *box_model({0.1, 0.1, 0.1}), {{1, 1, 0.05}, {}, 1.0}, "");
    world = *with_placed(world, "crate", *box_model({1.5, 1.5, 1.0}), {{6, 3, 0.5}, {}, 1.0}, "");
    const Simplification plan = plan_simplification(world, at_scale(kBuilding));
    EXPECT_EQ(plan.left_out, std::vector<FeatureId>{world.placed[0].feature});
    const auto haptic = compile_haptic(simplified(world, plan), exploring(0.0));
    ASSERT_EQ(haptic->bodies.size(), 2U);
    EXPECT_EQ(haptic->bodies[0].feature, world.placed[0].feature);
    EXPECT_TRUE(haptic->bodies[0].shape->obstacles.empty());
    EXPECT_EQ(haptic->bodies[1].shape->obstacles.size(), 1U);
}

TEST(SimplifyScene, widens_every_door_of_the_house_at_building_scale) {
    auto house = read_world(test::project_root() / "worlds/maps/house.map");
    ASSERT_TRUE(house);
    const Simplification plan = plan_simplification(*house, at_scale(kBuilding));
    EXPECT_EQ(plan.openings.size(), 11U);
    for (const NarrowOpening& o : plan.openings) {
        EXPECT_TRUE(o.widened() && !o.stays_narrow())
            << house->features[o.doors[0].value].name << " " << o.felt_width_m();
        EXPECT_NEAR(o.top_m - o.floor_m, 2.1, 0.01);
        EXPECT_NEAR(o.back_m - o.front_m, o.along.x == 1.0 ? 0.4 : 0.3, 1e-6) << "the wall and its frames";
    }
    const auto names_at = [&](double scale) {
        std::vector<std::string> names;
        for (const FeatureId id : plan_simplification(*house, at_scale(scale)).left_out)
            names.push_back(house->features[id.value].name);
        return names;
    };
    EXPECT_EQ(names_at(kBuilding), (std::vector<std::string>{"Coat stand", "Filing cabinet", "Globe's stand", "Toilet",
                                                             "Upper basin", "Music stand"}));
    EXPECT_EQ(names_at(60.0), std::vector<std::string>{"Globe's stand"});
    EXPECT_TRUE(names_at(15.0).empty());
}

}  // namespace simplify_scene_test
}  // namespace handrail
