// Tests freely movable things in a session: the walker pushes them, and keys grip, move, lift, turn and drop them. They
// stop where the hand, the walker or a mover meets them.
#include <algorithm>
#include <random>

#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/unit/core/app_session.h"
#include "worlds/navigation/navigation.h"

namespace handrail {
namespace free_bodies_test {

using test::box_brush;
using test::entity;
using test::key;

// Makes a hall of 10 by 20 m. The walker starts in the south, a metre from the wall, and faces north.
std::shared_ptr<const Scene> hall(const std::string& entities) {
    const std::string room = test::room_brushes(0, 0, 0, 320, 640, 128);
    const std::string base = entity("info_player_start", key("origin", "160 32 24") + key("angle", "90"));
    auto scene = read_quake_map(
        entity("worldspawn", key("message", "Hall") + key("building", "1"), room) + base + entities, "hall.map", {});
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().sentence());
    EXPECT_TRUE(scene->report.warnings.empty()) << scene->report.warnings.front().sentence();
    return std::make_shared<const Scene>(std::move(*scene));
}

// Returns the map text of a box of half a metre with its middle this far east and north.
std::string box(const char* name, double kg, double east_m, double north_m, const std::string& more = {}) {
    const double x = 32.0 * east_m, y = 32.0 * north_m;
    return entity("thing", key("cs_name", "dynamic_box") + key("name", name) + key("mass", std::to_string(kg)) + more,
                  box_brush(x - 8, y - 8, 0, x + 8, y + 8, 16));
}
std::string ball(double radius_m, double east_m, double north_m) {
    const double x = 32.0 * east_m, y = 32.0 * north_m, r = 32.0 * radius_m;
    return entity("thing", key("cs_name", "dynamic_sphere") + key("name", "Ball") + key("mass", "0.5"),
                  box_brush(x - r, y - r, 0, x + r, y + r, 2 * r));
}

struct Walk : test::AppSession {
    explicit Walk(std::shared_ptr<const Scene> scene) { app.apply(WorldEntered{make_ready(std::move(scene))}, 0.0); }
    Vec3 at(const char* name) const { return app.thing_at(name).value_or(Placement{}).position_m; }
    // Returns true if the walker's cylinder overlaps nothing.
    bool stands_free() const {
        return !app.world().solids->blocked(app.feet_m(), {walker_size(*app.scene(), 0.25).radius_m - 1e-3, 1.5});
    }
};

TEST(FreeBodies, a_light_crate_moves_with_the_walker_who_pushes_it_and_never_overlaps_the_walker) {
    Walk walk(hall(box("Crate", 4.0, 5.0, 4.0)));
    walk.app.apply(CommandDown{Command::Forward}, walk.now);
    for (int i = 0; i < 300; ++i) {
        walk.run(1.0 / 60.0);
        ASSERT_TRUE(walk.stands_free()) << i;
    }
    walk.app.apply(CommandUp{Command::Forward}, walk.now);
    walk.run(3.0);
    EXPECT_GT(walk.app.feet_m().y, 5.0) << "farther than where it stood";
    EXPECT_GT(walk.at("Crate").y, walk.app.feet_m().y + 0.25 + 0.25 - 0.01);
    EXPECT_NEAR(walk.at("Crate").z, 0.25, 2e-3);
    EXPECT_EQ(std::count(walk.said.begin(), walk.said.end(), "Crate moves with you."), 1) << "when it begins";
    EXPECT_TRUE(walk.bumped.empty()) << "what gives way is no bump";
}

TEST(FreeBodies, a_safe_stops_the_walker_and_its_weight_is_announced) {
    Walk walk(hall(box("Safe", 400.0, 5.0, 4.0)));
    walk.walk(5.0);
    EXPECT_NEAR(walk.app.feet_m().y, 4.0 - 0.25 - 0.25, 0.01);
    EXPECT_NEAR(walk.at("Safe").y, 4.0, 1e-3);
    EXPECT_TRUE(walk.heard("Safe. Heavy, 400 kilograms."));
    EXPECT_EQ(walk.bumped.size(), 1U);
}

TEST(FreeBodies, a_ball_too_low_to_stop_a_foot_is_kicked_rather_than_stepped_on) {
    Walk walk(hall(ball(0.11, 5.0, 3.0)));
    walk.walk(3.0);
    EXPECT_LT(walk.app.feet_m().z, 0.02);
    EXPECT_GT(walk.at("Ball").y, walk.app.feet_m().y + 0.25) << "ahead of the feet";
    EXPECT_NEAR(walk.at("Ball").z, 0.11, 2e-3);
}

TEST(FreeBodies, a_body_pushed_against_a_wall_blocks_the_walker) {
    Walk walk(hall(box("Crate", 4.0, 5.0, 18.0)));
    walk.app.apply(Placed{{5.0, 16.0, 0.0}, 0.0}, walk.now);
    walk.walk(8.0);
    EXPECT_NEAR(walk.at("Crate").y, 20.0 - 0.25, 0.01);
    EXPECT_NEAR(walk.app.feet_m().y, 20.0 - 0.5 - 0.25, 0.02);
    EXPECT_TRUE(walk.stands_free());
    EXPECT_FALSE(walk.bumped.empty());
}

TEST(FreeBodies, what_overlaps_the_body_stops_it_with_a_bump_and_lets_it_leave) {
    Walk walk(hall(box("Safe", 400.0, 5.0, 4.0)));
    walk.app.apply(Placed{{5.0, 3.52, 0.0}, 0.0}, walk.now);
    walk.walk(1.0);
    EXPECT_LT(walk.app.feet_m().y, 3.53) << "not farther in";
    EXPECT_NEAR(walk.at("Safe").y, 4.0, 0.03);
    EXPECT_EQ(walk.bumped, std::vector<FeatureId>{walk.app.world().scene->bodies[0].feature}) << "once";
    walk.hold(Command::Back, 1.0);
    EXPECT_LT(walk.app.feet_m().y, 3.2);
}

TEST(FreeBodies, a_crate_behind_a_door_is_pushed_aside_by_its_leaf) {
    const std::string wall = entity("func_wall", key("name", "cross wall"),
                                    box_brush(0, 96, 0, 144, 104, 128) + box_brush(176, 96, 0, 320, 104, 128) +
                                        box_brush(144, 96, 72, 176, 104, 128));
    const std::string door = entity("func_door", key("name", "Oak door") + key("hinge", "west") + key("opens", "north"),
                                    box_brush(144, 98, 0, 176, 102, 72));
    Walk walk(hall(wall + door + box("Crate", 4.0, 5.3, 3.6)));
    walk.run(1.0);
    ASSERT_NEAR(walk.at("Crate").y, 3.6, 1e-3);
    walk.app.apply(Placed{{5.0, 2.4, 0.0}, 0.0}, walk.now);
    walk.tap(Command::Use, 4.0);
    ASSERT_TRUE(walk.heard("Oak door opens"));
    EXPECT_GT(walk.at("Crate").y, 3.7);
    const Vec3 there = walk.at("Crate");
    walk.run(2.0);
    EXPECT_LT(glm::length(walk.at("Crate") - there), 0.01) << "and rests there";
}

TEST(FreeBodies, keys_grip_move_lift_and_drop_a_crate) {
    Walk walk(hall(box("Crate", 2.0, 5.0, 2.0)));
    walk.tap(Command::Use, 0.3);
    ASSERT_TRUE(walk.heard("Crate held, 2 kilograms."));
    const Vec3 start = walk.at("Crate"), feet = walk.app.feet_m();
    walk.tap(Command::TurnRight, 2.0);
    EXPECT_NEAR(walk.at("Crate").x, start.x + 0.25, 0.01) << "to the right of who looks north";
    EXPECT_TRUE(walk.heard("Crate moved."));
    walk.tap(Command::Forward, 2.0);
    EXPECT_NEAR(walk.at("Crate").y, start.y + 0.25, 0.01);
    EXPECT_EQ(walk.app.feet_m(), feet) << "the arrows move what is held";
    EXPECT_NEAR(walk.app.heading_rad(), 0.0, 1e-9);
    walk.tap(Command::TiltUp, 2.0);
    EXPECT_NEAR(walk.at("Crate").z, 0.5, 0.01) << "lifted by a quarter of a metre";
    const int knocks = walk.count(SoundKind::Contact);
    walk.tap(Command::Use, 2.0);
    EXPECT_TRUE(walk.heard("Crate released."));
    EXPECT_NEAR(walk.at("Crate").z, 0.25, 2e-3) << "it has fallen";
    EXPECT_GT(walk.count(SoundKind::Contact), knocks) << "and landed";
    walk.walk(0.5);
    EXPECT_GT(walk.app.feet_m().y, feet.y) << "the arrows walk again";
}

TEST(FreeBodies, a_crate_is_turned_in_quarter_turns_and_keeps_its_orientation) {
    Walk walk(hall(entity("thing", key("cs_name", "dynamic_box") + key("name", "Plank") + key("mass", "1"),
                          box_brush(144, 60, 0, 176, 68, 4))));
    walk.tap(Command::Use, 0.3);
    walk.tap(Command::TiltUp, 2.0);
    walk.tap(Command::WorkspaceTurnLeft, 2.0);
    EXPECT_TRUE(walk.heard("A quarter turn to the left."));
    const Vec3 along = PlacedFrame(*walk.app.thing_at("Plank")).turned({1.0, 0.0, 0.0});
    EXPECT_NEAR(std::abs(along.y), 1.0, 0.02) << "it lay from west to east, and lies from south to north";
}

TEST(FreeBodies, a_body_heavier_than_the_strength_is_not_gripped) {
    Walk walk(hall(box("Trunk", 12.0, 5.0, 2.0)));
    walk.tap(Command::Use, 0.3);
    EXPECT_TRUE(walk.heard("Trunk. Heavy, 12 kilograms."));
    const Vec3 feet = walk.app.feet_m();
    walk.tap(Command::Back, 1.0);
    EXPECT_LT(walk.app.feet_m().y, feet.y) << "it is not held, so the arrows walk";
    Settings strong;
    strong.dynamics.strength_n = 200.0;
    walk.app.apply(SettingsChanged{strong}, walk.now);
    walk.walk(0.5);
    walk.tap(Command::Use, 0.3);
    EXPECT_TRUE(walk.heard("Trunk held, 12 kilograms."));
}

TEST(FreeBodies, a_carried_body_stops_at_a_wall_which_is_named) {
    Walk walk(hall(box("Crate", 2.0, 5.0, 18.9)));
    walk.app.apply(Placed{{5.0, 17.9, 0.0}, 0.0}, walk.now);
    walk.tap(Command::Use, 0.3);
    for (int i = 0; i < 6; ++i) walk.tap(Command::Forward, 2.8);
    EXPECT_NEAR(walk.at("Crate").y, 19.75, 0.01);
    EXPECT_TRUE(walk.heard("Crate stopped by ")) << walk.news();
}

TEST(FreeBodies, a_ball_rolls_two_diameters_far_and_cannot_be_lifted) {
    Walk walk(hall(ball(0.1, 5.0, 2.0)));
    walk.tap(Command::Use, 0.3);
    ASSERT_TRUE(walk.heard("Ball held, 0.5 kilograms."));
    walk.tap(Command::Forward, 2.5);
    EXPECT_NEAR(walk.at("Ball").y, 2.4, 0.02);
    walk.tap(Command::TiltUp, 0.5);
    EXPECT_TRUE(walk.heard("A ball can be rolled but not lifted."));
    EXPECT_NEAR(walk.at("Ball").z, 0.1, 2e-3);
}

TEST(FreeBodies, everything_can_be_put_back_exactly) {
    Walk walk(hall(box("Crate", 4.0, 5.0, 4.0) + ball(0.1, 4.0, 2.0)));
    const Vec3 crate = walk.at("Crate"), round = walk.at("Ball");
    walk.walk(5.0);
    EXPECT_GT(glm::length(walk.at("Crate") - crate), 0.3);
    walk.tap(Command::PutBack, 1.0);
    EXPECT_LT(glm::length(walk.at("Crate") - crate), 1e-3);
    EXPECT_LT(glm::length(walk.at("Ball") - round), 1e-3);
    EXPECT_TRUE(walk.heard("back where it was"));
}

TEST(FreeBodies, without_a_free_body_no_physics_engine_runs) {
    Walk walk(hall(entity("thing", key("name", "Table"), box_brush(144, 60, 0, 176, 68, 24))));
    EXPECT_EQ(walk.app.free_bodies().engine(), nullptr);
    EXPECT_EQ(make_ready(hall({})).moves_freely, nullptr);
    walk.tap(Command::PutBack);
    EXPECT_TRUE(walk.heard("Nothing can be moved here."));
}

TEST(FreeBodies, the_same_keys_give_bit_identical_results) {
    const auto play = [] {
        Walk walk(hall(box("Crate", 4.0, 5.0, 4.0) + ball(0.1, 5.1, 3.0)));
        walk.walk(4.0);
        walk.tap(Command::TurnRight, 0.5);
        walk.walk(1.0);
        walk.tap(Command::Use, 1.0);
        walk.tap(Command::Back, 1.0);
        return std::array{walk.at("Crate"), walk.at("Ball"), walk.app.feet_m()};
    };
    EXPECT_EQ(play(), play());
}

TEST(FreeBodies, routes_ignore_movable_things_and_go_round_fixed_ones) {
    for (const auto& [kg, leads_through] : {std::pair(4.0, true), std::pair(400.0, false)}) {
        const auto scene =
            hall(entity("thing", key("cs_name", "dynamic_box") + key("name", "Crate") + key("mass", std::to_string(kg)),
                        box_brush(0, 200, 0, 320, 216, 32)));
        const auto found = Navigation::make(*scene, WalkerMeasures{});
        ASSERT_TRUE(found);
        EXPECT_EQ((*found)->reachable({5.0, 2.0, 0.0}, {5.0, 12.0, 0.0}), leads_through) << kg;
    }
}

// The person walks at random among twenty bodies, and grips and drops them at random.
TEST(FreeBodies, random_walks_grips_and_drops_keep_all_bodies_in_the_hall_and_the_walker_outside_them) {
    const std::uint32_t seed = test::seed_of_run();
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::string things;
    for (int i = 0; i < 20; ++i) {
        const double east = 1.5 + 1.75 * (i % 5), north = 3.0 + 3.5 * (i / 5);
        things += i % 3 == 0 ? entity("thing",
                                      key("cs_name", "dynamic_sphere") + key("name", "Thing " + std::to_string(i)) +
                                          key("mass", "1"),
                                      box_brush(32 * east - 6, 32 * north - 6, 0, 32 * east + 6, 32 * north + 6, 12))
                             : box(("Thing " + std::to_string(i)).c_str(), 0.5 + 20.0 * part(random), east, north);
    }
    Walk walk(hall(things));
    const std::array keys{Command::Forward,  Command::Forward,          Command::Forward, Command::Back,
                          Command::TurnLeft, Command::TurnRight,        Command::Use,     Command::TiltUp,
                          Command::TiltDown, Command::WorkspaceTurnLeft};
    double walked_m = 0.0;
    for (int act = 0; act < 120; ++act) {
        const Vec3 before = walk.app.feet_m();
        walk.hold(keys[static_cast<std::size_t>(part(random) * keys.size())], 0.05 + 0.8 * part(random));
        walked_m += glm::length(walk.app.feet_m() - before);
        for (int i = 0; i < 20; ++i) {
            const Vec3 at = walk.at(("Thing " + std::to_string(i)).c_str());
            ASSERT_TRUE(at.x > 0.0 && at.x < 10.0 && at.y > 0.0 && at.y < 20.0 && at.z > 0.0 && at.z < 4.0)
                << "act " << act << ", thing " << i << " at " << at.x << " " << at.y << " " << at.z;
        }
        const Vec3 feet = walk.app.feet_m();
        ASSERT_TRUE(feet.x > 0.2 && feet.x < 9.8 && feet.y > 0.2 && feet.y < 19.8 && feet.z > -0.01);
        // A walker that is driven against a body overlaps the body slightly for a moment, and is then pushed off.
        ASSERT_FALSE(walk.app.world().solids->blocked(feet + Vec3(0.0, 0.0, 0.02), {0.25 - 0.03, 1.5}))
            << "act " << act;
    }
    EXPECT_GT(walked_m, 10.0) << "nobody is stuck";
}

}  // namespace free_bodies_test
}  // namespace handrail
