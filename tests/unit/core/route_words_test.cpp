// Tests routes in words, and the announcements along a route.
#include "app/core/wayfinding/route_words.h"

#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/support/spoken_language.h"

namespace handrail {
namespace route_words_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const DistanceWords kSteps{true, 0.7};

// Returns the length of a route and all its legs.
std::string whole(const Route& route, const std::vector<RouteNode>& nodes, double heading_rad) {
    return route_words(route, route_legs(route, nodes, heading_rad, kSteps), kSteps);
}

// Returns a route ten metres north to a door, through the door and ten metres east, and ten more half right.
Route corner() {
    Route route;
    route.points_m = {{0, 0, 0}, {0, 10, 0}, {10, 10, 0}, {17.071, 2.929, 0}};
    route.length_m = 30.0;
    route.reaches = true;
    route.passages.push_back({PassageKind::Door, {0, 9.7, 0}, 9.7, 0.0, kNoFeature});
    return route;
}
std::vector<RouteNode> nodes(const Route& route) {
    return nodes_of(
        route, "Kitchen",
        [](const RoutePassage& p) { return std::string(p.kind == PassageKind::Door ? "blue door" : "stairs"); },
        [](const RoutePassage& p) { return p.feature != kNoFeature; });
}

TEST(RouteWords, say_of_a_shut_door_that_it_must_be_opened) {
    Route route = corner();
    route.passages.front().feature = FeatureId{1};
    EXPECT_THAT(whole(route, nodes(route), 0.0), HasSubstr("14 steps to blue door, shut. Open it. Turn right."));
}

TEST(RouteWords, give_for_every_leg_the_next_feature_and_the_turn_there) {
    const Route route = corner();
    EXPECT_EQ(
        whole(route, nodes(route), 0.0),
        "About 45 steps in all. 14 steps to blue door. Turn right. 15 steps. Turn half right. 14 steps to Kitchen.");
    // A walker who faces west turns right first.
    EXPECT_THAT(whole(route, nodes(route), -kPi / 2.0), HasSubstr("in all. Turn right. 14 steps to blue door"));
    EXPECT_THAT(whole(route, nodes(route), kPi), HasSubstr("Turn round."));
    EXPECT_EQ(whole(Route{}, {}, 0.0), "You are there.");
    EXPECT_EQ(route_words(route, route_legs(route, nodes(route), 0.0, kSteps), kSteps, 1),
              "About 45 steps in all. 14 steps to blue door.");
}

TEST(RouteWords, give_turns_in_notches_of_the_turning_key) {
    const auto first_turn = [](double deg) {
        const Route route = corner();
        return whole(route, nodes(route), radians_from_degrees(-deg));
    };
    EXPECT_THAT(first_turn(0.0), HasSubstr("in all. 14 steps to blue door."));
    EXPECT_THAT(first_turn(22.5), HasSubstr("in all. Turn slightly right. 14 steps to blue door."));
    EXPECT_THAT(first_turn(-22.5), HasSubstr("in all. Turn slightly left. 14 steps"));
    EXPECT_THAT(first_turn(-45.0), HasSubstr("in all. Turn half left. 14 steps"));
    EXPECT_THAT(first_turn(-90.0), HasSubstr("in all. Turn left. 14 steps"));
    EXPECT_THAT(first_turn(135.0), HasSubstr("in all. Turn sharp right. 14 steps"));
    EXPECT_THAT(first_turn(180.0), HasSubstr("in all. Turn round. 14 steps"));
}

struct Walked {
    std::vector<std::string> said;
    bool left = false, arrived = false;
};
Walked walk(RouteFollower& follower, const std::vector<Vec3>& places, double step_m = 0.1) {
    Walked walked;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double length = glm::length(places[i] - places[i - 1]);
        for (double at = 0.0; at < length && !walked.left && follower.following(); at += step_m) {
            const auto said = follower.tick(places[i - 1] + (places[i] - places[i - 1]) * (at / length), kSteps);
            if (!said.text.empty()) walked.said.push_back(said.text);
            walked.left = said.left;
            walked.arrived = walked.arrived || said.arrived;
        }
    }
    return walked;
}

TEST(RouteFollower, announces_features_6_m_ahead_and_on_reaching_them_and_announces_the_arrival) {
    const Route route = corner();
    RouteFollower follower;
    follower.follow(route, nodes(route));
    const Walked walked = walk(follower, route.points_m);
    EXPECT_THAT(walked.said, ElementsAre("Blue door, 9 steps", "Blue door, turn right, then 15 steps",
                                         "Turn half right, 9 steps", "Turn half right, then 14 steps to Kitchen",
                                         "Kitchen, 9 steps", "Kitchen. You are there."));
    EXPECT_TRUE(walked.arrived);
    EXPECT_FALSE(follower.following());
}

TEST(RouteWords, are_german_sentences_before_and_along_the_route) {
    const test::InLanguage german("de");
    const Route route = corner();
    EXPECT_EQ(
        whole(route, nodes(route), -kPi / 2.0),
        "Etwa 45 Schritte insgesamt. Rechts abbiegen. 14 Schritte bis blue door. Rechts abbiegen. 15 Schritte. Halb "
        "rechts abbiegen. "
        "14 Schritte bis Kitchen.");
    EXPECT_EQ(whole(Route{}, {}, 0.0), "Das Ziel ist erreicht.");
    RouteFollower follower;
    follower.follow(route, nodes(route));
    EXPECT_THAT(
        walk(follower, route.points_m).said,
        ElementsAre("Blue door, noch 9 Schritte", "Blue door, rechts abbiegen, dann 15 Schritte",
                    "Halb rechts abbiegen, noch 9 Schritte", "Halb rechts abbiegen, dann 14 Schritte bis Kitchen",
                    "Kitchen, noch 9 Schritte", "Kitchen. Das Ziel ist erreicht."));
}

TEST(RouteFollower, confirms_every_10_m_that_the_walker_is_on_the_route) {
    Route route;
    route.points_m = {{0, 0, 0}, {0, 50, 0}};
    route.length_m = 50.0;
    RouteFollower follower;
    follower.follow(route, nodes(route));
    const Walked walked = walk(follower, route.points_m);
    ASSERT_EQ(walked.said.size(), 6U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_THAT(walked.said[i], HasSubstr("On the route, "));
    EXPECT_EQ(walked.said[0], "On the route, 55 steps to go");
    EXPECT_EQ(walked.said[4], "Kitchen, 9 steps");
}

TEST(RouteFollower, reports_leaving_the_route_only_when_it_happens) {
    const Route route = corner();
    RouteFollower follower;
    follower.follow(route, nodes(route));
    EXPECT_FALSE(walk(follower, {{0, 0, 0}, {1.5, 5, 0}, {0, 8, 0}}).left);
    EXPECT_TRUE(walk(follower, {{0, 8, 0}, {-6, 8, 0}}).left);
    follower.stop();
    EXPECT_FALSE(follower.following());
    EXPECT_TRUE(follower.tick({0, 0, 0}, kSteps).text.empty());
}

}  // namespace route_words_test
}  // namespace handrail
