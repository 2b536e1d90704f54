// Tests what happens when a walk meets an obstacle. The walker must slide along obstacles that it meets at a slant, and
// into a doorway whose frame it meets. All other obstacles must stop the walker. Also tests steps to the side.
#include "app/core/walking/gait.h"

#include <cmath>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"
#include "worlds/navigation/blind_ground.h"

namespace handrail {
namespace gait_test {

constexpr double kTick_m = 0.02;

// Walks while each tick achieves the fraction `part` of its movement. Returns the first result that is Stopped or
// Aside, and the distance until then; empty if the walk continues.
std::optional<std::pair<Gait::Course, double>> ends(double part, const std::optional<double>& aside_m = std::nullopt) {
    Gait gait;
    for (double far_m = kTick_m; far_m < 2.0; far_m += kTick_m) {
        const Gait::Course goes = gait.went(kTick_m, part * kTick_m, part < 1.0, [&] { return aside_m; });
        if (goes == Gait::Course::Stopped || goes == Gait::Course::Aside) return std::pair(goes, far_m);
    }
    return std::nullopt;
}

TEST(Gait, stops_at_once_at_head_on_obstacles_and_soon_at_almost_square_ones) {
    EXPECT_EQ(ends(0.0)->first, Gait::Course::Stopped);
    EXPECT_NEAR(ends(0.0)->second, kTick_m, 1e-9);
    EXPECT_EQ(ends(std::cos(67.5 * kPi / 180.0))->first, Gait::Course::Stopped);
    EXPECT_NEAR(ends(std::cos(67.5 * kPi / 180.0))->second, kStoppedWindow_m, kTick_m);
}

TEST(Gait, slides_along_obstacles_met_at_45_degrees_or_less) {
    EXPECT_FALSE(ends(std::cos(45.0 * kPi / 180.0)));
    EXPECT_FALSE(ends(std::cos(22.5 * kPi / 180.0)));
    EXPECT_FALSE(ends(1.0));
}

TEST(Gait, slides_into_a_doorway_at_most_twice_and_never_if_it_is_straight_ahead) {
    EXPECT_EQ(ends(0.0, 0.3)->first, Gait::Course::Aside);
    EXPECT_EQ(ends(0.0, 0.0)->first, Gait::Course::Stopped);
    Gait gait;
    const auto to_the_left = [] { return std::optional(-0.05); };
    EXPECT_EQ(gait.went(kTick_m, 0.0, true, to_the_left), Gait::Course::Aside);
    EXPECT_DOUBLE_EQ(gait.aside_left_m(), -0.05);
    gait.went_aside(0.02, 0.02);
    EXPECT_NEAR(gait.aside_left_m(), -0.03, 1e-12);
    gait.went_aside(0.04, 0.03);
    EXPECT_EQ(gait.aside_left_m(), 0.0);
    EXPECT_EQ(gait.went(kTick_m, 0.0, true, to_the_left), Gait::Course::Aside);
    gait.went_aside(0.02, 0.0);  // the walker meets something to the side, too
    EXPECT_EQ(gait.aside_left_m(), 0.0);
    EXPECT_EQ(gait.went(kTick_m, 0.0, true, to_the_left), Gait::Course::Stopped);
}

// A space of 10 by 10 m. A wall at y = 5 divides it and has a doorway 0.9 m wide around x = 5.
struct TwoRooms : test::AppSession {
    TwoRooms() {
        test::SceneBuilder b;
        b.box({0, 0, -0.2}, {10, 10, 0}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
        const auto wall = [&](const Vec3& low, const Vec3& high, const char* name) {
            b.box(low, high, name, SolidRole::Solid, "brick", FeatureKind::Wall);
        };
        wall({-0.2, -0.2, 0}, {10.2, 0, 2.6}, "south wall");
        wall({-0.2, 10, 0}, {10.2, 10.2, 2.6}, "north wall");
        wall({-0.2, 0, 0}, {0, 10, 2.6}, "west wall");
        wall({10, 0, 0}, {10.2, 10, 2.6}, "east wall");
        wall({0, 4.9, 0}, {4.55, 5.1, 2.6}, "middle wall");
        wall({5.45, 4.9, 0}, {10, 5.1, 2.6}, "middle wall");
        b.start({2, 2, 0}, 0.0);
        app.apply(WorldEntered{make_ready(b.share())}, now);
        run(0.1);
        request(Command::Exits);  // so that the session knows the routes from now on
    }
    void walk_from(const Vec3& feet_m, double heading_deg, Command command, int steps) {
        app.apply(Placed{feet_m, heading_deg * kPi / 180.0}, now);
        run(0.1);
        said.clear();
        bumped.clear();
        app.apply(CommandDown{command, steps}, now);
        app.apply(CommandUp{command}, now);
        for (int i = 0; i < 1200 && !app.idle(); ++i) run(1.0 / 60.0);
        run(0.2);
    }
};

TEST(WalkingInASession, slides_into_the_doorway_whose_frame_it_meets_and_reports_the_shoulder) {
    TwoRooms person;
    person.walk_from({5.4, 4.0, 0}, 0.0, Command::Forward, 3);
    EXPECT_GT(person.app.feet_m().y, 5.5);
    EXPECT_TRUE(person.heard("Door frame, right shoulder")) << testing::PrintToString(person.said);
    EXPECT_TRUE(person.bumped.empty());
    person.walk_from({4.6, 6.0, 0}, 180.0, Command::Forward, 3);
    EXPECT_LT(person.app.feet_m().y, 4.5);
    EXPECT_TRUE(person.heard("Door frame, right shoulder")) << testing::PrintToString(person.said);
    person.walk_from({4.6, 4.0, 0}, 0.0, Command::Forward, 3);
    EXPECT_GT(person.app.feet_m().y, 5.5);
    EXPECT_TRUE(person.heard("Door frame, left shoulder")) << testing::PrintToString(person.said);
}

TEST(WalkingInASession, is_stopped_by_a_wall_away_from_the_doorway) {
    TwoRooms person;
    person.walk_from({8.0, 4.0, 0}, 0.0, Command::Forward, 3);
    EXPECT_LT(person.app.feet_m().y, 4.7);
    EXPECT_NEAR(person.app.feet_m().x, 8.0, 0.01);
    EXPECT_EQ(person.bumped.size(), 1U);
}

TEST(WalkingInASession, takes_all_its_steps_along_a_wall_met_at_a_slant) {
    TwoRooms person;
    person.walk_from({2.0, 9.6, 0}, 45.0, Command::Forward, 6);
    EXPECT_NEAR(person.app.feet_m().y, 9.75, 0.02);
    EXPECT_NEAR(person.app.feet_m().x, 2.0 + 6 * 0.7, 0.2);
    EXPECT_TRUE(person.bumped.empty());
    EXPECT_GT(person.count(SoundKind::Contact), 4) << "one hears the wall";
}

TEST(WalkingInASession, steps_to_either_side_and_keeps_the_heading) {
    TwoRooms person;
    person.walk_from({5.0, 2.0, 0}, 0.0, Command::SideRight, 2);
    EXPECT_NEAR(person.app.feet_m().x, 6.4, 0.01);
    EXPECT_NEAR(person.app.feet_m().y, 2.0, 0.01);
    EXPECT_EQ(person.app.heading_rad(), 0.0);
    person.walk_from({5.0, 2.0, 0}, 0.0, Command::SideLeft, 10);
    EXPECT_NEAR(person.app.feet_m().x, 0.25, 0.02) << "until the wall";
    EXPECT_EQ(person.bumped.size(), 1U);
}

}  // namespace gait_test
}  // namespace handrail
