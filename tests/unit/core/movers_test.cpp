// Tests doors, lifts, buttons and teleporters: how a map defines them, how they move, and how the session uses them.
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/unit/core/app_session.h"
#include "worlds/scene/models.h"

namespace handrail {
namespace movers_test {

using test::box_brush;
using test::entity;
using test::key;

std::shared_ptr<const Scene> world(const std::string& entities, bool game = false) {
    const std::string room = test::room_brushes(0, 0, 0, 320, 640, 128);
    const std::string base = entity("info_player_start", key("origin", "160 32 24") + key("angle", "90"));
    auto scene = read_quake_map(
        entity("worldspawn", key("message", "Hall") + key("building", game ? "0" : "1"), room) + base + entities,
        "movers.map", {});
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().sentence());
    EXPECT_TRUE(scene->report.warnings.empty()) << scene->report.warnings.front().sentence();
    return std::make_shared<const Scene>(std::move(*scene));
}

// A wall across the hall, which is 10 m wide, 2 m ahead of the base. It has a doorway 1 m wide.
const std::string kWall = entity(
    "func_wall", key("name", "cross wall"),
    box_brush(0, 96, 0, 144, 104, 128) + box_brush(176, 96, 0, 320, 104, 128) + box_brush(144, 96, 72, 176, 104, 128));
std::string door(const std::string& keys) { return entity("func_door", keys, box_brush(144, 98, 0, 176, 102, 72)); }

struct Walk : test::AppSession {
    explicit Walk(std::shared_ptr<const Scene> scene) { app.apply(WorldEntered{make_ready(std::move(scene))}, 0.0); }
};

TEST(Movers, a_hinged_door_of_a_building_swings_out_of_its_opening) {
    struct Case {
        const char *hinge, *opens;
        Vec3 far_edge_m;  // middle of the far edge of the open leaf
    };
    for (const Case& c : {Case{"west", "north", {4.5, 4.1875, 0}}, Case{"east", "north", {5.5, 4.1875, 0}},
                          Case{"west", "south", {4.5, 2.0625, 0}}, Case{"east", "south", {5.5, 2.0625, 0}}}) {
        const auto scene = world(kWall + door(key("hinge", c.hinge) + key("opens", c.opens)));
        ASSERT_EQ(scene->movers.size(), 1U);
        const Mover& mover = scene->movers[0];
        EXPECT_LT(mover.wait_s, 0.0) << "a building's door stays as it was left";
        std::vector<int> thing;
        const Scene apart = with_movers_apart(*scene, 128, thing);
        ASSERT_EQ(thing, std::vector<int>{0});
        EXPECT_TRUE(std::none_of(apart.solids.begin(), apart.solids.end(),
                                 [&](const Solid& s) { return s.feature == mover.feature; }));
        // The closed leaf is where the file puts it. The open leaf leaves the opening free except for its own
        // thickness.
        const PlacedFrame closed(mover.at(0.0)), open(mover.at(1.0));
        Aabb shut, wide;
        for (const Polygon& face : apart.placed[0].model->solids[0].shape.faces)
            for (const Vec3& p : face.points_m) {
                shut.include(closed.to_world(p));
                wide.include(open.to_world(p));
            }
        EXPECT_NEAR(glm::length(shut.min_m - Vec3(4.5, 3.0625, 0.0)), 0.0, 1e-12) << c.hinge << c.opens;
        EXPECT_NEAR(glm::length(shut.max_m - Vec3(5.5, 3.1875, 2.25)), 0.0, 1e-12);
        EXPECT_NEAR(wide.size_m().y, 1.0, 1e-12);
        EXPECT_NEAR(wide.size_m().x, 0.125, 1e-12);
        EXPECT_GE(wide.min_m.x, 4.5 - 1e-12) << "it never turns into the wall";
        EXPECT_LE(wide.max_m.x, 5.5 + 1e-12);
        EXPECT_NEAR(std::abs(c.far_edge_m.y - (std::string(c.opens) == "north" ? wide.max_m.y : wide.min_m.y)), 0.0,
                    1e-12)
            << c.hinge << c.opens;
    }
}

TEST(Movers, a_door_blocks_the_walker_until_it_is_used_and_again_after_a_second_use) {
    Walk walk(world(kWall + door(key("name", "Oak door") + key("hinge", "west"))));
    walk.walk(5.0);
    EXPECT_NEAR(walk.app.feet_m().y, 3.0625 - 0.25, 0.01);
    walk.tap(Command::Use, 2.0);
    EXPECT_TRUE(walk.heard("Oak door opens"));
    walk.walk(3.0);
    EXPECT_GT(walk.app.feet_m().y, 5.0);
    walk.app.apply(Placed{{5.0, 2.4, 0.0}, 0.0}, walk.now);
    walk.tap(Command::Use, 2.0);
    EXPECT_TRUE(walk.heard("Oak door is shut"));
    walk.walk(3.0);
    EXPECT_LT(walk.app.feet_m().y, 3.0);
    EXPECT_EQ(walk.count(SoundKind::DoorMoves), 1);
    EXPECT_EQ(walk.count(SoundKind::DoorShuts), 1);
}

TEST(Movers, a_door_that_would_shut_on_the_walker_opens_again) {
    Walk walk(world(kWall + door(key("name", "Oak door") + key("hinge", "west"))));
    walk.app.apply(Placed{{5.0, 2.4, 0.0}, 0.0}, walk.now);
    walk.tap(Command::Use, 2.0);
    walk.app.apply(Placed{{5.0, 3.1, 0.0}, 0.0}, walk.now);  // The walker is placed on the threshold.
    walk.tap(Command::Use, 4.0);
    EXPECT_TRUE(walk.heard("touched you"));
    EXPECT_FALSE(walk.heard("is shut"));
    walk.walk(2.0);
    EXPECT_GT(walk.app.feet_m().y, 4.0) << "nobody is held by it";
}

// A walker that has opened a door steps round its leaf in order to shut it again.
TEST(Movers, a_door_shuts_past_a_walker_in_its_swing_but_not_in_its_opening) {
    Walk walk(world(kWall + door(key("name", "Oak door") + key("hinge", "west") + key("opens", "north"))));
    walk.app.apply(Placed{{5.0, 2.4, 0.0}, 0.0}, walk.now);
    walk.tap(Command::Use, 2.0);
    const Vec3 in_swing_m(5.0, 3.75, 0.0);
    walk.app.apply(Placed{in_swing_m, kPi}, walk.now);
    walk.tap(Command::Use, 4.0);
    EXPECT_TRUE(walk.heard("Oak door is shut")) << walk.news();
    EXPECT_FALSE(walk.heard("touched you"));
    EXPECT_NEAR(glm::length(walk.app.feet_m() - in_swing_m), 0.0, 0.05) << "it moves nobody";
}

TEST(Movers, the_use_command_reports_if_no_door_or_button_is_in_reach) {
    Walk walk(world({}));
    walk.tap(Command::Use);
    EXPECT_TRUE(walk.heard("no door or button within reach"));
}

TEST(Movers, game_doors_rise_when_the_walker_comes_near_and_close_automatically) {
    Walk walk(world(kWall + door(key("angle", "-1") + key("speed", "200")), true));
    const Mover& mover = walk.app.scene()->movers.at(0);
    EXPECT_EQ(mover.slide_m, Vec3(0, 0, (72.0 - 8.0) / 32.0));
    walk.walk(7.0);
    EXPECT_GT(walk.app.feet_m().y, 5.0) << "through the door without a key";
    walk.run(6.0);
    EXPECT_TRUE(walk.heard("Door is shut"));
}

TEST(Movers, a_button_opens_only_the_door_with_its_name_and_nothing_else_opens_it) {
    const std::string button =
        entity("func_button", key("target", "gate") + key("angle", "90") + key("name", "Red button"),
               box_brush(150, 60, 0, 170, 64, 48));
    const std::string gate =
        door(key("angle", "-1") + key("targetname", "gate") + key("wait", "-1") + key("name", "Gate"));
    Walk walk(world(kWall + gate + button, true));
    ASSERT_EQ(walk.app.scene()->movers.size(), 2U);
    walk.app.apply(Placed{{5.0, 2.5, 0.0}, 0.0}, walk.now);
    walk.tap(Command::Use, 1.0);
    EXPECT_TRUE(walk.heard("Gate, plaster is locked. Red button") || walk.heard("is locked. Red button"));
    EXPECT_TRUE(walk.heard(" opens it, ")) << "and where it is";
    walk.app.apply(Placed{{5.0, 1.0, 0.0}, 0.0}, walk.now);
    walk.walk(1.5);  // The walker walks against the button.
    walk.run(3.0);
    EXPECT_TRUE(walk.heard("Red button pressed"));
    EXPECT_TRUE(walk.heard("Gate opens"));
    walk.app.apply(Placed{{5.0, 2.4, 0.0}, 0.0}, walk.now);
    walk.walk(3.0);
    EXPECT_GT(walk.app.feet_m().y, 4.5);
}

TEST(Movers, a_locked_door_announces_its_button_when_bumped_and_opens_with_it_from_anywhere) {
    const std::string button =
        entity("func_button", key("target", "gate") + key("angle", "90") + key("name", "Red button"),
               box_brush(150, 600, 0, 170, 604, 48));
    // The gate has flag 32 and no `wait`, so it stays open.
    const std::string gate =
        door(key("angle", "-1") + key("targetname", "gate") + key("spawnflags", "32") + key("name", "Gate"));
    Walk walk(world(kWall + gate + button, true));
    walk.walk(4.0);
    EXPECT_TRUE(walk.heard("is locked. Red button"));
    walk.app.apply(Placed{{5.0, 18.2, 0.0}, 0.0}, walk.now);  // The walker is placed 15 m beyond the gate.
    walk.tap(Command::Use, 4.0);
    EXPECT_TRUE(walk.heard("Red button pressed"));
    EXPECT_TRUE(walk.heard("Gate opens"));
    walk.run(10.0);
    EXPECT_FALSE(walk.heard("Gate is shut"));
    walk.app.apply(Placed{{5.0, 2.4, 0.0}, 0.0}, walk.now);
    walk.walk(3.0);
    EXPECT_GT(walk.app.feet_m().y, 4.5);
}

TEST(Movers, a_lift_waits_below_and_carries_a_walker_who_steps_on) {
    const std::string lift = entity("func_plat", key("name", "Lift"), box_brush(96, 64, 0, 224, 192, 64));
    Walk walk(world(lift, true));
    const Mover& mover = walk.app.scene()->movers.at(0);
    EXPECT_TRUE(mover.rests_far);
    EXPECT_NEAR(mover.slide_m.z, -(64.0 - 8.0) / 32.0, 1e-12);
    EXPECT_LT(walk.app.feet_m().z, 0.1);
    walk.walk(2.5);  // The walker walks onto the lift.
    double highest = 0.0;
    for (int i = 0; i < 300; ++i) {
        walk.run(1.0 / 60.0);
        highest = std::max(highest, walk.app.feet_m().z);
    }
    EXPECT_NEAR(highest, 2.0, 0.02) << "up to where the file has it";
    EXPECT_TRUE(walk.heard("Lift stops"));
}

TEST(Movers, a_teleporter_leads_to_its_target) {
    const std::string there = entity("info_teleport_destination",
                                     key("targetname", "far") + key("origin", "160 560 24") + key("angle", "270"));
    const std::string volume =
        entity("trigger_teleport", key("target", "far"), box_brush(96, 64, 0, 224, 96, 96, "trigger"));
    Walk walk(world(volume + there, true));
    walk.walk(3.0);
    EXPECT_NEAR(std::abs(wrap_angle(walk.app.heading_rad() - kPi)), 0.0, 1e-9);
    EXPECT_GT(walk.app.feet_m().y, 12.0);
    EXPECT_TRUE(walk.heard("door took you somewhere else"));
}

TEST(Movers, a_teleporter_without_a_target_is_reported_with_its_line) {
    const std::string volume =
        entity("trigger_teleport", key("target", "nowhere"), box_brush(96, 64, 0, 224, 96, 96, "trigger"));
    const auto scene =
        read_quake_map(entity("worldspawn", {}, test::room_brushes(0, 0, 0, 320, 640, 128)) + volume, "t.map", {});
    ASSERT_TRUE(scene);
    ASSERT_EQ(scene->report.warnings.size(), 1U);
    EXPECT_NE(scene->report.warnings[0].sentence().find("nowhere"), std::string::npos);
    EXPECT_GT(scene->report.warnings[0].line, 1);
}

// A moving leaf pushes a hand that is held against it, evenly and without knocks. The test checks the body frames of
// the session.
TEST(Movers, poses_of_a_swinging_leaf_follow_each_other_closely) {
    Walk walk(world(kWall + door(key("hinge", "west"))));
    walk.app.apply(Placed{{5.0, 2.4, 0.0}, 0.0}, walk.now);
    walk.app.apply(CommandDown{Command::Use}, walk.now);
    Placement last = walk.app.bodies().poses()[0].at;
    double farthest = 0.0;
    int frames = 0;
    for (int i = 0; i < 120; ++i) {
        walk.run(1.0 / 60.0);
        const Placement now = walk.app.bodies().poses()[0].at;
        if (!(now == last)) ++frames;
        farthest = std::max(farthest, farthest_travel_m(last, now, 1.0));
        last = now;
    }
    EXPECT_GT(frames, 60);
    EXPECT_LT(farthest, 0.05) << "1.3 m/s at the far edge";
}

// In the bundled house, the walker opens every door, passes it in both directions, and shuts it behind itself.
TEST(Movers, every_door_of_our_house_can_be_used_from_both_sides) {
    auto scene = read_world(test::project_root() / "worlds" / "maps" / "house.map");
    ASSERT_TRUE(scene);
    const auto house = std::make_shared<const Scene>(std::move(*scene));
    ASSERT_EQ(house->movers.size(), 11U);
    for (std::size_t i = 0; i < house->movers.size(); ++i) {
        const Feature& door = house->features[house->movers[i].feature.value];
        const Vec3 size = door.bounds_m.size_m(), middle = door.bounds_m.centre_m();
        const Vec3 through = size.x > size.y ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
        for (const double side : {-1.0, 1.0}) {
            SCOPED_TRACE(door.name + (side < 0 ? " from the south or west" : " from the north or east"));
            Walk walk(house);
            const Vec3 from = Vec3(middle.x, middle.y, door.bounds_m.min_m.z) + through * (0.65 * side);
            walk.app.apply(Placed{from, std::atan2(-through.x * side, -through.y * side)}, walk.now);
            walk.run(0.3);
            walk.walk(1.0);
            EXPECT_GT(glm::dot(walk.app.feet_m() - middle, through) * side, 0.0) << "shut";
            walk.tap(Command::Use, 1.6);
            EXPECT_TRUE(walk.heard(sentence_case(door.name) + " opens"));
            walk.walk(1.4);
            EXPECT_LT(glm::dot(walk.app.feet_m() - middle, through) * side, -0.5) << "open";
            EXPECT_NEAR(walk.app.feet_m().z, door.bounds_m.min_m.z, 0.1) << "on the same floor";
        }
    }
}

TEST(Movers, the_stairs_of_our_house_lead_to_the_landing) {
    auto scene = read_world(test::project_root() / "worlds" / "maps" / "house.map");
    ASSERT_TRUE(scene);
    Walk walk(std::make_shared<const Scene>(std::move(*scene)));
    walk.app.apply(Placed{{5.3, 2.6, 0.0}, 0.0}, walk.now);
    walk.walk(7.0);
    EXPECT_NEAR(walk.app.feet_m().z, 2.9, 0.01);
    EXPECT_GT(walk.app.feet_m().y, 7.6);
}

}  // namespace movers_test
}  // namespace handrail
