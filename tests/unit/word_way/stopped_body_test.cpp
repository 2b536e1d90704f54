// Tests the directions after something has stopped the walker where the plan leads past it. The same direction would
// stop the walker again, so it must not be announced again.
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace stopped_body_test {

// A corridor leads east to a hall. In its north wall, a shut door leads to a pantry.
std::shared_ptr<const Scene> corridor() {
    const std::string walls =
        test::entity("func_wall", test::key("name", "wall"),
                     test::box_brush(0, 28, 0, 320, 32, 128) + test::box_brush(0, 96, 0, 144, 104, 128) +
                         test::box_brush(176, 96, 0, 256, 104, 128) + test::box_brush(288, 96, 0, 320, 104, 128) +
                         test::box_brush(144, 96, 72, 176, 104, 128) + test::box_brush(132, 104, 0, 136, 150, 128) +
                         test::box_brush(184, 104, 0, 188, 150, 128) + test::box_brush(132, 150, 0, 188, 154, 128));
    const std::string door = test::entity(
        "func_door", test::key("hinge", "west") + test::key("opens", "south") + test::key("name", "Closet"),
        test::box_brush(144, 98, 0, 176, 102, 72));
    const std::string base =
        test::entity("info_player_start", test::key("origin", "48 78 24") + test::key("angle", "0"));
    auto scene =
        read_quake_map(test::entity("worldspawn", test::key("message", "Corridor") + test::key("building", "1"),
                                    test::room_brushes(0, 0, 0, 320, 640, 128)) +
                           base + walls + door,
                       "corridor.map", {});
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().sentence());
    scene->room_names = {RoomName{Vec3(1.5, 2.4, 0.0), "Corridor"}, RoomName{Vec3(8.0, 12.0, 0.0), "Hall"},
                         RoomName{Vec3(5.0, 4.0, 0.0), "Pantry"}};
    return std::make_shared<const Scene>(std::move(*scene));
}

FeatureId named(const Scene& scene, const std::string& name) {
    for (std::uint32_t i = 0; i < scene.features.size(); ++i)
        if (scene.features[i].name == name) return FeatureId{i};
    return kNoFeature;
}

class StoppedBody : public testing::Test {
protected:
    StoppedBody() {
        p.app.apply(WorldEntered{make_ready(corridor())}, 0.0);
        p.run(0.1);
    }
    // Follows the route to a room from a place, and returns the first leg.
    std::string follow(const Vec3& from_m, double heading_rad, const std::string& room) {
        p.app.apply(Placed{from_m, heading_rad}, p.now);
        p.request(Command::Routes);
        p.line(room);
        p.run(0.1);
        return p.request(Command::RepeatLeg);
    }
    // Returns the next directions after a feature has stopped the walker at its present place and heading.
    std::string after_stop(FeatureId by) {
        p.app.guide().note_stop(by);
        return p.request(Command::RepeatLeg);
    }
    test::AppSession p;
};

TEST_F(StoppedBody, hears_of_the_door_again_only_if_the_door_is_within_reach) {
    const FeatureId wall = named(*p.app.scene(), "wall");
    ASSERT_TRUE(wall);
    const Vec3 before_door_m{5.0, 2.6, 0.0}, out_of_reach_m{5.0, 1.3, 0.0};
    for (const Vec3& from_m : {before_door_m, out_of_reach_m}) {
        const std::string leg = follow(from_m, 0.0, "Pantry");
        ASSERT_NE(leg.find("Closet, shut. Open it."), std::string::npos) << leg;
        const std::string again = after_stop(wall);
        EXPECT_EQ(again.find("Open it.") != std::string::npos, from_m == before_door_m) << again;
    }
}

// A walker that is stopped there again came back from the first place aside, so that place did not help.
TEST_F(StoppedBody, gets_another_step_aside_after_the_next_stop_but_the_same_one_on_repetition) {
    ASSERT_TRUE(follow({3.0, 2.0, 0.0}, 0.5 * kPi, "Hall").starts_with("Straight on."));
    const std::string first = after_stop(kNoFeature);
    ASSERT_TRUE(first.starts_with("To Hall: 1 step, ")) << first;
    EXPECT_EQ(p.request(Command::RepeatLeg), first);
    const std::string second = after_stop(kNoFeature);
    EXPECT_TRUE(second.starts_with("To Hall: 1 step")) << second;
    EXPECT_NE(second, first);
}

TEST_F(StoppedBody, gets_directions_that_begin_with_a_step_aside) {
    // An edge may stop the walker, too. Then there is no feature.
    for (const FeatureId by : {named(*p.app.scene(), "wall"), kNoFeature}) {
        ASSERT_TRUE(follow({3.0, 2.0, 0.0}, 0.5 * kPi, "Hall").starts_with("Straight on."));
        const std::string aside = after_stop(by);
        EXPECT_TRUE(aside.starts_with("To Hall: 1 step, ")) << aside;
        EXPECT_EQ(aside.find(" ahead"), std::string::npos) << aside;
        p.app.apply(Placed{{3.0, 2.6, 0.0}, 0.5 * kPi}, p.now);
        const std::string on = p.request(Command::RepeatLeg);
        EXPECT_FALSE(on.starts_with("To Hall: 1 step,")) << "nothing has stopped the walker here: " << on;
        // Back at the place of the stop, the same step aside would lead in a circle.
        p.app.apply(Placed{{3.0, 2.0, 0.0}, 0.5 * kPi}, p.now);
        EXPECT_NE(p.request(Command::RepeatLeg), aside);
    }
}

}  // namespace stopped_body_test
}  // namespace handrail
