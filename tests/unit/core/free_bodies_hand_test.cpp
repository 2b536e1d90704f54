// A device's hand and the things that are free to move, in the whole program on a virtual clock: it pushes, takes,
// turns, drops and feels them, and what it does is told.
#include <random>

#include "tests/support/map_text.h"
#include "tests/support/random_families.h"
#include "tests/support/scale.h"
#include "tests/unit/core/explorer.h"

namespace handrail {
namespace free_bodies_hand_test {

using test::box_brush;
using test::entity;
using test::key;

std::shared_ptr<const Scene> hall(const std::string& entities) {
    const std::string room = test::room_brushes(0, 0, 0, 256, 256, 128);
    const std::string base = entity("info_player_start", key("origin", "128 32 24") + key("angle", "90"));
    auto scene = read_quake_map(
        entity("worldspawn", key("message", "Hall") + key("building", "1"), room) + base + entities, "hall.map", {});
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().sentence());
    return std::make_shared<const Scene>(std::move(*scene));
}

// A box of half a metre on the floor, its middle that far east and north.
std::string box(const std::string& name, double kg, double east_m, double north_m) {
    const double x = 32.0 * east_m, y = 32.0 * north_m;
    return entity("thing", key("cs_name", "dynamic_box") + key("name", name) + key("mass", std::to_string(kg)),
                  box_brush(x - 8, y - 8, 0, x + 8, y + 8, 16));
}
std::string ball(const std::string& name, double east_m, double north_m) {
    const double x = 32.0 * east_m, y = 32.0 * north_m;
    return entity("thing", key("cs_name", "dynamic_sphere") + key("name", name) + key("mass", "1"),
                  box_brush(x - 6, y - 6, 0, x + 6, y + 6, 12));
}

// Without a desk, whose sliders a random hand would move.
Settings without_a_desk() {
    Settings settings;
    settings.desk.use = false;
    return settings;
}

struct Hand : test::Explorer {
    explicit Hand(const std::string& entities) : Explorer(hall(entities), "sim-t", without_a_desk()) {}
    // The device's point goes to a place of the world.
    void to(const Vec3& world_m, double speed_m_per_s = 0.05) {
        const HandOutput told = app().hand();
        hold((world_m - told.pose.origin_m) / told.tuning.touch.world_m_per_hand_m, speed_m_per_s);
    }
    Vec3 at(const std::string& name) { return app().thing_at(name).value_or(Placement{}).position_m; }
    Rotation turned(const std::string& name) { return app().thing_at(name).value_or(Placement{}).rotation; }
};

TEST(HandOnBodies, there_is_no_engine_for_a_hand_where_nothing_is_free) {
    Hand hand("");
    EXPECT_EQ(hand.app().hand().engine, nullptr);
    EXPECT_EQ(hand.app().free_bodies().engine(), nullptr);
}

TEST(HandOnBodies, a_pushed_crate_goes_along_and_again_with_the_same_bits) {
    std::array<Placement, 2> ends;
    std::array<Vec3, 2> forces;
    for (int run = 0; run < 2; ++run) {
        Hand hand(box("Crate", 2.0, 4.0, 2.5));
        hand.to({4.0, 1.9, 0.25});
        hand.to({4.1, 3.0, 0.3}, 0.004);
        forces[run] = hand.tool().force_n;
        hand.to({4.1, 2.0, 0.3}, 0.02);
        hand.run(1.0);
        ends[run] = hand.app().thing_at("Crate").value_or(Placement{});
        EXPECT_GT(ends[run].position_m.y, 2.9);
        EXPECT_NEAR(ends[run].position_m.z, 0.25, 3e-3);
        EXPECT_TRUE(hand.heard("Crate"));
    }
    EXPECT_EQ(ends[0], ends[1]);
    EXPECT_EQ(forces[0], forces[1]);
}

TEST(HandOnBodies, the_key_takes_what_the_hand_touches_turns_it_and_lets_it_go) {
    Hand hand(box("Crate", 1.0, 4.0, 2.5));
    hand.to({4.0, 1.9, 0.25});
    hand.to({4.0, 2.16, 0.25}, 0.01);
    ASSERT_TRUE(hand.tool().touches());
    hand.tap(Command::Use, 0.2);
    EXPECT_TRUE(hand.heard("Crate held, 1 kilogram.")) << hand.all_heard();
    EXPECT_EQ(hand.app().free_bodies().held_by_hand(0), hand.app().world().scene->bodies[0].feature);
    hand.to({4.0, 2.16, 1.0}, 0.005);
    hand.run(4.0);
    EXPECT_NEAR(hand.at("Crate").z, 0.25 + 0.75, 0.2) << "lifted, and its weight draws at the grip";
    hand.tap(Command::WorkspaceTurnLeft, 2.0);
    EXPECT_TRUE(hand.heard("A quarter turn to the left."));
    const Rotation turned = hand.turned("Crate");
    EXPECT_NEAR(std::abs(turned.w), std::sqrt(0.5), 0.05) << turned.w << " " << turned.z;
    hand.tap(Command::Use, 0.2);
    EXPECT_TRUE(hand.heard("Crate let go."));
    hand.run(1.5);
    EXPECT_NEAR(hand.at("Crate").z, 0.25, 0.01);
    EXPECT_EQ(hand.app().free_bodies().held_by_hand(0), kNoFeature);
}

TEST(HandOnBodies, what_is_too_heavy_slips_out_of_the_grip_and_says_its_weight) {
    Hand hand(box("Safe", 20.0, 4.0, 2.5));
    hand.to({4.0, 1.9, 0.25});
    hand.to({4.0, 2.16, 0.25}, 0.01);
    hand.button(true);
    EXPECT_TRUE(hand.heard("Safe held, 20 kilograms.")) << hand.all_heard();
    hand.to({4.0, 2.16, 3.4}, 0.02);
    hand.run(0.5);
    EXPECT_TRUE(hand.heard("Safe. Heavy, 20 kilograms.")) << hand.all_heard();
    EXPECT_LT(hand.at("Safe").z, 0.4);
    EXPECT_EQ(hand.app().free_bodies().held_by_hand(0), kNoFeature);
}

TEST(HandOnBodies, a_crate_that_falls_on_the_hand_is_felt) {
    Hand hand(box("Crate", 2.0, 4.0, 1.8));
    hand.to({6.0, 3.0, 1.0});
    hand.tap(Command::Use, 0.3);  // by the keyboard: what stands before one
    ASSERT_TRUE(hand.heard("Crate held, 2 kilograms.")) << hand.all_heard();
    for (int i = 0; i < 6; ++i) hand.tap(Command::TiltUp, 0.8);
    ASSERT_GT(hand.at("Crate").z, 1.2);
    hand.to({hand.at("Crate").x, hand.at("Crate").y, 0.6}, 0.02);
    ASSERT_FALSE(hand.tool().touches());
    hand.tap(Command::Use, 0.0);
    double felt_n = 0.0;
    for (int i = 0; i < 1000; ++i) {
        hand.run(1e-3);
        felt_n = std::max(felt_n, -hand.tool().force_n.z);
    }
    EXPECT_GT(felt_n, 0.5);
    EXPECT_LE(felt_n, 2.5 + 1e-9);
    EXPECT_TRUE(hand.heard("Crate let go."));
}

TEST(HandOnBodies, random_pushes_grips_and_drops_leave_all_in_the_hall_and_no_force_above_the_ceiling) {
    const std::uint32_t seed = test::seed_of_run();
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::string things;
    for (int i = 0; i < 12; ++i) {
        const double east = 1.5 + 1.6 * (i % 4), north = 2.2 + 1.8 * (i / 4);
        const std::string name = "Thing " + std::to_string(i);
        things += i % 3 == 0 ? ball(name, east, north) : box(name, 0.3 + 20.0 * part(random), east, north);
    }
    Hand hand(things);
    const char* const all = std::getenv("HANDRAIL_ACTS");
    const int acts = all ? std::atoi(all) : test::scaled(60);
    int held = 0;
    double most_n = 0.0;
    bool down = false;
    for (int act = 0; act < acts; ++act) {
        const Vec3 thing = hand.at("Thing " + std::to_string(static_cast<int>(part(random) * 12)));
        const Vec3 beside = 0.6 * Vec3(part(random) - 0.5, part(random) - 0.5, 0.5 * part(random));
        hand.to(part(random) < 0.6 ? thing + beside : Vec3(1.0 + 6.0 * part(random), 1.0 + 5.0 * part(random), 1.0),
                0.01 + 0.06 * part(random));
        most_n = std::max(most_n, glm::length(hand.tool().force_n));
        if (part(random) < 0.5) hand.button(down = !down);
        if (part(random) < 0.2) hand.tap(Command::Use);
        if (part(random) < 0.1) hand.tap(Command::WorkspaceTurnRight);
        if (part(random) < 0.05) hand.tap(Command::PutBack);
        held += hand.tool().holds != kNoBody;
        for (int i = 0; i < 12; ++i) {
            const Vec3 at = hand.at("Thing " + std::to_string(i));
            ASSERT_TRUE(at.x > 0.0 && at.x < 8.0 && at.y > 0.0 && at.y < 8.0 && at.z > 0.0 && at.z < 4.0)
                << "act " << act << ", thing " << i << " at " << at.x << " " << at.y << " " << at.z;
        }
    }
    EXPECT_LE(most_n, 2.5 + 1e-9);
    fmt::print("{} acts, something held after {} of them\n", acts, held);
    EXPECT_TRUE(held > 0 || acts < 1000);
}

}  // namespace free_bodies_hand_test
}  // namespace handrail
