// Tests trains, turning parts, and lifts with doors and buttons: who rides on them, and what they do when they meet a
// walker or each other.
#include <random>

#include "app/core/world/mover_meeting.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/core/app_session.h"
#include "tests/unit/core/explorer.h"
#include "worlds/scene/models.h"

namespace handrail {
namespace moving_things_test {

using test::box_brush;
using test::entity;
using test::key;

// Makes a hall of 10 by 20 m, 6 m high; one unit is 1/32 m. The base is 1 m from its south wall at x = 5 m and faces
// north.
std::shared_ptr<const Scene> hall(const std::string& entities, bool game = false,
                                  const std::string& more_building = {}) {
    const std::string room = test::room_brushes(0, 0, 0, 320, 640, 192) + more_building;
    const std::string base = entity("info_player_start", key("origin", "160 32 24") + key("angle", "90"));
    auto scene = read_quake_map(
        entity("worldspawn", key("message", "Hall") + key("building", game ? "0" : "1"), room) + base + entities,
        "moving.map", {});
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().sentence());
    EXPECT_TRUE(scene->report.warnings.empty()) << scene->report.warnings.front().sentence();
    return std::make_shared<const Scene>(std::move(*scene));
}

struct Rider : test::AppSession {
    explicit Rider(std::shared_ptr<const Scene> scene, const Vec3& feet_m = {5.0, 1.0, 0.0}) {
        app.apply(WorldEntered{make_ready(std::move(scene))}, 0.0);
        app.apply(Placed{feet_m, 0.0}, 0.0);
    }
    void turn_round() {
        const double before = app.heading_rad();
        for (int i = 0; i < 24 && std::abs(wrap_angle(app.heading_rad() - before)) < kPi - 0.05; ++i)
            tap(Command::TurnRight, 0.3);
    }
    Placement thing(std::size_t i) const { return app.bodies().poses()[i].at; }
    bool in_something() const {
        return WalkerWorld(app.scene(), places()).blocked(app.feet_m() + Vec3(0.0, 0.0, 1e-3), {0.25, 1.6});
    }
    std::vector<Placement> places() const {
        std::vector<Placement> all;
        for (std::size_t i = 0; i < app.scene()->placed.size(); ++i) all.push_back(thing(i));
        return all;
    }
    // Returns the greatest height of the soles during `seconds`. Checks that the walker is never inside a solid.
    double highest_m(double seconds) {
        double highest = app.feet_m().z;
        for (const double until = now + seconds; now < until;) {
            run(1.0 / 60.0);
            highest = std::max(highest, app.feet_m().z);
            EXPECT_FALSE(in_something()) << "at " << now << " s";
        }
        return highest;
    }
};

// A lift that rises 2 m. At the bottom, its top is level with the floor of the hall. Another brush of the floor is at
// the same level and farther east. The code once mistook that brush for the ground under the walker.
const std::string kLevelLift =
    entity("func_plat", key("name", "Lift") + key("height", "64"), box_brush(96, 96, 0, 224, 224, 64));
const std::string kFloorPlate = box_brush(100, 70, -8, 250, 250, 0);

TEST(Riding, starts_on_a_lift_whose_top_is_level_with_the_floor) {
    Rider rider(hall(kLevelLift, true, kFloorPlate));
    rider.walk(2.5);
    EXPECT_NEAR(rider.highest_m(3.0), 2.0, 0.02);
    EXPECT_TRUE(rider.heard("Lift stops at the top"));
    // The walker stays on the lift, so the lift waits at the top. When the walker has been placed elsewhere, the lift
    // goes down again.
    rider.app.apply(Placed{{5.0, 1.0, 0.0}, 0.0}, rider.now);
    rider.run(12.0);
    EXPECT_TRUE(rider.heard("Lift is back"));
}

TEST(Riding, carries_a_body_with_a_hand_and_its_workspace) {
    test::Explorer rider(hall(kLevelLift, true, kFloorPlate), "sim-t");
    const auto above_soles_m = [&] { return rider.tool().proxy_m.z - rider.app().feet_m().z; };
    const double before_m = above_soles_m();
    rider.app().apply(Placed{{5.0, 5.0, 0.0}, 0.0}, rider.now_s());
    EXPECT_TRUE(rider.wait_for([&] { return rider.app().feet_m().z > 1.99; }, 4.0));
    rider.run(0.3);
    EXPECT_NEAR(above_soles_m(), before_m, 0.02);
}

TEST(Riding, ends_by_stepping_off_above_and_the_lift_then_goes_down_empty) {
    const std::string ledge = entity("func_wall", key("name", "ledge"), box_brush(96, 224, 0, 224, 400, 64));
    Rider rider(hall(kLevelLift + ledge, true));
    rider.app.apply(Placed{{5.0, 5.5, 0.0}, 0.0}, rider.now);
    rider.run(0.6);
    rider.walk(2.2);
    EXPECT_GT(rider.app.feet_m().y, 7.3);
    rider.run(6.0);
    EXPECT_NEAR(rider.app.feet_m().z, 2.0, 0.01);
    EXPECT_TRUE(rider.heard("Lift is back"));
}

TEST(Riding, pulls_a_walker_with_a_foot_over_the_edge_of_a_descending_lift_completely_onto_it) {
    // The top of the lift is level with a floor 2 m up around its shaft. The lift moves when it is called, and waits at
    // the top for the time in the map.
    const std::string shaft = box_brush(0, 0, 0, 96, 640, 64) + box_brush(224, 0, 0, 320, 640, 64) +
                              box_brush(96, 0, 0, 224, 96, 64) + box_brush(96, 224, 0, 224, 640, 64);
    const std::string lift =
        entity("func_plat", key("name", "Lift") + key("height", "64") + key("targetname", "lift") + key("speed", "40"),
               box_brush(96, 96, 56, 224, 224, 64));
    Rider rider(hall(lift, true, shaft), {5.0, 3.1, 2.0});
    rider.run(0.2);
    rider.tap(Command::Use, 0.0);
    double lowest = 9.0;
    for (int i = 0; i < 150; ++i) {
        rider.run(1.0 / 60.0);
        lowest = std::min(lowest, rider.app.feet_m().z);
        ASSERT_FALSE(rider.in_something()) << i;
    }
    EXPECT_NEAR(lowest, 0.0, 0.02);
    EXPECT_GE(rider.app.feet_m().y, 3.25 - 1e-6);
}

TEST(Meeting, a_lift_under_a_low_ceiling_goes_back_and_does_not_retry_while_the_walker_stands_on_it) {
    // There is a beam at a height of 3.1 m.
    const std::string low = entity("func_wall", key("name", "beam"), box_brush(90, 90, 100, 230, 230, 128));
    Rider rider(hall(kLevelLift + low, true));
    rider.app.apply(Placed{{5.0, 5.0, 0.0}, 0.0}, rider.now);
    const double highest = rider.highest_m(10.0);
    EXPECT_GT(highest, 1.2) << "up to where the head is at the beam";
    EXPECT_LE(highest, 100.0 / 32.0 - 1.7);
    EXPECT_TRUE(rider.heard("Lift touched you and is going back"));
    EXPECT_EQ(std::count_if(rider.said.begin(), rider.said.end(),
                            [](const std::string& s) { return s.find("touched you") != std::string::npos; }),
              1);
    EXPECT_NEAR(rider.app.feet_m().z, 0.0, 0.02);
}

TEST(Meeting, a_lift_that_comes_down_on_the_walker_goes_back_up) {
    const std::string lift = entity(
        "func_plat",
        key("name", "Lift") + key("height", "96") + key("targetname", "lift") + key("wait", "1") + key("speed", "40"),
        box_brush(96, 96, 88, 224, 224, 96));
    const std::string button = entity("func_button", key("target", "lift") + key("name", "Button") + key("angle", "90"),
                                      box_brush(150, 20, 30, 170, 22, 40));
    Rider rider(hall(lift + button, true));
    rider.app.apply(Placed{{5.0, 1.2, 0.0}, kPi}, rider.now);
    rider.tap(Command::Use, 0.0);
    rider.app.apply(Placed{{5.0, 5.0, 0.0}, 0.0}, rider.now);
    for (int i = 0; i < 300; ++i) {
        rider.run(1.0 / 60.0);
        ASSERT_FALSE(rider.in_something()) << i;
    }
    EXPECT_TRUE(rider.heard("Lift touched you and is going back"));
    EXPECT_NEAR(rider.app.feet_m().z, 0.0, 0.02);
}

// ---- trains ----

std::string corner(const std::string& name, const std::string& next, const std::string& origin,
                   const std::string& more = {}) {
    return entity("path_corner", key("targetname", name) + key("target", next) + key("origin", origin) + more);
}
// A platform of 2 by 2 m with a thickness of 0.25 m, which moves round a square of 4 m at 1 m a second.
const std::string kTrack = corner("a", "b", "32 32 16") + corner("b", "c", "160 32 16", key("wait", "2")) +
                           corner("c", "d", "160 160 16") + corner("d", "a", "32 160 16");
std::string train(const std::string& more = {}) {
    return entity("func_train", key("name", "Car") + key("target", "a") + key("speed", "32") + more,
                  box_brush(0, 0, 0, 64, 64, 8));
}

TEST(Trains, go_from_stop_to_stop_wait_as_the_map_says_and_start_again) {
    Rider rider(hall(train() + kTrack, true), {9.0, 18.0, 0.0});
    const Mover& mover = rider.app.scene()->movers.at(0);
    ASSERT_EQ(mover.stops.size(), 4U);
    EXPECT_EQ(mover.after_last, 0);
    // The corner of the platform with the least coordinates follows the corners of the path: 4 m per side, with a stop
    // of 2 s at the second corner.
    struct At {
        double s;
        Vec3 there_m;
    };
    for (const At& at : {At{2.0, {3, 1, 0.5}}, At{5.0, {5, 1, 0.5}}, At{7.0, {5, 2, 0.5}}, At{12.0, {3, 5, 0.5}},
                         At{16.0, {1, 3, 0.5}}, At{20.0, {3, 1, 0.5}}}) {
        rider.run(at.s - rider.now);
        EXPECT_NEAR(glm::length(rider.thing(0).position_m - at.there_m), 0.0, 0.05) << "at " << at.s << " s";
    }
}

TEST(Trains, carry_walkers_round_and_announce_stops_to_them) {
    Rider rider(hall(train() + kTrack, true), {2.0, 2.0, 0.75});
    rider.run(0.1);
    const Vec3 on_it = rider.app.feet_m() - rider.thing(0).position_m;
    for (int i = 0; i < 18; ++i) {
        rider.run(1.0);
        const Vec3 now_on_it = rider.app.feet_m() - rider.thing(0).position_m;
        EXPECT_NEAR(glm::length(now_on_it - on_it), 0.0, 0.02) << "after " << i << " s";
    }
    EXPECT_TRUE(rider.heard("Car stops"));
    EXPECT_TRUE(rider.heard("Car moves"));
}

TEST(Trains, without_a_way_back_stay_at_the_last_stop) {
    Rider rider(hall(train() + corner("a", "b", "32 32 16") + corner("b", "", "96 32 16"), true), {9.0, 18.0, 0.0});
    rider.run(10.0);
    EXPECT_NEAR(rider.thing(0).position_m.x, 3.0, 1e-9);
}

TEST(Trains, that_are_a_target_of_another_entity_wait_for_it) {
    const std::string button = entity("func_button", key("target", "car") + key("name", "Button") + key("angle", "90"),
                                      box_brush(280, 580, 30, 300, 582, 40));
    Rider rider(hall(train(key("targetname", "car")) + kTrack + button, true), {9.0, 17.5, 0.0});
    rider.run(3.0);
    EXPECT_NEAR(rider.thing(0).position_m.x, 1.0, 1e-9);
    rider.tap(Command::Use, 2.0);
    EXPECT_GT(rider.thing(0).position_m.x, 2.0);
}

TEST(Trains, without_two_corners_are_reported_with_their_line_and_stand_still) {
    const auto scene = read_quake_map(entity("worldspawn", {}, test::room_brushes(0, 0, 0, 320, 640, 128)) + train() +
                                          corner("a", "nowhere", "32 32 16"),
                                      "t.map", {});
    ASSERT_TRUE(scene);
    ASSERT_EQ(scene->report.warnings.size(), 1U);
    EXPECT_NE(scene->report.warnings[0].sentence().find("path_corner"), std::string::npos);
    EXPECT_GT(scene->report.warnings[0].line, 1);
    EXPECT_FALSE(scene->movers.at(0).moves());
}

// A wall across the hall with an opening 3 m wide and 3 m high, and a track of 12 m through the opening.
const std::string kGate = entity("func_wall", key("name", "gate wall"),
                                 box_brush(0, 304, 0, 112, 320, 128) + box_brush(208, 304, 0, 320, 320, 128) +
                                     box_brush(112, 304, 96, 208, 320, 128));
const std::string kThrough = corner("a", "b", "128 160 16") + corner("b", "a", "128 544 16");

TEST(Trains, pass_a_doorway_with_their_passenger_and_wait_for_a_walker_in_it) {
    Rider rider(hall(train() + kThrough + kGate, true), {5.0, 6.0, 0.75});
    rider.run(12.3);
    EXPECT_GT(rider.app.feet_m().y, 17.0) << "through the doorway";
    EXPECT_TRUE(rider.bumped.empty());
    // Now a person stands in the doorway. The train comes back and waits in front of them.
    rider.app.apply(Placed{{5.0, 9.75, 0.0}, 0.0}, rider.now);
    for (int i = 0; i < 900; ++i) {
        rider.run(1.0 / 60.0);
        ASSERT_FALSE(rider.in_something()) << i;
    }
    EXPECT_TRUE(rider.heard("Car touched you and is waiting"));
    EXPECT_NEAR(rider.app.feet_m().y, 9.75, 1e-6) << "it pushes nobody";
    EXPECT_GT(rider.thing(0).position_m.y, 9.9);
    rider.app.apply(Placed{{9.0, 9.0, 0.0}, 0.0}, rider.now);
    rider.run(4.0);
    EXPECT_LT(rider.thing(0).position_m.y, 8.0) << "and goes on when they are gone";
}

TEST(Meeting, a_train_waits_at_a_shut_door_until_it_is_opened) {
    // The door comes before the train in the file. It slides up by its height less 8 units, which leaves 2.75 m free.
    // The car of the train is 0.75 m high.
    const std::string door =
        entity("func_door", key("name", "Gate") + key("angle", "-1") + key("wait", "20") + key("targetname", "gate"),
               box_brush(112, 308, 0, 208, 316, 96));
    const std::string button = entity("func_button", key("target", "gate") + key("name", "Button") + key("angle", "90"),
                                      box_brush(280, 580, 30, 300, 582, 40));
    Rider rider(hall(door + train() + kThrough + kGate + button, true), {9.0, 17.5, 0.0});
    rider.run(12.0);
    const double before_m = 308.0 / 32.0 - 2.0;
    EXPECT_NEAR(rider.thing(1).position_m.y, before_m, 0.05);
    rider.tap(Command::Use, 5.0);
    EXPECT_GT(rider.thing(1).position_m.y, before_m + 2.0);
}

TEST(Meeting, the_earlier_of_two_movers_proceeds_and_the_later_waits_and_goes_back) {
    // Two sliding leaves whose paths cross at a right angle. Each has a button, and both buttons are pressed at the
    // same time.
    const auto leaf = [](const char* name, const char* angle, const std::string& box) {
        return entity("func_door",
                      key("name", name) + key("angle", angle) + key("speed", "32") + key("lip", "0") +
                          key("targetname", name) + key("wait", "30") + key("spawnflags", "4"),
                      box);
    };
    const std::string east = leaf("East", "0", box_brush(64, 320, 32, 128, 336, 64)),
                      north = leaf("North", "90", box_brush(136, 240, 32, 152, 304, 64));
    const std::string trigger =
        entity("trigger_multiple", key("target", "East"), box_brush(260, 560, 0, 300, 600, 64, "trigger")) +
        entity("trigger_multiple", key("target", "North"), box_brush(260, 560, 0, 300, 600, 64, "trigger"));
    Rider rider(hall(east + north + trigger, true), {5.0, 18.0, 0.0});
    rider.app.apply(Placed{{8.75, 18.1, 0.0}, 0.0}, rider.now);
    double farthest_north = 0.0;
    for (int i = 0; i < 480; ++i) {
        rider.run(1.0 / 60.0);
        const Scene& scene = *rider.app.scene();
        ASSERT_FALSE(things_meet(*scene.placed[0].model, rider.thing(0), *scene.placed[1].model, rider.thing(1))) << i;
        farthest_north = std::max(farthest_north, rider.thing(1).position_m.y);
    }
    EXPECT_NEAR(rider.thing(0).position_m.x, (96.0 + 64.0) / 32.0, 1e-9) << "the earlier has its way";
    EXPECT_LT(farthest_north, 272.0 / 32.0 + 1.0) << "the later waited before it";
    EXPECT_NEAR(rider.thing(1).position_m.y, 272.0 / 32.0, 1e-9) << "and went back";
}

// ---- turning parts ----

std::string turner(const std::string& more, const std::string& brushes) {
    return entity("func_rotating", key("name", "Paddle") + more, brushes);
}

TEST(TurningParts, turn_with_their_speed_about_the_axis_in_their_flags) {
    struct Case {
        const char* flags;
        Vec3 axis;
        double sign;
    };
    for (const Case& c : {Case{"1", {0, 0, 1}, 1.0}, Case{"3", {0, 0, 1}, -1.0}, Case{"5", {1, 0, 0}, 1.0},
                          Case{"9", {0, 1, 0}, 1.0}}) {
        Rider rider(
            hall(turner(key("speed", "30") + key("spawnflags", c.flags), box_brush(140, 300, 60, 180, 310, 70)), true),
            {9.0, 1.0, 0.0});
        rider.run(4.0 - rider.now);
        const Rotation wanted = rotation_about(c.axis, c.sign * radians_from_degrees(120.0)),
                       is = rider.thing(0).rotation;
        const double alike = std::abs(wanted.w * is.w + wanted.x * is.x + wanted.y * is.y + wanted.z * is.z);
        EXPECT_GT(alike, std::cos(radians_from_degrees(1.0))) << c.flags;
    }
}

TEST(TurningParts, turn_about_the_centre_of_their_origin_brush) {
    const auto scene = hall(turner(key("speed", "30"), box_brush(140, 300, 60, 180, 310, 70) +
                                                           box_brush(138, 303, 63, 142, 307, 67, "origin")),
                            true);
    EXPECT_NEAR(glm::length(scene->movers.at(0).pivot_m - Vec3(140, 305, 65) / 32.0), 0.0, 1e-12);
}

TEST(TurningParts, carry_and_turn_a_walker_who_stands_on_them) {
    Rider rider(hall(turner(key("speed", "20"), box_brush(64, 224, 0, 256, 416, 4)), true), {7.0, 10.0, 0.3});
    rider.run(0.2);
    const Vec3 middle{5.0, 10.0, 0.125};
    const Vec3 began = rider.app.feet_m() - middle;
    const double angle = std::atan2(began.y, began.x), heading = rider.app.heading_rad(),
                 turned_before = std::atan2(rider.thing(0).rotation.z, rider.thing(0).rotation.w) * 2.0;
    rider.run(3.0);
    const Vec3 now = rider.app.feet_m() - middle;
    const double turned = std::atan2(rider.thing(0).rotation.z, rider.thing(0).rotation.w) * 2.0 - turned_before;
    EXPECT_NEAR(turned, radians_from_degrees(60.0), 0.02);
    EXPECT_NEAR(std::hypot(now.x, now.y), 2.0, 0.01);
    EXPECT_NEAR(wrap_angle(std::atan2(now.y, now.x) - angle - turned), 0.0, 0.02);
    EXPECT_NEAR(wrap_angle(rider.app.heading_rad() - heading + turned), 0.0, 1e-6) << "to the left, as it turns";
}

TEST(TurningParts, wait_for_a_walker_who_blocks_them) {
    // The arm is 4 m long, at the height of the hip. The person stands where the arm passes after a quarter of a turn.
    Rider rider(hall(turner(key("speed", "45"), box_brush(96, 316, 28, 224, 324, 36)), true), {5.0, 11.5, 0.0});
    for (int i = 0; i < 300; ++i) {
        rider.run(1.0 / 60.0);
        ASSERT_FALSE(rider.in_something()) << i;
    }
    EXPECT_TRUE(rider.heard("Paddle touched you and is waiting"));
    const Placement waits = rider.thing(0);
    rider.run(1.0);
    EXPECT_TRUE(rider.thing(0) == waits);
    rider.app.apply(Placed{{9.0, 1.0, 0.0}, 0.0}, rider.now);
    rider.run(1.0);
    EXPECT_FALSE(rider.thing(0) == waits);
}

TEST(TurningParts, are_felt_as_they_pass_and_push_the_hand) {
    // A flat arm sweeps over the hand. Four ends of arms pass in each turn, so one comes within a second.
    test::Explorer person(
        hall(turner(key("speed", "60"), box_brush(128, 60, 30, 192, 68, 50) + box_brush(156, 32, 30, 164, 96, 50)),
             true),
        "sim-t");
    person.app().apply(Placed{{5.0, 0.5, 0.0}, 0.0}, person.now_s());
    double strongest_n = 0.0;
    bool named = false;
    const FeatureId arm = person.app().scene()->movers.at(0).feature;
    for (int i = 0; i < 240 && !named; ++i) {
        for (double z = -0.02; z <= 0.021 && !named; z += 0.02) {
            person.hold({0.0, 0.03, z});
            person.run(0.1);
            strongest_n = std::max(strongest_n, glm::length(person.tool().force_n));
            named = person.tool().touches() && person.tool().touched() == arm && strongest_n > 0.1;
        }
    }
    EXPECT_TRUE(named) << strongest_n << " N";
}

// ---- a lift of a building ----

// Makes two storeys 3 m apart. Each has a button, and a door that opens only while the lift is there.
std::shared_ptr<const Scene> two_storeys(const std::string& more = {}) {
    const std::string upper = box_brush(0, 0, 88, 320, 128, 96) + box_brush(0, 176, 88, 320, 640, 96) +
                              box_brush(0, 128, 88, 136, 176, 96) + box_brush(184, 128, 88, 320, 176, 96);
    const std::string lift = entity("func_plat", key("name", "Lift") + key("targetname", "lift") + key("height", "96"),
                                    box_brush(137, 129, 92, 183, 175, 96));
    std::string doors;
    for (const double z : {0.0, 96.0}) {
        doors += entity("func_door",
                        key("name", z == 0.0 ? "Lower lift door" : "Upper lift door") + key("lift", "lift") +
                            key("angle", "180") + key("lip", "0") + key("wait", "2"),
                        box_brush(144, 122, z, 176, 124, z + 60));
        doors +=
            entity("func_button",
                   key("name", z == 0.0 ? "Lower button" : "Upper button") + key("target", "lift") + key("angle", "90"),
                   box_brush(180, 119, z + 32, 184, 120, z + 36));
    }
    return hall(lift + doors + more, false, upper);
}

TEST(LiftsOfBuildings, are_called_by_door_and_buttons_and_open_a_door_only_at_their_storey) {
    Rider rider(two_storeys(), {5.0, 2.9, 0.0});
    const Scene& scene = *rider.app.scene();
    ASSERT_EQ(scene.movers.size(), 5U);
    ASSERT_TRUE(scene.movers[0].rests_far);
    const auto height = [&] { return rider.thing(0).position_m.z; };
    const double below = height();
    const auto open = [&](std::size_t door) { return rider.thing(door).position_m.x < 4.5; };
    rider.run(5.0);
    EXPECT_EQ(height(), below);
    EXPECT_FALSE(open(1)) << "shut until somebody wants it";
    rider.tap(Command::Use, 1.5);
    EXPECT_TRUE(open(1));
    EXPECT_TRUE(rider.heard("Lower lift door opens"));
    rider.run(5.0);
    EXPECT_FALSE(open(1)) << "it shuts by itself";
    // A walker on the upper storey calls the lift by its button.
    rider.app.apply(Placed{{182.0 / 32.0, 3.2, 3.0}, 0.0}, rider.now);
    rider.tap(Command::Use, 0.0);
    EXPECT_TRUE(rider.heard("Upper button pressed"));
    for (int i = 0; i < 400; ++i) {
        rider.run(1.0 / 60.0);
        if (std::abs(height() - below) > 1e-9) {
            ASSERT_FALSE(open(1));
        }
        if (std::abs(height() - below - 3.0) > 1e-9) {
            ASSERT_EQ(rider.thing(2).position_m.x, 5.0);
        }
    }
    EXPECT_NEAR(height() - below, 3.0, 1e-9);
    EXPECT_TRUE(rider.heard("Lift stops at the top"));
    EXPECT_TRUE(rider.heard("Upper lift door opens"));
}

TEST(LiftsOfBuildings, carry_the_walker_up_by_keys_alone_and_lock_nobody_in) {
    Rider rider(two_storeys(), {5.0, 2.9, 0.0});
    rider.tap(Command::Use, 1.5);
    rider.walk(2.0);
    EXPECT_GT(rider.app.feet_m().y, 4.2) << "in the cabin";
    rider.run(10.0);
    EXPECT_LT(rider.thing(1).position_m.x, 4.5) << "open as long as somebody is in it who has not sent it off";
    rider.tap(Command::Use, 8.0);
    EXPECT_NEAR(rider.app.feet_m().z, 3.0, 0.02);
    EXPECT_TRUE(rider.heard("Lift stops at the top"));
    rider.turn_round();
    rider.walk(2.5);
    EXPECT_LT(rider.app.feet_m().y, 3.6) << "out through the upper door";
    EXPECT_NEAR(rider.app.feet_m().z, 3.0, 0.02);
}

TEST(LiftsOfBuildings, wait_with_an_open_door_while_the_walker_stands_in_it) {
    Rider rider(two_storeys(), {5.0, 2.9, 0.0});
    rider.tap(Command::Use, 1.5);
    rider.app.apply(Placed{{5.0, 123.0 / 32.0, 0.0}, 0.0}, rider.now);
    const double below = rider.thing(0).position_m.z;
    // Another person calls the lift from above.
    rider.run(0.5);
    rider.run(20.0);
    EXPECT_EQ(rider.thing(0).position_m.z, below);
    EXPECT_FALSE(rider.in_something());
}

TEST(LiftsOfBuildings, report_a_door_whose_lift_is_missing) {
    const auto scene = read_quake_map(
        entity("worldspawn", key("building", "1"), test::room_brushes(0, 0, 0, 320, 640, 128)) +
            entity("func_door", key("lift", "nolift") + key("hinge", "west"), box_brush(144, 122, 0, 176, 124, 60)),
        "t.map", {});
    ASSERT_TRUE(scene);
    ASSERT_EQ(scene->report.warnings.size(), 1U);
    EXPECT_NE(scene->report.warnings[0].sentence().find("nolift"), std::string::npos);
}

TEST(LiftsOfBuildings, include_one_in_our_school_that_can_be_ridden_up_and_down_by_keys_alone) {
    Rider rider(test::our_world("school.map"), {14.15, 10.2, 0.0});
    rider.run(0.2);
    for (const double floor_m : {3.4, 0.0}) {
        rider.tap(Command::Use, 2.0);
        rider.walk(2.2);
        ASSERT_GT(rider.app.feet_m().y, 11.2) << "in the cabin";
        rider.tap(Command::Use, 9.0);
        EXPECT_NEAR(rider.app.feet_m().z, floor_m, 0.02);
        rider.turn_round();
        rider.walk(2.0);
        rider.turn_round();
        ASSERT_LT(rider.app.feet_m().y, 10.7) << "in the corridor";
        EXPECT_NEAR(rider.app.feet_m().z, floor_m, 0.02);
        rider.run(8.0);  // Wait until the door of the lift is shut again.
    }
}

// ---- contacts between things ----

TEST(ThingsMeet, agrees_with_boxes_and_never_separates_shapes_that_share_a_point) {
    std::mt19937 random(20260);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    const auto cube = *box_model({1.0, 0.6, 1.4});
    int met = 0;
    for (int i = 0; i < test::scaled(4000); ++i) {
        const bool turned = i % 2 == 1;
        const Placement a{{0.0, 0.0, 0.0},
                          turned ? normalized({part(random), part(random), part(random), part(random)}) : Rotation{},
                          1.0};
        const Placement b{Vec3(part(random), part(random), part(random)) * 2.0,
                          turned ? normalized({part(random), part(random), part(random), part(random)}) : Rotation{},
                          1.0};
        const bool said = things_meet(*cube, a, *cube, b);
        met += said ? 1 : 0;
        EXPECT_EQ(said, things_meet(*cube, b, *cube, a)) << i;
        if (!turned) {
            const Vec3 gap = glm::abs(b.position_m) - Vec3(1.0, 0.6, 1.4);
            EXPECT_EQ(said, std::max({gap.x, gap.y, gap.z}) <= -kMeetingDepth_m) << i;
            continue;
        }
        const PlacedFrame one(a), other(b);
        bool shared = false;
        for (double x = -0.48; x < 0.49 && !shared; x += 0.08)
            for (double y = -0.28; y < 0.29 && !shared; y += 0.08)
                for (double z = -0.68; z < 0.69 && !shared; z += 0.08) {
                    const Vec3 in_other = other.to_own(one.to_world({x, y, z}));
                    shared = std::abs(in_other.x) < 0.48 && std::abs(in_other.y) < 0.28 && std::abs(in_other.z) < 0.68;
                }
        EXPECT_TRUE(said || !shared) << i;
    }
    EXPECT_GT(met, test::scaled(100));
}

TEST(WalkerWorld, updated_from_its_predecessor_equals_one_built_from_scratch) {
    const auto scene = [] {
        std::vector<int> apart;
        return std::make_shared<const Scene>(with_movers_apart(*test::our_world("house.map"), 128, apart));
    }();
    const WalkerWorld first(scene);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int round = 0; round < 4; ++round) {
        std::vector<Placement> places;
        for (std::size_t i = 0; i < scene->placed.size(); ++i) places.push_back(scene->movers[i].at(part(random)));
        const WalkerWorld made_on(first, scene, places), anew(scene, places);
        for (int i = 0; i < test::scaled(3000); ++i) {
            const auto somewhere = [&] {
                return scene->bounds_m.min_m +
                       scene->bounds_m.size_m() * Vec3(part(random), part(random), part(random));
            };
            const Vec3 from = somewhere(), to = i % 2 ? somewhere() : from + Vec3(part(random), part(random), 0.0);
            const TraceHit a = made_on.trace(from, to, {0.25, 1.8}), b = anew.trace(from, to, {0.25, 1.8});
            ASSERT_EQ(a.end_m, b.end_m);
            ASSERT_EQ(a.feature, b.feature);
            ASSERT_EQ(made_on.blocked(from, {0.25, 1.8}), anew.blocked(from, {0.25, 1.8}));
        }
    }
}

}  // namespace moving_things_test
}  // namespace handrail
