// Tests the reason that the session gives if a person requests the route to a room that cannot be reached. The session
// says why, and what would help.
#include <gtest/gtest.h>

#include "tests/support/box_scene.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"
#include "worlds/check/faults.h"
#include "worlds/navigation/rooms.h"

namespace handrail {
namespace why_no_route_test {

// Makes two rooms of 5 by 4 m with a gap between them. The farther room is empty. The wall between them has the
// thickness `wall_m`, and the gap has the height `high_m`.
std::shared_ptr<const Scene> two_rooms(double gap_m, double wall_m = 0.2, double high_m = 3.0) {
    test::SceneBuilder b;
    b.box({0, 0, -0.2}, {10.2, 4, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    for (const auto& [from, to] :
         {std::pair(Vec3(-0.2, -0.2, -0.2), Vec3(10.4, 0, 3)), std::pair(Vec3(-0.2, 4, -0.2), Vec3(10.4, 4.2, 3)),
          std::pair(Vec3(-0.2, 0, -0.2), Vec3(0, 4, 3)), std::pair(Vec3(10.2, 0, -0.2), Vec3(10.4, 4, 3)),
          std::pair(Vec3(5, 0, 0), Vec3(5 + wall_m, 2 - 0.5 * gap_m, 3)),
          std::pair(Vec3(5, 2 + 0.5 * gap_m, 0), Vec3(5 + wall_m, 4, 3))})
        b.box(from, to, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    if (high_m < 3.0)
        b.box({5, 2 - 0.5 * gap_m, high_m}, {5 + wall_m, 2 + 0.5 * gap_m, 3}, "lintel", SolidRole::Solid, {},
              FeatureKind::Wall);
    b.scene().room_names = {{{2.5, 2, 0}, "Hall"}, {{7, 2, 0}, "Study"}};
    b.start({1, 2, 0}, 0.5 * kPi);
    b.scene().starts.back().base = true;
    return b.share();
}

struct Requested : test::AppSession {
    Requested(double gap_m, bool background)
        : test::AppSession({}, {}, {.executor = background ? on_threads() : at_once()}) {
        app.apply(WorldEntered{make_ready(two_rooms(gap_m))}, 0.0);
        wait_for([&] {
            request(Command::Routes);
            return app.dialogue().is_open();
        });
        const auto items = app.dialogue().view().items;
        const auto study =
            std::find_if(items.begin(), items.end(), [](const ListItem& i) { return i.name == "Study"; });
        EXPECT_NE(study, items.end());
        app.apply(LineTyped{std::to_string(study - items.begin() + 1)}, now);
        run(0.1);
    }
    template <class Condition>
    void wait_for(const Condition& is) {
        EXPECT_TRUE(test::eventually([&] {
            run(1.0 / 60.0);
            return is();
        }));
    }
};

TEST(NoRouteReason, is_reported_with_a_remedy_at_once_or_from_a_background_task) {
    for (const bool background : {false, true}) {
        Requested requested(0.3, background);
        EXPECT_TRUE(requested.heard("No walking route found to Study"));
        requested.wait_for([&] { return requested.heard("Study cannot be reached on foot from the base"); });
        EXPECT_TRUE(requested.heard("the best route to it is only 0.3 metres wide"));
        EXPECT_TRUE(requested.heard("Make the route at least 0.5 metres wide there"));
    }
}

// Most of these walls are thin enough for a door. The session once suggested a door instead of naming the reason.
TEST(NoRouteReason, is_a_gap_that_is_too_narrow_or_too_low_in_any_wall) {
    struct Gap {
        double wide_m, high_m;
        Lack lack;
    };
    for (const double wall_m : {0.2, 0.3, 0.6})
        for (const Gap& gap :
             {Gap{0.2, 3.0, Lack::Width}, Gap{0.3, 3.0, Lack::Width}, Gap{0.45, 3.0, Lack::Width},
              Gap{0.9, 1.0, Lack::Headroom}, Gap{0.9, 1.5, Lack::Headroom}, Gap{0.9, 1.75, Lack::Headroom}}) {
            SCOPED_TRACE(std::to_string(wall_m) + " m thick, " + std::to_string(gap.wide_m) + " m wide, " +
                         std::to_string(gap.high_m) + " m high");
            const std::shared_ptr<const Scene> scene = two_rooms(gap.wide_m, wall_m, gap.high_m);
            const Result<WalkSpace> space = make_walk_space(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
            ASSERT_TRUE(space.has_value());
            const RoomGraph graph = make_rooms(*scene, *space);
            std::vector<WorldFault> found;
            for (WorldFault& fault : find_faults(*scene, &*space, &graph))
                if (fault.kind == FaultKind::RoomOutOfReach) found.push_back(std::move(fault));
            ASSERT_EQ(found.size(), 1U);
            EXPECT_EQ(found[0].lack, gap.lack) << fault_words(*scene, found[0]);
            const double truth_m = gap.lack == Lack::Width ? gap.wide_m : gap.high_m;
            EXPECT_NEAR(found[0].amount, truth_m, 0.001);
            EXPECT_NEAR(found[0].at_m.x, 5.0 + 0.5 * wall_m, 0.5 * wall_m + 0.3);
            EXPECT_NEAR(found[0].at_m.y, 2.0, 0.6);
        }
}

TEST(FaultWords, never_advise_widening_a_doorway_that_is_wide_enough) {
    const Scene scene;
    WorldFault fault{FaultKind::ImpassableDoor, Vec3(0.0), {}};
    fault.name = "Door";
    fault.amount = 0.9;
    EXPECT_EQ(fault_words(scene, fault), "Door: nobody can get through this door, though it is 0.9 metres wide.");
    EXPECT_EQ(fault_advice(scene, fault).find("0.8"), std::string::npos) << fault_advice(scene, fault);
    fault.amount = 0.5;
    EXPECT_NE(fault_advice(scene, fault).find("at least 0.8 metres wide"), std::string::npos);
}

TEST(NoRouteReason, is_not_reported_if_a_route_exists) {
    Requested requested(1.2, false);
    requested.run(1.0);
    EXPECT_FALSE(requested.heard("No walking route"));
    EXPECT_FALSE(requested.heard("cannot be reached"));
}

}  // namespace why_no_route_test
}  // namespace handrail
