// Tests how routes for directions are planned: a first task plans the first legs, and a later task plans the rest.
#include "app/core/wayfinding/directions_ground.h"

#include <cmath>
#include <set>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"
#include "worlds/navigation/reach.h"
#include "worlds/scene/models.h"

namespace handrail {
namespace first_legs_test {

// The house, and the ground for directions in it, as a session makes them.
struct House {
    std::shared_ptr<const Scene> scene = test::our_world("house.map");
    std::vector<int> thing_of_mover;
    Scene apart = with_movers_apart(*scene, 1000, thing_of_mover);
    std::shared_ptr<Navigation> navigation;
    RoomGraph graph;
    std::unique_ptr<DirectionsFloor> floor;

    House() {
        const WalkerSize size = walker_size(*scene, 0.25);
        auto made = Navigation::make(*scene, walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m));
        if (!made) throw std::runtime_error(made.error().message);
        navigation = *made;
        graph = make_rooms(*scene, navigation->space());
        floor =
            std::make_unique<DirectionsFloor>(navigation, graph.room_of_span, word_doors(apart, thing_of_mover), 0.7);
    }
};

bool same(const DirectionsLeg& a, const DirectionsLeg& b) {
    return a.turn_notches == b.turn_notches && a.steps == b.steps && a.end == b.end && a.door == b.door;
}

TEST(FirstLegs, are_the_same_as_the_beginning_of_the_whole_route) {
    const House house;
    const Vec3 from_m = base_of(*house.scene)->feet_m;
    const DoorsOpen shut = house.floor->ground.all_shut();
    int in_parts = 0;
    for (std::uint32_t room = 0; room < house.graph.rooms.size(); ++room) {
        if (house.graph.rooms[room].kind != RoomKind::Room) continue;
        SCOPED_TRACE(house.graph.rooms[room].name);
        const DirectionsGoal goal = goal_in_room(house.navigation->space(), house.graph.room_of_span, room);
        const auto first = house.floor->planner.plan(from_m, 0.0, goal, shut, {}, {}, {.begun = {}, .places = 10});
        if (!first || first->whole) continue;
        ++in_parts;
        ASSERT_FALSE(first->legs.empty());
        const auto whole =
            house.floor->planner.plan(from_m, 0.0, goal, shut, {}, {}, {.begun = first->legs, .places = 0});
        ASSERT_TRUE(whole);
        EXPECT_TRUE(whole->whole);
        EXPECT_GE(whole->came, 90);
        ASSERT_GT(whole->legs.size(), first->legs.size());
        EXPECT_TRUE(std::equal(first->legs.begin(), first->legs.end(), whole->legs.begin(), same));
    }
    EXPECT_GE(in_parts, 5);
}

// Runs each task immediately, except tasks that plan routes for directions. Runs those only after release().
class HeldBack : public Executor {
public:
    std::thread run(const char* name, std::function<void()> job) const override {
        if (std::string_view(name) == "word-route") held_.push_back(std::move(job));
        else job();
        return {};
    }
    std::size_t held() const { return held_.size(); }
    void release() {
        const std::vector<std::function<void()>> jobs = std::exchange(held_, {});
        for (const auto& job : jobs) job();
    }

private:
    mutable std::vector<std::function<void()>> held_;
};

// A person in the school, who has chosen a distant room.
struct Chosen {
    HeldBack executor;
    test::AppSession person{{}, {}, SessionOptions{.executor = executor}};

    Chosen() {
        person.app.apply(WorldEntered{make_ready(test::our_world("school.map"))}, person.now);
        person.run(0.1);
        person.request(Command::Exits);
        person.run(1.0);
        person.request(Command::Routes);
        person.line("Art room");
    }
    void release() {
        executor.release();
        person.said.clear();
        person.run(0.1);
    }
};

// The same person, who has heard the first leg.
struct OnTheWay : Chosen {
    std::string first;

    OnTheWay() {
        release();
        // The length of the route is announced with the first leg; it is not yet exact.
        constexpr std::string_view kLength = " in all";
        const std::string& said = person.said.back();
        EXPECT_EQ(said.find("About "), 0U) << said;
        first = said.substr(said.find(". ", said.find(kLength)) + 2);
    }
};

TEST(FirstLegs, are_planned_once_although_the_rest_is_requested_before_them) {
    Chosen way;
    for (int times = 0; times < 3; ++times) EXPECT_EQ(way.person.request(Command::RestOfRoute), phrase("leg.looks"));
    ASSERT_EQ(way.executor.held(), 1U);
    way.release();
    EXPECT_TRUE(way.person.said.empty()) << "the rest was requested: " << way.person.news();
    ASSERT_EQ(way.executor.held(), 1U) << "the rest is planned";
    way.release();
    ASSERT_FALSE(way.person.said.empty()) << "the request was forgotten";
    EXPECT_GT(way.person.said.back().size(), 200U) << way.person.said.back();
    EXPECT_EQ(way.executor.held(), 0U);
}

TEST(FirstLegs, are_announced_while_the_rest_is_still_being_planned) {
    OnTheWay way;
    EXPECT_FALSE(way.first.empty());
    EXPECT_NE(way.first, phrase("leg.looks"));
    ASSERT_EQ(way.executor.held(), 1U) << "the rest is planned";
    EXPECT_EQ(way.person.request(Command::RepeatLeg), way.first);
    way.release();
    EXPECT_TRUE(way.person.said.empty()) << "nothing was requested: " << way.person.news();
    EXPECT_EQ(way.person.request(Command::RepeatLeg), way.first);
    EXPECT_EQ(way.executor.held(), 0U);
}

TEST(FirstLegs, are_completed_by_the_rest_on_request_during_planning) {
    OnTheWay way;
    ASSERT_EQ(way.executor.held(), 1U);
    EXPECT_EQ(way.person.request(Command::RestOfRoute), phrase("leg.looks"));
    way.release();
    ASSERT_FALSE(way.person.said.empty());
    const std::string rest = way.person.said.back();
    EXPECT_TRUE(rest.starts_with(way.first)) << rest;
    EXPECT_GT(rest.size(), way.first.size() + 100) << rest;
    EXPECT_EQ(way.person.request(Command::RestOfRoute), rest);
}

TEST(FirstLegs, continue_with_the_next_leg_as_soon_as_it_is_planned) {
    OnTheWay way;
    ASSERT_EQ(way.executor.held(), 1U);
    std::string leg = way.first;
    for (int i = 0; i < 20 && leg != phrase("leg.looks"); ++i) leg = way.person.request(Command::NextLeg);
    EXPECT_EQ(leg, phrase("leg.looks")) << "no more legs are known";
    way.release();
    ASSERT_FALSE(way.person.said.empty());
    EXPECT_NE(way.person.said.back(), phrase("leg.looks"));
    EXPECT_FALSE(way.person.said.back().empty());
}

// Five rooms in a row, each 24 m long, with a doorway in the middle of each wall between them. A table stands in the
// middle of each room, so no straight line leads from doorway to doorway.
struct Row : test::AppSession {
    static constexpr double kRoom_m = 24.0, kHalfTable_m = 1.0, kMiddle_m = 3.0;
    static constexpr int kRooms = 5;

    Row() {
        test::SceneBuilder b;
        const double end_m = kRooms * kRoom_m;
        const auto wall = [&](const Vec3& low, const Vec3& high) {
            b.box(low, high, "wall", SolidRole::Solid, "brick", FeatureKind::Wall);
        };
        b.box({0, 0, -0.2}, {end_m, 6, 0}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
        wall({-0.2, -0.2, 0}, {end_m + 0.2, 0, 2.6});
        wall({-0.2, 6, 0}, {end_m + 0.2, 6.2, 2.6});
        wall({-0.2, 0, 0}, {0, 6, 2.6});
        wall({end_m, 0, 0}, {end_m + 0.2, 6, 2.6});
        for (int room = 0; room < kRooms; ++room) {
            const double begin_m = room * kRoom_m, middle_m = begin_m + 0.5 * kRoom_m;
            b.box({middle_m - kHalfTable_m, kMiddle_m - kHalfTable_m, 0},
                  {middle_m + kHalfTable_m, kMiddle_m + kHalfTable_m, 0.8}, "table", SolidRole::Solid, "wood",
                  FeatureKind::Object);
            if (room == 0) continue;
            wall({begin_m - 0.1, 0, 0}, {begin_m + 0.1, kMiddle_m - 0.5, 2.6});
            wall({begin_m - 0.1, kMiddle_m + 0.5, 0}, {begin_m + 0.1, 6, 2.6});
        }
        b.start({2, kMiddle_m, 0}, kPi / 2.0);
        app.apply(WorldEntered{make_ready(b.share())}, now);
        run(0.1);
        request(Command::Exits);
        run(1.0);
    }
    // Returns how many tables the route crosses.
    int tables_crossed() {
        const std::vector<Vec3>& way = app.guide().way_m();
        std::set<int> crossed;
        for (std::size_t i = 1; i < way.size(); ++i)
            for (double part = 0.0; part <= 1.0; part += 0.01) {
                const Vec3 at = way[i - 1] + (way[i] - way[i - 1]) * part;
                const double along_m = std::fmod(at.x, kRoom_m) - 0.5 * kRoom_m;
                if (std::abs(along_m) < kHalfTable_m && std::abs(at.y - kMiddle_m) < kHalfTable_m)
                    crossed.insert(static_cast<int>(at.x / kRoom_m));
            }
        return static_cast<int>(crossed.size());
    }
};

TEST(FarRoutes, are_planned_a_stretch_at_a_time_while_the_first_legs_are_announced) {
    Row person;
    person.request(Command::Routes);
    const std::vector<ListItem> items = person.app.dialogue().view().items;
    ASSERT_GE(items.size(), 4U) << person.news();
    person.line(items.back().name);
    EXPECT_GT(person.app.guide().way_m().back().x, 4 * Row::kRoom_m) << "the last room is the farthest";
    EXPECT_GE(person.tables_crossed(), 2) << "the end of the route is not planned in the same tick";
    person.run(0.2);
    EXPECT_EQ(person.tables_crossed(), 0);
    EXPECT_GT(person.app.guide().way_m().back().x, 4 * Row::kRoom_m);
    EXPECT_FALSE(person.app.guide().take_legs().empty());
}

}  // namespace first_legs_test
}  // namespace handrail
