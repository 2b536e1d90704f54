#include "app/core/learning/hunt.h"

#include <cmath>
#include <set>

#include "app/core/scenario/session_log.h"
#include "app/core/session/session.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/newcomer.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace hunt_test {

using test::SceneBuilder;

// Makes two rooms with a doorway. The second room has a raised floor and steps up to that floor.
std::shared_ptr<const Scene> rooms() {
    SceneBuilder b;
    b.box({0, 0, -0.2}, {12, 5, 0}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
    b.box({-0.2, -0.2, 0}, {12.2, 0, 3}, "south wall");
    b.box({-0.2, 5, 0}, {12.2, 5.2, 3}, "north wall");
    b.box({-0.2, 0, 0}, {0, 5, 3}, "west wall");
    b.box({12, 0, 0}, {12.2, 5, 3}, "east wall");
    b.box({6, 0, 0}, {6.2, 3, 3}, "middle wall");
    b.box({6, 4, 0}, {6.2, 5, 3}, "middle wall");
    for (int i = 0; i < 4; ++i) b.box({9.0 + 0.4 * i, 0, 0}, {12, 5, 0.2 * (i + 1)}, "step");
    b.start({1, 1, 0}, 0.0);
    b.scene().name = "two rooms";
    return b.share();
}

TEST(Hunt, hides_the_clock_at_a_walkable_place_far_enough_away_and_leads_there) {
    const auto scene = rooms();
    const WalkerWorld world(scene);
    const WalkerSize body = walker_size(*scene, 0.25);
    HuntGround ground(world, {1, 1, 0}, body);
    std::set<std::pair<int, int>> places;
    for (std::uint64_t number = 0; number < 40; ++number) {
        HuntGround hunt = ground;
        const Vec3 clock = hunt.hiding_place(number, 6.0);
        places.emplace(static_cast<int>(clock.x * 4), static_cast<int>(clock.y * 4));
        EXPECT_FALSE(world.blocked(clock, WalkerShape{0.2, 1.5}));
        hunt.aim(clock);
        // A walker who follows the hints arrives at the clock.
        Vec3 at(1, 1, 0);
        ASSERT_TRUE(hunt.way_m(at));
        EXPECT_GE(*hunt.way_m(at), 6.0 - 1e-9);
        int legs = 0;
        while (glm::length(at - clock) > 0.3 && legs++ < 30) {
            const auto next = hunt.next_m(world, at, body);
            ASSERT_TRUE(next);
            at = *next;
        }
        EXPECT_LT(glm::length(at - clock), 0.3);
        EXPECT_TRUE(finds(world, at, clock));
    }
    EXPECT_GT(places.size(), 20U);
    EXPECT_FALSE(finds(world, {5.8, 1, 0}, {6.5, 1, 0})) << "through a wall nothing is found";
}

TEST(Hunt, hides_as_far_away_as_it_can_where_nothing_is_far_enough) {
    const auto scene = rooms();
    const WalkerWorld world(scene);
    const HuntGround ground(world, {1, 1, 0}, walker_size(*scene, 0.25));
    const Vec3 clock = ground.hiding_place(3, 1000.0);
    ASSERT_TRUE(ground.way_m(clock));
    for (std::uint64_t number = 0; number < 40; ++number)
        EXPECT_LE(*ground.way_m(ground.hiding_place(number, 0.0)), *ground.way_m(clock));
}

// Makes a floor of 4 by 4 m at height `floor_m`, with a plinth of height `plinth_m` in its middle. Returns the number
// of places in the grid of the hunt.
std::size_t places_around_a_plinth(double floor_m, double plinth_m) {
    SceneBuilder b;
    b.box({0, 0, floor_m - 0.2}, {4, 4, floor_m}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
    b.box({1.5, 1.5, floor_m}, {2.5, 2.5, floor_m + plinth_m}, "plinth");
    b.start({0.5, 0.5, floor_m}, 0.0);
    const auto scene = b.share();
    const WalkerWorld world(scene);
    return HuntGround(world, {0.5, 0.5, floor_m}, walker_size(*scene, 0.25)).size();
}

TEST(Hunt, knows_each_place_once_and_none_that_nobody_can_step_up_to) {
    const std::size_t around = places_around_a_plinth(0.0, 2.0);
    EXPECT_GT(around, 100U);
    EXPECT_EQ(places_around_a_plinth(0.0, 0.4), around) << "too high for a step";
    EXPECT_GT(places_around_a_plinth(0.0, 0.2), around) << "a step";
    EXPECT_EQ(places_around_a_plinth(0.25, 2.0), around) << "on a border between two heights of its table";
    EXPECT_EQ(places_around_a_plinth(-0.25, 2.0), around);
}

// Where the person hears the clock through open air, they follow the sound. Where walls or doors muffle it, they
// request a hint and follow that.
TEST(Hunt, is_won_in_the_house_by_a_newcomer_with_keys_and_ears_and_the_best_time_is_saved) {
    auto scene = read_world(test::project_root() / "worlds" / "maps" / "house.map");
    ASSERT_TRUE(scene);
    const auto house = std::make_shared<const Scene>(std::move(*scene));
    const test::TemporaryFolder folder;
    int by_ear_in_all = 0;
    for (int game = 0; game < 4; ++game) {
        test::Newcomer newcomer(house, folder.path());
        newcomer.wait(0.37 * game);
        newcomer.tap("X");
        EXPECT_FALSE(newcomer.listen_to(SoundKind::Clock).empty())
            << "the grandfather clock of the house ticks too, and sounds otherwise";
        EXPECT_TRUE(newcomer.listen_to(SoundKind::HiddenClock).empty());
        int followed = 0;  // number of attempts to follow the ticking
        newcomer.tap("0", 0.5);
        ASSERT_TRUE(newcomer.heard("A clock is hidden here"));
        int by_ear = 0, by_hint = 0;
        for (int turns = 0; turns < 200 && !newcomer.heard("You found the clock"); ++turns) {
            std::optional<test::Newcomer::Heard> clear;
            for (const auto& ticking : newcomer.listen_to(SoundKind::HiddenClock))
                if (ticking.muffled_db < 3.0 && followed < 12) clear = ticking;
            if (clear) {
                ++by_ear;
                ++followed;
                newcomer.obey_ears(clear->right_deg);
            } else {
                ++by_hint;
                followed = 0;
                const std::string hint = newcomer.request("0");
                if (hint.find("No walking route") != std::string::npos) newcomer.tap("Home");
                else ASSERT_TRUE(newcomer.obey(hint)) << newcomer.last_lines(3);
            }
        }
        ASSERT_TRUE(newcomer.heard("You found the clock")) << "game " << game << ": " << newcomer.last_lines(20);
        std::cout << "game " << game << ": " << by_ear << " times by ear, " << by_hint << " hints, " << newcomer.now_s()
                  << " s\n";
        by_ear_in_all += by_ear;
        EXPECT_EQ(newcomer.heard("That is the first result recorded here"), game == 0);
        EXPECT_EQ(newcomer.heard("best time"), game > 0);
    }
    EXPECT_GT(by_ear_in_all, 0) << "no part of any way was in open air";
}

}  // namespace hunt_test
}  // namespace handrail
