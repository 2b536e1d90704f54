// Tests the hand when it goes through doors together with the walker: whether the walker sees the hand, and which of
// them answers questions until the hand is there.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>

#include "app/core/world/walker_world.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/unit/core/app_session.h"
#include "tests/unit/core/explorer.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/navigation/walk_space.h"

namespace handrail {
namespace hand_with_body_test {

using test::Explorer;

// Makes a session as the program does if it finds no device.
std::unique_ptr<Explorer> with_keys_alone(const std::shared_ptr<const Scene>& scene) {
    return std::make_unique<Explorer>(scene, "sim-t", Settings{}, [](Session& app, WorldEntered&) {
        app.apply(HandChanged{Explorer::facts("sim-t"), app.settings(), true}, 0.0);
    });
}

// Returns the solids of the walls only, because the doors move in the session.
WalkerWorld walls_of(const Scene& scene) {
    auto still = std::make_shared<Scene>(scene);
    still->placed.clear();
    std::erase_if(still->solids, [&](const Solid& solid) {
        return std::any_of(scene.movers.begin(), scene.movers.end(),
                           [&](const Mover& mover) { return mover.feature == solid.feature; });
    });
    return WalkerWorld(std::move(still));
}

bool walker_sees_hand(const WalkerWorld& walls, const Explorer& p, const Vec3& feet_m) {
    const Vec3 hand = p.tool().proxy_m;
    for (const double height_m : {0.2, 0.6, 1.0, 1.5, hand.z - feet_m.z}) {
        const TraceHit hit = walls.trace(feet_m + Vec3(0.0, 0.0, height_m), hand, WalkerShape{}, true);
        if (!hit.hit || glm::length(hand - hit.end_m) <= p.tool().proxy_radius_m) return true;
    }
    return false;
}

// Walks from the front door of the house into the Study. The path is that of the report that led to this test. Returns
// the number of frames in which the hand touched something.
int walk_into_the_study(Explorer& p) {
    int touches = 0;
    const auto tap = [&](Command command, int frames) {
        p.tap(command, 0.0);
        for (int i = 0; i < frames; ++i) {
            p.run(1.0 / 60.0);
            touches += p.tool().touches();
        }
    };
    for (int i = 0; i < 2; ++i) tap(Command::TurnRight, 30);
    for (int i = 0; i < 4; ++i) tap(Command::Forward, 60);
    tap(Command::Use, 180);
    for (int i = 0; i < 4; ++i) tap(Command::Forward, 48);
    return touches;
}

TEST(AHandForWantOfADevice, follows_the_walker_through_a_door_and_touches_nothing) {
    const auto p = with_keys_alone(test::our_world("house.map"));
    for (int step = 0; step < 2; ++step) {
        if (step == 1) {
            EXPECT_EQ(walk_into_the_study(*p), 0);
        }
        const Vec3 off = p->tool().proxy_m - p->app().feet_m();
        EXPECT_LT(std::hypot(off.x, off.y), 0.01);
    }
    std::size_t from = p->lines();
    p->tap(Command::WhereAmI, 0.5);
    EXPECT_TRUE(p->heard("Study", from)) << p->all_heard(from);
    from = p->lines();
    p->tap(Command::DropMark, 0.5);
    EXPECT_FALSE(p->heard("clock", from)) << p->all_heard(from);
    EXPECT_FALSE(p->heard("Hand brought back to you"));
}

TEST(AHandForWantOfADevice, stays_ahead_where_the_keys_moved_it_and_follows_the_walker_through_a_door) {
    const auto p = with_keys_alone(test::our_world("house.map"));
    p->hold({0.0, 0.02, 0.0});
    const Vec3 off = p->tool().proxy_m - p->app().feet_m();
    EXPECT_GT(off.y, 0.8);
    walk_into_the_study(*p);
    p->run(1.0);
    EXPECT_TRUE(walker_sees_hand(walls_of(*test::our_world("house.map")), *p, p->app().feet_m()));
}

TEST(AHandOnADevice, follows_the_walker_through_a_door_with_force_rising_from_zero_and_an_announcement) {
    const auto house = test::our_world("house.map");
    const WalkerWorld walls = walls_of(*house);
    Explorer p(house, "sim-t");
    for (int i = 0; i < 2; ++i) p.tap(Command::TurnRight, 0.5);
    for (int i = 0; i < 4; ++i) p.tap(Command::Forward, 1.0);
    p.tap(Command::Use, 3.0);
    std::optional<double> unseen_s;
    double most_gain_after = 0.0;
    bool came = false, requested = false;
    std::uint32_t jump = p.tool().workspace_jump;
    for (int i = 0; i < 400; ++i) {
        if (i % 80 == 0 && i < 320) p.tap(Command::Forward, 0.0);
        p.run(0.01);
        if (p.tool().workspace_jump != std::exchange(jump, p.tool().workspace_jump)) {
            came = true;
            most_gain_after = std::max(most_gain_after, p.tool().force_gain);
        }
        if (walker_sees_hand(walls, p, p.app().feet_m())) unseen_s.reset();
        else if (!unseen_s) unseen_s = p.now_s();
        ASSERT_LE(unseen_s ? p.now_s() - *unseen_s : 0.0, 1.0);
        if (!unseen_s || requested || p.now_s() - *unseen_s < 0.1) continue;
        // The hand is still in the hall, so questions are answered for the place of the walker's feet.
        requested = true;
        const std::size_t from = p.lines();
        p.tap(Command::WhatIsThis, 0.02);
        p.tap(Command::SetBeacon, 0.02);
        p.tap(Command::DropMark, 0.02);
        p.key("Escape");
        EXPECT_FALSE(p.heard("clock", from)) << p.all_heard(from);
        EXPECT_FALSE(p.heard("Hall", from)) << p.all_heard(from);
    }
    EXPECT_TRUE(requested);
    EXPECT_TRUE(came);
    EXPECT_LT(most_gain_after, 0.02);
    EXPECT_TRUE(p.heard("Hand brought back to you"));
    const std::size_t from = p.lines();
    p.tap(Command::WhereAmI, 0.5);
    EXPECT_TRUE(p.heard("Study", from)) << p.all_heard(from);
}

// Goes through every door and opening in both directions, with the hand at different places.
TEST(TheHand, is_visible_from_the_body_within_a_second_after_every_passage_through_a_door) {
    namespace fs = std::filesystem;
    const fs::path maps = test::project_root() / "worlds/maps";
    const auto files = test::kSanitizerScale < 1.0 ? std::vector<fs::path>{maps / "house.map"}
                                                   : test::with_real_worlds({maps / "house.map", maps / "school.map"},
                                                                            {"duplex-apartment.ifc"});
    for (const fs::path& file : files) {
        const auto scene = test::world_once(file);
        const WalkerWorld walls = walls_of(*scene);
        const WalkerSize size = walker_size(*scene, Settings{}.walk.body_radius_m);
        const auto space =
            make_walk_space(*scene, walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m));
        ASSERT_TRUE(space) << file;
        const RoomGraph graph = make_rooms(*scene, *space);
        int ways = 0, doors = 0, brought = 0;
        for (const bool device : {false, true}) {
            auto p = device ? std::make_unique<Explorer>(scene, "sim-t") : with_keys_alone(scene);
            const std::array<Vec3, 3> holds{Vec3(0.0), Vec3(0.02, -0.01, 0.0), Vec3(-0.03, 0.02, 0.01)};
            for (const Portal& portal : graph.portals) {
                if (portal.kind != PassageKind::Door && portal.kind != PassageKind::Opening) continue;
                ++doors;
                if (device) p->hold(holds[static_cast<std::size_t>(doors) % holds.size()]);
                for (int quarter = 0; quarter < 4; ++quarter) {
                    const double heading_rad = quarter * kPi / 2.0;
                    const Vec3 ahead = forward_of_heading(heading_rad), from = portal.place_m - ahead * 0.9;
                    if (walls.blocked(from + Vec3(0.0, 0.0, 0.01), {size.radius_m, size.height_m}) ||
                        walls.trace(from + Vec3(0.0, 0.0, 0.3), portal.place_m + Vec3(0.0, 0.0, 0.3), WalkerShape{})
                            .hit)
                        continue;
                    p->app().apply(Placed{from, heading_rad}, p->now_s());
                    p->run(0.1);
                    p->tap(Command::Use, 1.5);
                    std::optional<double> unseen_s;
                    const std::uint32_t jump = p->tool().workspace_jump;
                    for (int i = 0; i < 180; ++i) {
                        if (i % 45 == 0 && i < 135) p->tap(Command::Forward, 0.0);
                        p->run(1.0 / 60.0);
                        if (walker_sees_hand(walls, *p, p->app().feet_m())) unseen_s.reset();
                        else if (!unseen_s) unseen_s = p->now_s();
                        ASSERT_LE(unseen_s ? p->now_s() - *unseen_s : 0.0, 1.0)
                            << file << (device ? ", device" : ", keys") << ", door " << doors << ", heading "
                            << heading_rad;
                    }
                    ways += glm::dot(p->app().feet_m() - portal.place_m, ahead) > 0.3;
                    brought += p->tool().workspace_jump != jump;
                }
            }
        }
        std::cout << file.filename() << ": " << ways << " ways through " << doors / 2 << " doors, the hand brought "
                  << brought << " times\n";
        EXPECT_GT(ways, doors / 2) << file;
        EXPECT_GT(brought, 0) << file;
    }
}

}  // namespace hand_with_body_test
}  // namespace handrail
