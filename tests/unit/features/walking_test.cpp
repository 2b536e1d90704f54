// Tests walking, moving by ear, and the ground underfoot. The tests use only plain state, without a session.
#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "app/core/walking/paces.h"
#include "app/core/walking/walking.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/unit/features/plain_session.h"
#include "worlds/base/typist.h"

namespace handrail {
namespace walking_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kTick_s = 1.0 / 60.0;

// Returns a floor of 20 by 20 metres with nothing around it. A wall crosses the floor 3 m north of the base.
std::shared_ptr<const Scene> terrace() {
    test::SceneBuilder builder;
    builder.box({-10.0, -10.0, -0.5}, {10.0, 10.0, 0.0}, "floor");
    builder.box({-10.0, 3.0, 0.0}, {10.0, 3.3, 2.5}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    builder.box({4.0, -1.0, 0.0}, {4.2, 1.0, 2.0}, "gate", SolidRole::Solid, {}, FeatureKind::Door);
    builder.start({0.0, 0.0, 0.0}, 0.0);
    return builder.share();
}

struct OnFoot {
    explicit OnFoot(std::shared_ptr<const Scene> scene = terrace()) : plain(std::move(scene)) {
        plain.context.session_requests.place = [this](const Vec3& feet_m, double heading_rad, double) {
            walking.set_down(feet_m, heading_rad);
        };
        by_ear.where_am_i = [] { return std::string("here"); };
        walking.on_bumped = [this](FeatureId feature, double) { bumped.push_back(feature); };
        plain.context.session_requests.move_base = [this](const Vec3& feet_m, double heading_rad) {
            plain.world.home_feet_m = feet_m;
            plain.world.home_heading_rad = heading_rad;
        };
        walking.enter_world();
        settle();
    }
    void tick() { walking.tick(now_s += kTick_s, kTick_s); }
    // Ticks until the walker has finished all movements, for ten seconds at most.
    void settle() {
        tick();
        for (int i = 0; i < 600 && !walking.idle(); ++i) tick();
    }
    void tap(Command command) {
        EXPECT_TRUE(walking.act(command, now_s));
        settle();
    }
    const Vec3& feet_m() const { return plain.avatar.feet_m(); }

    test::PlainSession plain;
    HeldKeys keys;
    ByEar by_ear{plain.context, plain.avatar, keys};
    Footing footing{plain.context, plain.avatar};
    Walking walking{plain.context, plain.avatar, keys, by_ear, footing};
    std::vector<FeatureId> bumped;
    double now_s = 0.0;
};

int count_of(const std::vector<CueRequest>& cues, CueRequestKind kind) {
    return static_cast<int>(
        std::count_if(cues.begin(), cues.end(), [kind](const CueRequest& cue) { return cue.kind == kind; }));
}

// Earlier, met_words() read past the end of the world's features if the verbosity omitted materials.
TEST(WalkingFeature, calls_an_unnamed_obstacle_a_wall_at_every_verbosity) {
    OnFoot one;
    for (const FeatureId nameless : {kNoFeature, FeatureId{1000}})
        for (int verbosity = 1; verbosity <= 4; ++verbosity) {
            one.plain.person.settings.speech.verbosity = verbosity;
            TraceHit met;
            met.feature = nameless;
            EXPECT_THAT(met_words(one.plain.context, met, 0.0), HasSubstr("wall"));
        }
}

TEST(WalkingFeature, takes_one_audible_step_per_tap) {
    OnFoot one;
    one.tap(Command::Forward);
    EXPECT_NEAR(one.feet_m().y, one.plain.person.settings.walk.step_length_m, 1e-6);
    EXPECT_EQ(count_of(one.plain.cues.take(), CueRequestKind::Footstep), 1);
    one.tap(Command::TurnRight);
    EXPECT_NEAR(one.plain.avatar.heading_rad, radians_from_degrees(one.plain.person.settings.walk.turn_deg), 1e-9);
    EXPECT_FALSE(one.walking.act(Command::Use, one.now_s)) << "another's command";
    EXPECT_EQ(one.walking.path_m().size(), 3U) << "a point for each quarter of a metre";
}

TEST(WalkingFeature, announces_a_bump_once_until_the_body_has_moved_away) {
    OnFoot one;
    one.keys.press(Command::Forward);
    for (int i = 0; i < 300; ++i) one.tick();
    EXPECT_EQ(count_of(one.plain.cues.take(), CueRequestKind::Bump), 1);
    ASSERT_EQ(one.bumped.size(), 1U);
    EXPECT_EQ(one.plain.world.scene->features[one.bumped[0].value].kind, FeatureKind::Wall);
    one.keys.release_all();
    one.tap(Command::Back);
    one.tap(Command::Forward);
    one.tap(Command::Forward);
    EXPECT_EQ(count_of(one.plain.cues.take(), CueRequestKind::Bump), 1);
}

TEST(WalkingFeature, treats_invalid_numbers_as_a_stick_at_rest) {
    OnFoot one;
    one.walking.steer({std::numeric_limits<double>::quiet_NaN(), 0.0, std::numeric_limits<double>::infinity()});
    for (int i = 0; i < 60; ++i) one.tick();
    EXPECT_EQ(one.feet_m().y, 0.0);
    EXPECT_EQ(one.plain.avatar.heading_rad, 0.0);
    one.walking.steer({2.0, 0.0, 0.0});
    for (int i = 0; i < 60; ++i) one.tick();
    EXPECT_NEAR(one.feet_m().y, one.plain.person.settings.walk.speed_m_per_s, 1e-6) << "never faster than a key";
}

TEST(WalkingFeature, stops_at_an_edge_with_no_floor_below_however_often_the_key_is_pressed) {
    OnFoot one;
    one.walking.set_down({0.0, -9.0, 0.0}, kPi);
    one.settle();
    (void)one.plain.said();
    one.keys.press(Command::Forward);
    for (int i = 0; i < 120; ++i) one.tick();
    EXPECT_GT(one.feet_m().y, -10.1);
    EXPECT_TRUE(one.plain.avatar.walker->state().on_ground);
    EXPECT_THAT(one.plain.said(), ::testing::Contains(phrase("walking.edge_very_deep")));
    one.tick();
    EXPECT_THAT(one.plain.said(), IsEmpty()) << "told once for a press";
    one.keys.release_all();
    for (int press = 0; press < 3; ++press) {
        EXPECT_TRUE(one.walking.act(Command::Forward, one.now_s));
        for (int i = 0; i < 60; ++i) one.tick();
        EXPECT_TRUE(one.plain.avatar.walker->state().on_ground) << press;
    }
}

// While this object exists, the session addresses a person who types lines.
struct ByLines {
    ByLines() { speak_to(ActsBy::Lines); }
    ~ByLines() { speak_to(ActsBy::WindowKeys); }
    ByLines(const ByLines&) = delete;
    ByLines& operator=(const ByLines&) = delete;
};

// Returns the announcements about steps, including those about blocked steps.
std::vector<std::string> reported(OnFoot& one) {
    std::vector<std::string> words;
    for (CueRequest& cue : one.plain.cues.take())
        if (cue.kind == CueRequestKind::Say || cue.kind == CueRequestKind::Bump) words.push_back(std::move(cue.text));
    return words;
}

TEST(WalkingFeature, takes_as_many_steps_as_were_typed) {
    OnFoot one;
    one.walking.set_down({0.0, -8.0, 0.0}, 0.0);
    EXPECT_TRUE(one.walking.act(Command::Forward, one.now_s, 11));
    one.settle();
    EXPECT_NEAR(one.feet_m().y, -8.0 + 11 * 0.7, 1e-6);
    EXPECT_TRUE(one.walking.act(Command::Back, one.now_s, 11));
    one.settle();
    EXPECT_NEAR(one.feet_m().y, -8.0, 1e-6);
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(one.walking.act(Command::Forward, one.now_s));
    one.settle();
    EXPECT_NEAR(one.feet_m().y, -8.0 + 8 * 0.7, 1e-6) << "keys that are tapped fast wait, but not for ever";
}

TEST(WalkingFeature, treats_a_counted_step_command_as_one_request_at_an_edge) {
    OnFoot one;
    one.walking.set_down({0.0, -9.0, 0.0}, kPi);
    EXPECT_TRUE(one.walking.act(Command::Forward, one.now_s, 12));
    one.settle();
    EXPECT_TRUE(one.plain.avatar.walker->state().on_ground) << "the other eleven do not ask a second time";
    EXPECT_GT(one.feet_m().y, -10.3);
}

TEST(WalkingFeature, reports_each_step_and_what_ended_it_to_a_person_who_types) {
    const ByLines typist;
    OnFoot one;
    one.tap(Command::Forward);
    for (int i = 0; i < 12; ++i) one.tick();
    EXPECT_THAT(reported(one), ElementsAre("1 step"));
    EXPECT_TRUE(one.walking.act(Command::Forward, one.now_s, 9));
    one.settle();
    for (int i = 0; i < 12; ++i) one.tick();
    EXPECT_THAT(reported(one), ElementsAre("3 steps, then wall"));
    for (int i = 0; i < 2; ++i) {
        one.tap(Command::Forward);
        for (int frame = 0; frame < 12; ++frame) one.tick();
        EXPECT_THAT(reported(one), ElementsAre("Blocked. Wall")) << "each time";
    }
    one.walking.set_down({0.0, -9.0, 0.0}, kPi);
    EXPECT_TRUE(one.walking.act(Command::Forward, one.now_s, 5));
    one.settle();
    EXPECT_THAT(reported(one), ElementsAre("Drop, 1 step ahead", "1 step. " + phrase("walking.edge_very_deep")));
}

TEST(WalkingFeature, reports_on_which_side_a_step_was_blocked) {
    OnFoot one;
    const auto met = [&](const Vec3& feet_m, double heading_rad, Command command) {
        one.walking.set_down(feet_m, heading_rad);
        one.settle();
        (void)reported(one);
        EXPECT_TRUE(one.walking.act(command, one.now_s));
        one.settle();
        const std::vector<std::string> words = reported(one);
        return words.empty() ? std::string() : words.front();
    };
    EXPECT_EQ(met({0.0, 2.7, 0.0}, 0.0, Command::Forward), "Wall");
    EXPECT_EQ(met({0.0, 2.7, 0.0}, kPi, Command::Back), "Wall, behind");
    // The gate is four metres east of the base and two metres wide. Only one shoulder of the walker meets the end of
    // the gate.
    EXPECT_EQ(met({3.7, 1.2, 0.0}, 0.5 * kPi, Command::Forward), "Gate, right shoulder");
    EXPECT_EQ(met({3.7, -1.2, 0.0}, 0.5 * kPi, Command::Forward), "Gate, left shoulder");
    one.walking.steer({0.0, 1.0, 0.0});
    one.walking.set_down({3.7, 0.0, 0.0}, 0.0);
    (void)reported(one);
    for (int i = 0; i < 20; ++i) one.tick();
    EXPECT_THAT(reported(one), ElementsAre("Gate, right"));
    one.plain.person.settings.speech.verbosity = 0;
    one.walking.steer({});
    EXPECT_EQ(met({0.0, 2.7, 0.0}, 0.0, Command::Forward), "") << "the thud alone";
}

TEST(WalkingFeature, announces_only_the_last_heading_of_several_turns_in_sixteen_winds) {
    OnFoot one;
    for (int i = 0; i < 8; ++i) {
        EXPECT_TRUE(one.walking.act(Command::TurnRight, one.now_s));
        for (int frame = 0; frame < 3; ++frame) one.tick();
    }
    one.settle();
    for (int frame = 0; frame < 12; ++frame) one.tick();
    EXPECT_THAT(reported(one), ElementsAre("South"));
    EXPECT_TRUE(one.walking.act(Command::TurnRight, one.now_s, 3));
    one.settle();
    for (int frame = 0; frame < 12; ++frame) one.tick();
    EXPECT_THAT(reported(one), ElementsAre("West-south-west"));
    std::vector<std::string> winds;
    for (int i = 0; i < 16; ++i) {
        one.tap(Command::TurnLeft);
        for (int frame = 0; frame < 12; ++frame) one.tick();
        const std::vector<std::string> heading = reported(one);
        ASSERT_EQ(heading.size(), 1U);
        winds.push_back(heading.front());
    }
    std::sort(winds.begin(), winds.end());
    EXPECT_EQ(std::unique(winds.begin(), winds.end()), winds.end()) << "each notch has a name of its own";
}

TEST(WalkingFeature, returns_to_the_base_after_falling_out_of_the_world) {
    OnFoot one;
    one.walking.set_down({30.0, 0.0, 0.0}, 1.0);
    for (int i = 0; i < 600 && one.feet_m().x > 1.0; ++i) one.tick();
    EXPECT_EQ(one.feet_m(), one.plain.world.home_feet_m);
    EXPECT_THAT(one.plain.said(), ::testing::Contains(phrase("session.fell_out")));
}

// A walker over a floor, or over no floor at all. The base is far from the floor and has nothing below it.
struct OverNothing : OnFoot {
    using OnFoot::OnFoot;
    int falls_within_a_minute() {
        int falls = 0;
        for (int i = 0; i < 60 * 60; ++i) {
            tick();
            for (const std::string& said : plain.said())
                falls += said == phrase("session.fell_from_base") || said == phrase("session.fell_out") ||
                         said == phrase("session.nothing_holds");
        }
        return falls;
    }
};

TEST(WalkingFeature, falls_once_from_a_base_in_the_air) {
    for (const bool other_start : {false, true}) {
        SCOPED_TRACE(other_start);
        test::SceneBuilder builder;
        builder.box({-10.0, -10.0, -0.5}, {10.0, 10.0, 0.0}, "floor");
        builder.box({-10.0, -10.0, 0.0}, {10.0, -9.0, 2.5}, "block");
        builder.start({30.0, 0.0, 0.0}, 0.0);
        if (other_start) builder.start({-8.0, 8.0, 0.0}, 0.0);
        OverNothing one(builder.share());
        EXPECT_EQ(one.falls_within_a_minute(), 1);
        EXPECT_NEAR(one.feet_m().z, 0.0, 0.01);
        EXPECT_EQ(one.feet_m(), one.plain.world.home_feet_m);
        if (other_start) EXPECT_LT(glm::distance(one.feet_m(), Vec3(-8.0, 8.0, 0.0)), 0.01);
        else EXPECT_GT(one.feet_m().x, 7.0) << "the nearest floor";
        one.tap(Command::Home);
        EXPECT_EQ(one.falls_within_a_minute(), 0);
    }
}

TEST(WalkingFeature, stays_in_the_air_if_there_is_no_ground) {
    test::SceneBuilder builder;
    builder.box({-10.0, -10.0, -2.0}, {10.0, 10.0, 0.0}, "lake without a bed", SolidRole::Liquid);
    builder.start({30.0, 0.0, 0.0}, 0.0);
    OverNothing one(builder.share());
    EXPECT_EQ(one.falls_within_a_minute(), 1);
    EXPECT_EQ(one.feet_m(), one.plain.world.home_feet_m);
    EXPECT_TRUE(one.walking.idle());
    one.keys.press(Command::Forward);
    EXPECT_EQ(one.falls_within_a_minute(), 1) << "says once why nobody walks there";
    one.keys.release_all();
    one.walking.set_down({0.0, 0.0, 10.0}, 0.0);
    one.tick();
    EXPECT_NE(one.feet_m(), one.plain.world.home_feet_m) << "what is set down falls again";
}

TEST(ByEarFeature, leaps_to_a_visible_thing_and_back) {
    OnFoot one;
    one.tap(Command::UndoLeap);
    EXPECT_THAT(one.plain.said(), ElementsAre(phrase("walking.nothing_to_undo")));
    one.tap(Command::LeapNext);
    EXPECT_GT(one.feet_m().x, 3.0) << "before the gate";
    EXPECT_LT(one.feet_m().x, 4.0);
    EXPECT_THAT(one.plain.said(), ElementsAre(HasSubstr("ate")));
    one.tap(Command::UndoLeap);
    EXPECT_NEAR(glm::length(one.feet_m()), 0.0, 1e-3);
    EXPECT_THAT(one.plain.said(), ElementsAre(HasSubstr("here")));
}

TEST(ByEarFeature, refuses_to_return_to_a_place_that_is_blocked_by_a_solid) {
    OnFoot one;
    const Vec3 gate_m{4.1, 0.0, 0.0};
    one.walking.set_down(gate_m, 0.0);
    ASSERT_TRUE(one.plain.world.solids->blocked(one.feet_m(), one.plain.avatar.walker->shape()));
    one.tap(Command::Home);
    ASSERT_FALSE(one.plain.world.solids->blocked(one.feet_m(), one.plain.avatar.walker->shape()));
    (void)one.plain.said();
    const Vec3 free_m = one.feet_m();
    one.tap(Command::UndoLeap);
    EXPECT_EQ(one.feet_m(), free_m);
    EXPECT_THAT(one.plain.said(), ElementsAre(phrase("walking.nothing_to_undo")));
}

TEST(ByEarFeature, goes_back_along_the_walked_trail) {
    OnFoot one;
    for (int i = 0; i < 3; ++i) one.tap(Command::Forward);
    one.tap(Command::TurnLeft);
    one.tap(Command::Back);
    const double away_m = glm::length(one.feet_m());
    ASSERT_GT(away_m, 1.0);
    one.keys.press(Command::Retrace);
    EXPECT_TRUE(one.walking.act(Command::Retrace, one.now_s));
    EXPECT_TRUE(one.by_ear.leads());
    for (int i = 0; i < 1200 && one.by_ear.leads(); ++i) one.tick();
    EXPECT_LT(glm::length(one.feet_m()), 0.05);
    EXPECT_THAT(one.plain.said(), ::testing::Contains(phrase("walking.at_beginning")));
}

TEST(ByEarFeature, trails_a_wall_until_another_key_ends_it) {
    OnFoot one;
    one.walking.set_down({-5.0, 2.4, 0.0}, kPi / 2.0);
    one.settle();
    one.keys.press(Command::TrailLeft);
    EXPECT_TRUE(one.walking.act(Command::TrailLeft, one.now_s));
    for (int i = 0; i < 120; ++i) one.tick();
    EXPECT_GT(one.feet_m().x, -4.0);
    EXPECT_NEAR(one.feet_m().y, 3.0 - one.plain.avatar.walker->size().radius_m - Trail::kGap_m, 0.01);
    const auto normal = one.by_ear.wall_at_side();
    ASSERT_TRUE(normal);
    EXPECT_NEAR(normal->y, -1.0, 1e-6) << "out of the wall";
    EXPECT_TRUE(one.walking.act(Command::TurnRight, one.now_s));
    EXPECT_FALSE(one.by_ear.leads());
    EXPECT_FALSE(one.by_ear.wall_at_side());
}

}  // namespace walking_test
}  // namespace handrail
