// Tests grooves on the floor: where they are, and what a hand feels of them in a session.
#include "app/core/wayfinding/grooves.h"

#include <limits>

#include "tests/support/names.h"
#include "tests/unit/core/explorer.h"

namespace handrail {
namespace grooves_test {

using test::Explorer;

TEST(GrooveLegs, run_through_every_doorway_of_our_house_from_room_to_room) {
    const auto scene = test::our_world("house.map");
    const auto navigation = Navigation::make(*scene, walker_measures(*scene, 0.25, 1.7, 0.2));
    ASSERT_TRUE(navigation);
    const RoomGraph graph = make_rooms(*scene, (*navigation)->space());
    const std::vector<GrooveLeg> legs = grooves_through_doorways(graph, (*navigation)->space());
    std::size_t doors = 0;
    for (const Portal& portal : graph.portals) doors += portal.kind == PassageKind::Door;
    EXPECT_GE(doors, 11U);
    EXPECT_GE(legs.size(), doors);
    for (const GrooveLeg& leg : legs) {
        EXPECT_NEAR(glm::length(leg.to_m - leg.from_m), 1.2, 0.15);
        EXPECT_NE(room_at(graph, (*navigation)->space(), leg.from_m), room_at(graph, (*navigation)->space(), leg.to_m));
    }
}

TEST(GrooveLegs, are_the_nearest_that_the_servo_can_hold_and_state_their_valid_range) {
    std::vector<Vec3> way;
    for (int i = 0; i <= 40; ++i) way.emplace_back(i, 0.0, 0.0);
    const Grooves few = nearest_grooves(std::span(way).first(11), {}, {0, 0, 0}, 0.12);
    EXPECT_EQ(few.path.count, 20U);
    EXPECT_EQ(few.good_within_m, std::numeric_limits<double>::infinity());
    EXPECT_EQ(few.path.points_m[0], Vec3(0, 0, 0.12));
    const Grooves most = nearest_grooves(way, {}, {40, 0, 0.12}, 0.12);
    EXPECT_EQ(most.path.count, GuidancePath::kMostPoints);
    for (std::uint32_t i = 0; i < most.path.count; ++i) EXPECT_GE(most.path.points_m[i].x, 8.0);
    EXPECT_DOUBLE_EQ(most.good_within_m, 16.0) << "half of the way to the nearest that was left out";
    EXPECT_EQ(nearest_grooves({}, {}, {0, 0, 0}, 0.12).path.count, 0U);
}

TEST(Grooves, are_off_by_default_and_otherwise_hold_a_hand_in_a_doorway) {
    for (const bool wanted : {false, true}) {
        Settings settings;
        settings.guidance.grooves = wanted;
        settings.workspace.rim = false;
        Explorer p(test::our_world("house.map"), "sim-t", settings);
        // The walker is in the hall, in front of the living room's door. The test puts the proxy on the floor, 15 cm
        // from the middle of the doorway.
        const auto portal = [&] {
            const auto& features = p.app().scene()->features;
            const auto door = std::find_if(features.begin(), features.end(),
                                           [](const Feature& f) { return f.name == "Living room door"; });
            return door->bounds_m.centre_m();
        }();
        p.run(1.0);
        EXPECT_EQ(p.app().guide().path().number != 0, wanted);
        if (wanted) {
            EXPECT_EQ(p.app().guide().path().kind, GuidanceKind::Grooves);
            EXPECT_EQ(p.tool().guidance.phase, GuidancePhase::Acts);
        }
        const WorkspacePose pose = p.app().hand().pose;
        const double floor_m = p.app().hand().tuning.touch.radius_m;
        p.hold((Vec3(portal.x + 0.4, portal.y + 0.15, floor_m) - pose.origin_m) / 60.0);
        p.run(0.2);
        const Vec3 force = p.tool().guidance.force_n;
        if (wanted) EXPECT_LT(force.y, -0.1) << "towards the middle of the doorway";
        else EXPECT_EQ(force, Vec3(0.0));
        EXPECT_LE(glm::length(force), 0.8);
        if (!wanted) continue;
        // While the hand is guided at the person's request, it feels only the pull. After that, the grooves are back,
        // now also along the route.
        const std::uint32_t doorways = p.app().guide().path().count;
        p.hold(Vec3(0.0));
        p.tap(Command::Find);
        p.line("Desk");
        p.line("Take me there");
        p.run(1.3);
        EXPECT_EQ(p.app().guide().path().kind, GuidanceKind::Pull);
        p.tap(Command::TakeMe);
        p.run(1.0);
        EXPECT_EQ(p.app().guide().path().kind, GuidanceKind::Grooves);
        EXPECT_GT(p.app().guide().path().count, doorways);
        p.tap(Command::ToggleForces);
        p.run(0.5);
        EXPECT_EQ(p.app().guide().path().number, 0U);
    }
}

}  // namespace grooves_test
}  // namespace handrail
