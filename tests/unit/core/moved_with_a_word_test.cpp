// Tests commands that move the walker automatically: the session announces each turn and each change of height.
// Trailing announces its direction and stops before stairs. A leap announces the new place.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace moved_with_a_word_test {

using test::AppSession;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kLanguages[] = {"en", "de"};

struct Body : AppSession {
    explicit Body(std::shared_ptr<const Scene> scene) {
        app.apply(WorldEntered{make_ready(std::move(scene))}, 0.0);
        run(0.1);
        news();
    }
    explicit Body(const char* world) : Body(test::our_world(world)) {}
    // Waits until nothing is pending, for a minute at most.
    void rest() {
        for (int i = 0; i < 60 && !(app.idle() && i > 0); ++i) run(1.0);
    }
    double off_rad(double from_rad) const { return std::abs(std::remainder(app.heading_rad() - from_rad, 2.0 * kPi)); }
};

// Makes a hall of 10 by 6 metres with its floor at 0. In the east, twelve steps along the south wall lead up to a
// landing.
std::shared_ptr<const Scene> hall_with_stairs() {
    test::SceneBuilder b;
    b.box({0, 0, -0.2}, {20, 6, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    b.box({-0.2, 6, 0}, {20.2, 6.2, 5}, "north wall", SolidRole::Solid, {}, FeatureKind::Wall);
    b.box({-0.2, -0.2, 0}, {20.2, 0, 5}, "south wall", SolidRole::Solid, {}, FeatureKind::Wall);
    b.box({-0.2, 0, 0}, {0, 6, 5}, "west wall", SolidRole::Solid, {}, FeatureKind::Wall);
    b.box({20, 0, 0}, {20.2, 6, 5}, "east wall", SolidRole::Solid, {}, FeatureKind::Wall);
    for (int i = 0; i < 12; ++i)
        b.box({8.0 + 0.3 * i, 0, 0.17 * i}, {20.0, 2.0, 0.17 * (i + 1)}, "stairs", SolidRole::Solid, {},
              FeatureKind::Object);
    b.start({2, 1, 0}, 0.0);
    return b.share();
}

TEST(Trailing, announces_an_initial_turn_of_the_body) {
    for (const char* language : kLanguages) {
        const test::InLanguage spoken(language);
        // The walker faces west, so that the south wall is on its left. To have the wall on its right, the walker must
        // turn to face east.
        Body s(hall_with_stairs());
        s.app.apply(Placed{{4, 0.4, 0}, -0.5 * kPi}, s.now);
        s.news();
        s.request(Command::TrailRight);
        EXPECT_TRUE(s.heard(phrase("walking.trail_turns", {{"compass", phrase("compass.east")}, {"side", "right"}})))
            << s.news();
        s.rest();
        EXPECT_LT(s.off_rad(0.5 * kPi), 0.1);
        // If the wall is already on the requested side, no turn is announced.
        Body beside(hall_with_stairs());
        beside.app.apply(Placed{{4, 0.4, 0}, -0.5 * kPi}, beside.now);
        beside.news();
        beside.request(Command::TrailLeft);
        EXPECT_THAT(beside.news(), Not(HasSubstr(phrase("compass.west"))));
    }
}

TEST(Trailing, announces_walking_to_the_wall_first) {
    Body s(hall_with_stairs());
    s.app.apply(Placed{{4, 3, 0}, 0.0}, s.now);
    s.news();
    s.request(Command::TrailLeft);
    EXPECT_THAT(s.said.back(), HasSubstr("Going to the wall, "));
    EXPECT_THAT(s.said.back(), HasSubstr("with the wall on your left"));
}

TEST(Trailing, waits_at_stairs_until_it_is_requested_again) {
    for (const char* language : kLanguages) {
        const test::InLanguage spoken(language);
        Body s(hall_with_stairs());
        s.app.apply(Placed{{5, 0.4, 0}, 0.5 * kPi}, s.now);
        s.news();
        s.request(Command::TrailRight);
        s.rest();
        const std::string waits = phrase("walking.trail_stairs_up");
        for (int i = 0; i < 5 && !s.heard(waits); ++i) {
            s.request(Command::TrailOn);
            s.rest();
        }
        EXPECT_TRUE(s.heard(waits)) << s.news();
        EXPECT_NEAR(s.app.feet_m().z, 0.0, 0.05) << "still on the floor";
        EXPECT_GT(s.app.feet_m().x, 7.0) << "just before them";
        s.news();
        for (int i = 0; i < 30 && s.app.feet_m().z < 1.5; ++i) {  // In this world, each step is a separate thing.
            s.request(Command::TrailOn);
            s.rest();
        }
        EXPECT_GT(s.app.feet_m().z, 1.5) << "asked again it takes them";
    }
}

// The walker trails along the walls of all rooms of the house, starting from their middles. Every turn by more than a
// notch and every change of height must have been announced before.
TEST(Trailing, never_turns_or_climbs_without_an_announcement_in_the_house) {
    Body s("house.map");
    s.request(Command::Exits);
    s.run(0.1);
    const auto rooms = s.app.view({}).rooms;
    ASSERT_TRUE(rooms);
    for (const DrawnRoom& room : *rooms) {
        s.app.apply(Placed{room.middle_m, 0.0}, s.now);
        s.run(0.2);
        s.news();
        s.app.apply(CommandDown{Command::TrailLeft}, s.now);
        double heading_rad = s.app.heading_rad(), z_m = s.app.feet_m().z;
        std::size_t said = s.said.size();
        for (int i = 0; i < 60 * 10; ++i) {
            s.run(1.0 / 60.0);
            if (s.said.size() > said) {
                said = s.said.size();
                // A turn that has begun may continue after its announcement.
                heading_rad = s.app.heading_rad();
                z_m = s.app.feet_m().z;
                for (int more = 0; more < 90; ++more) {
                    s.run(1.0 / 60.0);
                    heading_rad = s.app.heading_rad();
                    z_m = s.app.feet_m().z;
                    if (s.said.size() > said) break;
                }
            }
            ASSERT_LT(s.off_rad(heading_rad), 0.9) << room.name << ": " << s.news();
            ASSERT_LT(std::abs(s.app.feet_m().z - z_m), 0.5) << room.name << ": " << s.news();
        }
        s.app.apply(CommandUp{Command::TrailLeft}, s.now);
        s.request(Command::SquareUp);
    }
    EXPECT_GT(rooms->size(), 5U);
}

// Makes three landmarks at 2, 4 and 7 metres. The file has them in the opposite order.
std::shared_ptr<const Scene> three_things() {
    test::SceneBuilder b;
    b.box({-10, -10, -0.2}, {10, 10, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    const FeatureId far = b.box({6.8, -0.2, 0}, {7.2, 0.2, 1.5}, "Well");
    const FeatureId middle = b.box({-0.2, 3.8, 0}, {0.2, 4.2, 1.5}, "Oak");
    const FeatureId near = b.box({-2.2, -0.2, 0}, {-1.8, 0.2, 1.5}, "Post");
    for (const FeatureId id : {far, middle, near}) b.scene().features[id.value].landmark = true;
    b.start({0, 0, 0}, 0.0);
    return b.share();
}

TEST(Leaping, goes_to_the_nearest_thing_first_and_announces_the_new_place) {
    for (const char* language : kLanguages) {
        const test::InLanguage spoken(language);
        Body s(three_things());
        s.request(Command::LeapNext);
        EXPECT_NEAR(s.app.feet_m().x, -1.4, 0.4) << "the post";
        EXPECT_EQ(s.said.back(), phrase("walking.leapt", {{"name", "Post"}, {"compass", phrase("compass.west")}}));
        s.run(0.1);
        s.request(Command::LeapNext);
        EXPECT_THAT(s.said.back(), HasSubstr("Oak")) << "not back to the post";
        const Vec3 oak_m = s.app.feet_m();
        s.run(0.1);
        s.request(Command::LeapNext);
        EXPECT_THAT(s.said.back(), HasSubstr("Well"));
        s.run(0.1);
        s.request(Command::LeapLast);
        EXPECT_THAT(s.said.back(), HasSubstr("Oak"));
        EXPECT_EQ(s.app.feet_m(), oak_m);
        s.run(0.1);
        s.request(Command::LeapLast);
        EXPECT_THAT(s.said.back(), HasSubstr("Post"));
        s.run(0.1);
        s.request(Command::LeapLast);
        EXPECT_EQ(s.said.back(), phrase("leap.no_last", {{"key", s.app.keys().keys_of(Command::UndoLeap)}}));
        // After a turn, the series of leaps begins again with the nearest thing.
        s.tap(Command::TurnLeft, 0.3);
        s.request(Command::LeapNext);
        EXPECT_THAT(s.said.back(), Not(HasSubstr("Well")));
    }
}

TEST(Leaping, reaches_every_door_of_the_room_even_out_of_sight) {
    Body s("house.map");
    s.request(Command::Exits);
    s.run(0.1);
    const std::string exits = s.said.back();
    std::set<std::string> leapt;
    for (int i = 0; i < 24; ++i) {
        s.request(Command::LeapNext);
        leapt.insert(s.said.back());
        s.run(0.1);
    }
    // Checks all doors that the announced exits of the hall have named.
    for (const char* door : {"Front door", "Living room door", "Study door"}) {
        if (exits.find(door) == std::string::npos) continue;
        EXPECT_TRUE(std::any_of(leapt.begin(), leapt.end(),
                                [&](const std::string& text) { return text.find(door) != std::string::npos; }))
            << door << " of " << exits;
    }
}

TEST(Leaping, announces_a_leap_to_a_higher_or_lower_level) {
    test::SceneBuilder b;
    b.box({-10, -10, -0.2}, {10, 10, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    b.box({3, -2, 0}, {8, 2, 0.4}, "platform", SolidRole::Solid, {}, FeatureKind::Floor);
    const FeatureId post = b.box({5, -0.2, 0.4}, {5.4, 0.2, 2.5}, "Post");
    b.scene().features[post.value].landmark = true;
    b.start({0, 0, 0}, 0.0);
    Body s(b.share());
    s.request(Command::LeapNext);
    EXPECT_NEAR(s.app.feet_m().z, 0.4, 0.05);
    EXPECT_THAT(s.said.back(), HasSubstr("0.4 metres higher."));
}

}  // namespace moved_with_a_word_test
}  // namespace handrail
