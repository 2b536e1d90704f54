// Tests how routes for directions are planned: a first task plans the first legs, and a later task plans the rest.
#include "app/core/wayfinding/directions_ground.h"
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

// A person in the school, who has chosen a distant room and heard the first leg.
struct OnTheWay {
    HeldBack executor;
    test::AppSession person{{}, {}, SessionOptions{.executor = executor}};
    std::string first;

    OnTheWay() {
        person.app.apply(WorldEntered{make_ready(test::our_world("school.map"))}, person.now);
        person.run(0.1);
        person.request(Command::Exits);
        person.run(1.0);
        person.request(Command::Routes);
        person.line("Art room");
        release();
        first = person.said.back();
    }
    void release() {
        executor.release();
        person.said.clear();
        person.run(0.1);
    }
};

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

}  // namespace first_legs_test
}  // namespace handrail
