// Tests moving by ear in a session: keys, words and sounds.
#include <algorithm>

#include "app/core/scenario/session_log.h"
#include "app/core/session/headless_session.h"
#include "app/core/session/session.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace walking_test {

using test::SceneBuilder;

struct Walk {
    explicit Walk(std::shared_ptr<const Scene> scene, const Settings& settings = {}) : app(settings, HandFacts{}) {
        app.apply(WorldEntered{make_ready(std::move(scene))}, 0.0);
    }
    void run(double seconds) {
        for (const double until = now + seconds; now < until - 1e-9;) {
            now += 1.0 / 60.0;
            app.tick(now, ToolState{});
            for (CueRequest& cue : app.take_cues()) cues.push_back(std::move(cue));
        }
    }
    void hold(Command command, double seconds) {
        app.apply(CommandDown{command}, now);
        run(seconds);
        app.apply(CommandUp{command}, now);
    }
    void tap(Command command, double then_s = 1.0) {
        hold(command, 0.1);
        run(then_s);
    }
    bool said(const std::string& words) const {
        return std::any_of(cues.begin(), cues.end(), [&](const CueRequest& cue) {
            return cue.kind == CueRequestKind::Say && words_in_order(words, cue.text);
        });
    }
    int sounds(SoundKind kind) const {
        return static_cast<int>(std::count_if(cues.begin(), cues.end(), [&](const CueRequest& cue) {
            return cue.kind == CueRequestKind::Play && cue.sound == kind;
        }));
    }
    Session app;
    double now = 0.0;
    std::vector<CueRequest> cues;
};

// Makes a room of 6 by 4 metres with a door in the south wall, where the walker starts, and a landmark in the north.
std::shared_ptr<const Scene> room() {
    SceneBuilder b;
    b.box({0, 0, -0.2}, {6, 4, 0}, "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
    b.box({-0.2, 4, 0}, {6.2, 4.2, 2.6}, "north wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({-0.2, -0.2, 0}, {2.5, 0, 2.6}, "south wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({3.5, -0.2, 0}, {6.2, 0, 2.6}, "south wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({2.5, -0.15, 0}, {3.5, -0.1, 2.1}, "Door", SolidRole::Solid, "wood", FeatureKind::Door);
    b.box({6, 0, 0}, {6.2, 4, 2.6}, "east wall", SolidRole::Solid, "wood", FeatureKind::Wall);
    b.box({-0.2, 0, 0}, {0, 4, 2.6}, "west wall", SolidRole::Solid, "brick", FeatureKind::Wall);
    const FeatureId clock = b.box({2.9, 3.7, 0}, {3.3, 4, 1.9}, "Clock", SolidRole::Solid, "wood", FeatureKind::Object);
    b.scene().features[clock.value].landmark = true;
    b.scene().name = "test room";
    b.start({3, 0.5, 0}, 0.0);
    return b.share();
}

// Makes a platform that reaches 10 m to the north. Its edge is `deep` above the floor.
std::shared_ptr<const Scene> platform(double deep) {
    SceneBuilder b;
    b.box({-5, -5, -4}, {5, 4, 0}, "floor", SolidRole::Solid, "concrete", FeatureKind::Floor);
    b.box({-5, 4, -4}, {5, 14, -deep}, "lower floor", SolidRole::Solid, "concrete", FeatureKind::Floor);
    b.start({0, 0, 0}, 0.0);
    return b.share();
}

TEST(Walking, trailing_stops_at_an_obstacle_and_turns_round_on_the_same_wall) {
    Walk w(room());
    w.tap(Command::TurnRight);
    w.tap(Command::TrailOn, 4.0);
    EXPECT_TRUE(w.said("Door")) << "the nearest wall";
    w.tap(Command::TrailOn, 8.0);
    EXPECT_TRUE(w.said("South wall"));
    w.tap(Command::TrailOn, 8.0);
    EXPECT_TRUE(w.said("Corner"));
    const Vec3 corner = w.app.feet_m();
    w.run(3.0);
    EXPECT_LT(glm::length(w.app.feet_m() - corner), 1e-6) << "it waits there";
    EXPECT_TRUE(w.app.idle());
    EXPECT_EQ(w.sounds(SoundKind::Corner), 1);
    w.tap(Command::TrailBack, 1.0);
    w.tap(Command::TrailOn, 8.0);
    EXPECT_GT(w.sounds(SoundKind::Corner), 1) << "back round the same corner";
}

TEST(Walking, square_up_turns_towards_the_nearest_wall_or_along_it) {
    Walk w(room());
    for (int i = 0; i < 3; ++i) w.tap(Command::TurnRight, 0.5);  // three notches are 67.5 degrees
    w.tap(Command::SquareUp);
    EXPECT_NEAR(degrees_from_radians(w.app.heading_rad()), 90.0, 1e-9);
    EXPECT_TRUE(w.said("Turned square. Facing east"));
}

TEST(Walking, free_turns_have_no_notches_and_notches_have_the_size_that_is_set) {
    Settings settings;
    for (const double deg : {22.5, 45.0, 90.0}) {
        settings.walk.turn_deg = deg;
        Walk w(room(), settings);
        w.tap(Command::TurnRight);
        EXPECT_NEAR(degrees_from_radians(w.app.heading_rad()), deg, 1e-9);
    }
    Walk w(room());
    w.hold(Command::FreeRight, 1.0);
    w.run(0.5);
    const double turned = degrees_from_radians(w.app.heading_rad());
    EXPECT_GT(turned, 30.0);
    EXPECT_LT(turned, 70.0);
    EXPECT_TRUE(w.said("North-east") || w.said("East"));
}

TEST(Walking, a_leap_and_home_can_be_undone_one_after_the_other) {
    Walk w(room());
    w.tap(Command::Forward);
    const Vec3 here = w.app.feet_m();
    w.tap(Command::LeapNext);
    const Vec3 leapt = w.app.feet_m();
    EXPECT_TRUE(w.said("Door") || w.said("Clock"));
    EXPECT_GT(glm::length(leapt - here), 0.3);
    w.tap(Command::LeapNext);
    EXPECT_GT(glm::length(w.app.feet_m() - leapt), 1.0) << "the other of the two";
    w.tap(Command::LeapLast);
    EXPECT_LT(glm::length(w.app.feet_m() - leapt), 0.8) << "back at the first";
    w.tap(Command::Home);
    for (int i = 0; i < 4; ++i) w.tap(Command::UndoLeap);
    EXPECT_LT(glm::length(w.app.feet_m() - here), 1e-3);
    w.tap(Command::UndoLeap);
    EXPECT_TRUE(w.said("There is nothing to undo"));
}

TEST(Walking, a_leap_can_lead_exactly_onto_the_persons_mark) {
    Settings settings;
    settings.marks.ask_name = false;
    Walk w(room(), settings);
    const Vec3 marked = w.app.feet_m();
    w.tap(Command::DropMark);
    w.hold(Command::Forward, 1.5);
    ASSERT_GT(glm::length(w.app.feet_m() - marked), 1.0);
    ASSERT_TRUE(w.said("Mark 1"));
    const Vec3 left = w.app.feet_m();
    int onto_it = 0;
    for (int i = 0; i < 3; ++i) {  // the three leaps go to the door, the clock and the mark
        w.tap(Command::LeapNext);
        onto_it += glm::length(w.app.feet_m() - marked) < 0.05 ? 1 : 0;
    }
    EXPECT_EQ(onto_it, 1);
    for (int i = 0; i < 3; ++i) w.tap(Command::UndoLeap);
    EXPECT_LT(glm::length(w.app.feet_m() - left), 1e-3);
}

TEST(Walking, going_back_follows_the_walked_trail_to_its_beginning) {
    Walk w(room());
    const Vec3 begin = w.app.feet_m();
    w.hold(Command::Forward, 2.0);
    for (int i = 0; i < 4; ++i) w.tap(Command::TurnRight, 0.4);
    w.hold(Command::Forward, 1.5);
    const Vec3 turn(begin.x, begin.y + 2.0, 0.0);
    double nearest_turn = 9.0;
    w.app.apply(CommandDown{Command::Retrace}, w.now);
    for (int i = 0; i < 60; ++i) {
        w.run(0.1);
        nearest_turn = std::min(nearest_turn, glm::length(w.app.feet_m() - turn));
    }
    w.app.apply(CommandUp{Command::Retrace}, w.now);
    EXPECT_LT(nearest_turn, 0.3) << "round the corner, not across";
    EXPECT_LT(glm::length(w.app.feet_m() - begin), 0.05);
    EXPECT_TRUE(w.said("You are where your route began"));
}

TEST(Walking, an_edge_stops_the_walker_until_a_second_request_unless_that_is_switched_off) {
    Settings settings;
    Walk w(platform(1.2), settings);
    w.hold(Command::Forward, 6.0);
    EXPECT_NEAR(w.app.feet_m().y, 4.0, 0.05);
    EXPECT_TRUE(w.said("Edge. Drop, 1.2 metres deep"));
    EXPECT_GT(w.sounds(SoundKind::DropNear), 4);
    w.run(1.0);
    // This is three seconds after the stop, so the press is again the first press at the edge.
    w.hold(Command::Forward, 0.5);
    EXPECT_NEAR(w.app.feet_m().y, 4.0, 0.05);
    w.run(0.5);
    w.hold(Command::Forward, 1.5);
    EXPECT_NEAR(w.app.feet_m().z, -1.2, 1e-2);

    settings.walk.stop_at_drops = false;
    settings.walk.callouts = false;
    Walk off(platform(1.2), settings);
    off.hold(Command::Forward, 6.0);
    EXPECT_NEAR(off.app.feet_m().z, -1.2, 1e-2);
    EXPECT_FALSE(off.said("Edge"));
    EXPECT_FALSE(off.said("Drop"));

    Walk step(platform(0.3), Settings{});
    step.hold(Command::Forward, 6.0);
    EXPECT_NEAR(step.app.feet_m().z, -0.3, 1e-2) << "no drop";
    EXPECT_EQ(step.sounds(SoundKind::DropNear), 0);
}

TEST(Walking, callouts_are_switched_off_and_on_by_their_key_and_stay_so) {
    Walk w(platform(1.2));
    w.tap(Command::Callouts);
    EXPECT_TRUE(w.said("Callouts off"));
    const auto changes = w.app.take_setting_changes();
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_EQ(changes[0], (std::pair<std::string, std::string>("walk.callouts", "false")));
    w.hold(Command::Forward, 3.5);
    EXPECT_FALSE(w.said("Drop ahead"));
    w.tap(Command::Callouts);
    EXPECT_TRUE(w.said("Callouts on"));
}

// In a level with steps half a metre high, the walker goes for a minute in every direction. The walker gets round, and
// the session says little without a request.
TEST(Walking, game_levels_are_walkable_and_quiet) {
    const auto ours = test::project_root() / "tests/scenarios/worlds/game_step.map";
    for (const auto& file : test::with_real_worlds({ours}, {"agtut01.map", "quake-e1m1.map"})) {
        const std::string name = file.filename().string();
        auto scene = read_world(file);
        ASSERT_TRUE(scene) << name;
        Walk w(std::make_shared<const Scene>(std::move(*scene)));
        const Vec3 start = w.app.feet_m();
        double farthest = 0.0;
        for (int i = 0; i < 16; ++i) {
            w.hold(Command::Forward, 4.0);
            farthest = std::max(farthest, glm::length(w.app.feet_m() - start));
            for (int k = 0; k < 5; ++k) w.tap(Command::TurnRight, 0.2);
        }
        int reported = 0, edges = 0;
        for (const CueRequest& cue : w.cues)
            if (cue.kind == CueRequestKind::Say) {
                reported += words_in_order("Stairs ahead", cue.text) || words_in_order("Drop ahead", cue.text) ||
                            words_in_order("Ramp", cue.text);
                edges += words_in_order("Edge Drop", cue.text);
            }
        std::cout << name << ": " << farthest << " m, " << reported << " callouts, " << edges << " edges in " << w.now
                  << " s\n";
        EXPECT_GT(farthest, 3.0) << name;
        EXPECT_LE(reported, static_cast<int>(w.now / 5.0)) << name;
        EXPECT_LE(edges, 4) << name;
    }
}

}  // namespace walking_test
}  // namespace handrail
