// Tests the C header. It must refuse invalid input and give the same result as the C++ renderer, and its tick must not
// allocate.
#include "haptic/c/handrail.h"

#include <limits>
#include <memory>

#include "haptic/compile/compile_haptic.h"
#include "haptic/render/touch.h"
#include "tests/support/count_allocations.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace c_header_test {

const std::string kHouse = test::bundled_world("house.map");

using World = std::unique_ptr<handrail_world, void (*)(handrail_world*)>;
using Hand = std::unique_ptr<handrail_hand, void (*)(handrail_hand*)>;
World read(const std::string& path) { return {handrail_world_read(path.c_str(), nullptr, 0), handrail_world_free}; }
Hand hand_in(const World& world, const handrail_feel& feel) {
    return {handrail_hand_new(world.get(), &feel), handrail_hand_free};
}
handrail_feel default_feel() {
    handrail_feel feel;
    handrail_feel_default(&feel);
    return feel;
}
handrail_touch tick(const Hand& hand, double x, double y, double z) {
    handrail_touch touch;
    touch.size = sizeof touch;
    const double place_m[3] = {x, y, z};
    handrail_hand_tick(hand.get(), place_m, 1e-3, &touch);
    return touch;
}

TEST(CHeader, feels_bit_identical_to_the_renderer_once_the_force_has_ramped_in) {
    const World world = read(kHouse);
    ASSERT_TRUE(world);
    double at_m[3];
    ASSERT_EQ(handrail_world_start(world.get(), at_m), 1);
    handrail_feel feel = default_feel();
    feel.ceiling_n = std::numeric_limits<double>::infinity();
    const Hand hand = hand_in(world, feel);
    ASSERT_TRUE(hand);

    const Result<Scene> scene = read_world(kHouse);
    const auto felt = compile_haptic(*scene, MaterialSource::Library);
    TouchState state;
    bool touched = false;
    for (int i = 0; i < 4000; ++i) {
        // The hand stands still for 1.1 seconds. Then it moves down and along the ground by up to a tenth of a
        // millimetre a tick.
        const double moved = std::max(0, i - 1100) * 1e-4;
        const double x = at_m[0] + 0.3 * moved, y = at_m[1] + moved, z = at_m[2] + std::max(0.004, 0.05 - moved);
        const TouchResult expected = touch_tick(state, *felt, TouchTuning{}, {x, y, z}, 1e-3);
        const handrail_touch touch = tick(hand, x, y, z);
        EXPECT_EQ(touch.contacts, expected.contacts.count);
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_EQ(touch.ball_m[axis], expected.proxy_m[axis]) << i;
            ASSERT_TRUE(i <= 1100 || touch.force_n[axis] == expected.force_n[axis]) << i;
        }
        if (touch.contacts == 0) continue;
        touched = true;
        EXPECT_EQ(touch.feature, expected.contacts.contacts[expected.contacts.strongest].feature.value);
    }
    EXPECT_TRUE(touched);
}

TEST(CHeader, ramps_the_force_in_below_the_ceiling_and_removes_it_on_request) {
    const World world = read(kHouse);
    double at_m[3];
    handrail_world_start(world.get(), at_m);
    handrail_feel feel = default_feel();
    feel.ceiling_n = 0.5;
    const Hand hand = hand_in(world, feel);
    tick(hand, at_m[0], at_m[1], at_m[2] + 0.02);
    double last_n = 0.0;
    for (int i = 0; i < 1100; ++i) {
        const double force_n = tick(hand, at_m[0], at_m[1], at_m[2] - 0.02).force_n[2];
        EXPECT_LE(force_n, 0.5 + 1e-12);
        EXPECT_GE(force_n, last_n - 1e-9);
        EXPECT_LE(force_n, last_n + 0.001);
        last_n = force_n;
    }
    EXPECT_NEAR(last_n, 0.5, 1e-9);
    handrail_hand_set_flow(hand.get(), HANDRAIL_CUT);
    EXPECT_EQ(tick(hand, at_m[0], at_m[1], at_m[2] - 0.02).force_n[2], 0.0);
    handrail_hand_set_flow(hand.get(), HANDRAIL_RUN);
    EXPECT_LT(tick(hand, at_m[0], at_m[1], at_m[2] - 0.02).force_n[2], 0.01);
}

TEST(CHeader, gives_no_force_for_an_invalid_position_and_ramps_afterwards) {
    const World world = read(kHouse);
    double at_m[3];
    handrail_world_start(world.get(), at_m);
    const Hand hand = hand_in(world, default_feel());
    tick(hand, at_m[0], at_m[1], at_m[2] + 0.02);
    for (int i = 0; i < 1100; ++i) tick(hand, at_m[0], at_m[1], at_m[2] + 0.001);
    EXPECT_GT(tick(hand, at_m[0], at_m[1], at_m[2] + 0.001).force_n[2], 1.0);
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 2e6}) {
        const handrail_touch touch = tick(hand, at_m[0], bad, at_m[2]);
        EXPECT_EQ(touch.refused, 1U);
        EXPECT_EQ(touch.force_n[2], 0.0);
        EXPECT_EQ(touch.feature, HANDRAIL_NO_FEATURE);
    }
    const handrail_touch after = tick(hand, at_m[0], at_m[1], at_m[2] + 0.001);
    EXPECT_EQ(after.refused, 0U);
    EXPECT_LT(after.force_n[2], 0.01);
}

TEST(CHeader, allocates_nothing_in_a_tick) {
    const World world = read(kHouse);
    double at_m[3];
    handrail_world_start(world.get(), at_m);
    const Hand hand = hand_in(world, default_feel());
    const long before = allocations;
    for (int i = 0; i < 500; ++i) tick(hand, at_m[0] + i * 1e-4, at_m[1], i % 50 ? at_m[2] : std::nan(""));
    EXPECT_EQ(allocations, before);
}

TEST(CHeader, describes_a_file_error_in_one_sentence_that_fits_the_buffer) {
    char error[400];
    EXPECT_EQ(handrail_world_read("/nowhere/house.map", error, sizeof error), nullptr);
    EXPECT_NE(std::string(error).find("house.map"), std::string::npos) << error;
    char small[8];
    EXPECT_EQ(handrail_world_read("/nowhere/house.map", small, sizeof small), nullptr);
    EXPECT_EQ(std::string(small), std::string(error).substr(0, 7));
    EXPECT_EQ(handrail_world_read(nullptr, error, sizeof error), nullptr);
    EXPECT_EQ(handrail_world_from_map("{ \"classname\" ", 14, error, sizeof error), nullptr);
    EXPECT_NE(std::string(error), "");
    EXPECT_EQ(handrail_world_from_map(nullptr, 0, nullptr, 0), nullptr);
}

TEST(CHeader, refuses_a_feel_struct_that_is_out_of_range_or_of_another_size) {
    const World world = read(kHouse);
    const handrail_feel good = default_feel();
    const auto refused = [&](auto change) {
        handrail_feel feel = good;
        change(feel);
        return !hand_in(world, feel);
    };
    EXPECT_FALSE(refused([](handrail_feel&) {}));
    EXPECT_TRUE(refused([](handrail_feel& feel) { feel.size -= 8; }));
    EXPECT_TRUE(refused([](handrail_feel& feel) { feel.radius_m = std::nan(""); }));
    EXPECT_TRUE(refused([](handrail_feel& feel) { feel.world_m_per_hand_m = 0.0; }));
    EXPECT_TRUE(refused([](handrail_feel& feel) { feel.friction_kinetic = feel.friction_static + 0.1; }));
    EXPECT_TRUE(refused([](handrail_feel& feel) { feel.ceiling_n = -1.0; }));
    EXPECT_EQ(handrail_hand_new(nullptr, &good), nullptr);
    EXPECT_EQ(handrail_hand_new(world.get(), nullptr), nullptr);
    const Hand hand = hand_in(world, good);
    handrail_feel bad = good;
    bad.damping_ns_per_m = -1.0;
    EXPECT_EQ(handrail_hand_set_feel(hand.get(), &bad), 0);
    EXPECT_EQ(handrail_hand_set_feel(hand.get(), &good), 1);
}

TEST(CHeader, names_the_touched_thing_and_can_free_the_world_before_the_hand) {
    World world = read(kHouse);
    double at_m[3];
    handrail_world_start(world.get(), at_m);
    const Hand hand = hand_in(world, default_feel());
    tick(hand, at_m[0], at_m[1], at_m[2] + 0.02);
    const handrail_touch touch = tick(hand, at_m[0], at_m[1], at_m[2]);
    ASSERT_NE(touch.feature, HANDRAIL_NO_FEATURE);
    char name[100];
    const std::size_t length = handrail_world_name(world.get(), touch.feature, name, sizeof name);
    EXPECT_GT(length, 0U);
    EXPECT_EQ(std::string(name).size(), length);
    char cut[3];
    EXPECT_EQ(handrail_world_name(world.get(), touch.feature, cut, sizeof cut), length);
    EXPECT_EQ(std::string(cut), std::string(name).substr(0, 2));
    world.reset();
    EXPECT_GT(tick(hand, at_m[0], at_m[1], at_m[2]).contacts, 0U);
    EXPECT_EQ(handrail_api_version(), static_cast<std::uint32_t>(HANDRAIL_API_VERSION));
}

}  // namespace c_header_test
}  // namespace handrail
