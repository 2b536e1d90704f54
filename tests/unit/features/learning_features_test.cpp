// Tests how a person learns a place, and the hunt. Each test uses only plain state, without a session.
#include <gmock/gmock.h>

#include <optional>

#include "app/core/learning/clock_hunt.h"
#include "app/core/learning/place_learning.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/features/plain_session.h"

namespace handrail {
namespace learning_features_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// Returns a hall of 10 by 6 m.
std::shared_ptr<const Scene> hall() {
    test::SceneBuilder builder;
    const auto wall = [&](const Vec3& min_m, const Vec3& max_m, const std::string& name) {
        builder.box(min_m, max_m, name, SolidRole::Solid, {}, FeatureKind::Wall);
    };
    builder.box({-0.2, -0.2, -0.2}, {10.2, 6.2, 0.0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    wall({-0.2, -0.2, 0.0}, {10.2, 0.0, 3.0}, "south wall");
    wall({-0.2, 6.0, 0.0}, {10.2, 6.2, 3.0}, "north wall");
    wall({-0.2, 0.0, 0.0}, {0.0, 6.0, 3.0}, "west wall");
    wall({10.0, 0.0, 0.0}, {10.2, 6.0, 3.0}, "east wall");
    builder.start({1.0, 1.0, 0.0}, 0.0);
    builder.scene().name = "hall";
    return builder.share();
}

struct Learner : test::PlainSession {
    Learner() : PlainSession(hall()) {
        rooms.enter_world(as_read);
        rooms.tick(0.0);
        learning.enter_world(0.0);
    }
    std::string progress(double now_s) {
        EXPECT_TRUE(learning.act(Command::ProgressReport, now_s));
        const std::vector<std::string> words = said();
        return words.size() == 1 ? words.front() : std::string("not one answer");
    }
    // Walks east along the south wall. If `trails` is true, the walker trails the wall; otherwise it walks freely.
    void walk_east(bool trails, double& now_s) {
        for (double x = 0.3; x < 9.8; x += 0.1, now_s += 0.1) {
            stand({x, 0.35, 0.0});
            avatar.walker->tick(Vec3(0.0), 0.1);
            learning.note(std::nullopt, trails ? std::optional(Vec3(0.0, 1.0, 0.0)) : std::nullopt, now_s);
            learning.tick(now_s);
        }
    }
    Rooms rooms{context};
    PlaceLearning learning{context, rooms};
};

TEST(PlaceLearningFeature, reports_what_was_trailed_and_walked_since_entering_the_world) {
    Learner learner;
    EXPECT_THAT(learner.progress(0.0), AllOf(HasSubstr("Walls 0 percent, floor 0 percent"), Not(HasSubstr("ouched"))));
    double now_s = 1.0;
    learner.walk_east(false, now_s);
    EXPECT_THAT(learner.progress(now_s), AllOf(HasSubstr("Walls 0 percent"), Not(HasSubstr("floor 0 percent"))));
    learner.walk_east(true, now_s);
    EXPECT_THAT(learner.progress(now_s), AllOf(Not(HasSubstr("Walls 0 percent")), HasSubstr("outh wall")));
    EXPECT_THAT(learner.progress(now_s), Not(HasSubstr("orth wall")));
    learner.learning.enter_world(now_s);
    EXPECT_THAT(learner.progress(now_s), HasSubstr("Walls 0 percent, floor 0 percent. 0 seconds"));
}

TEST(PlaceLearningFeature, counts_walls_that_the_body_bumps_into_as_touched) {
    Learner learner;
    learner.stand({1.0, 5.7, 0.0});
    learner.learning.note(Vec3(0.0, -1.0, 0.0), std::nullopt, 0.1);
    EXPECT_THAT(learner.progress(0.2), HasSubstr("orth wall"));
}

TEST(PlaceLearningFeature, plays_a_corner_once_when_the_hand_touches_two_walls) {
    Learner learner;
    learner.hands.right.present = true;
    ToolState& tool = learner.hands.tool;
    tool.ticks = 1;
    tool.waiting_for_hand = false;
    tool.contacts.count = 2;
    const auto feature_of = [&](const char* name) {
        const auto& features = learner.world.scene->features;
        for (std::uint32_t i = 0; i < features.size(); ++i)
            if (features[i].name == name) return FeatureId{i};
        return kNoFeature;
    };
    tool.contacts.contacts[0] = {.feature = feature_of("south wall"), .normal = {0.0, 1.0, 0.0}};
    tool.contacts.contacts[1] = {.feature = feature_of("west wall"), .normal = {1.0, 0.0, 0.0}};
    const auto corners = [&](double now_s) {
        learner.learning.note(std::nullopt, std::nullopt, now_s);
        return learner.heard(SoundKind::Corner);
    };
    EXPECT_EQ(corners(1.0), 1U);
    EXPECT_EQ(corners(1.1), 0U) << "still in it";
    tool.contacts.contacts[1].normal = {0.0, 1.0, 0.0};
    EXPECT_EQ(corners(5.0), 0U) << "one plane is no corner";
}

TEST(PlaceLearningFeature, announces_progress_in_its_mode_and_is_silent_outside_it) {
    Learner learner;
    double now_s = 1.0;
    learner.walk_east(true, now_s);
    EXPECT_THAT(learner.said(), IsEmpty());
    EXPECT_TRUE(learner.learning.act(Command::LearnPlace, now_s));
    EXPECT_THAT(learner.said(), ElementsAre(HasSubstr("Learning: ")));
    learner.learning.tick(now_s + 2.0);
    EXPECT_THAT(learner.said(), ElementsAre(HasSubstr("outh wall done, 1 of 4")));
    learner.learning.tick(now_s + 4.0);
    EXPECT_THAT(learner.said(), IsEmpty()) << "told once";
    EXPECT_TRUE(learner.learning.act(Command::LearnPlace, now_s + 5.0));
    EXPECT_THAT(learner.said(), ElementsAre(HasSubstr("Learning has ended")));
}

TEST(PlaceLearningFeature, leads_to_the_room_that_is_chosen_from_its_list) {
    Learner learner;
    std::optional<std::uint32_t> gone_to;
    learner.learning.on_go_to_room = [&](std::uint32_t room, double) { gone_to = room; };
    EXPECT_TRUE(learner.learning.act(Command::LearntRooms, 1.0));
    EXPECT_THAT(learner.said(), ElementsAre(HasSubstr("Rooms learnt: 0 of 1")));
    EXPECT_FALSE(gone_to);
    (void)learner.lists.dialogue.line("enter", 1.0);
    EXPECT_EQ(gone_to, learner.rooms.here());
    EXPECT_FALSE(learner.learning.act(Command::Hunt, 1.0)) << "another's command";
}

struct Hunter : test::PlainSession {
    Hunter() : PlainSession(hall()) {
        soundscape.enter(*world.scene);
        rooms.enter_world(as_read);
        rooms.tick(0.0);
        hunt.enter_world();
    }
    // Returns where the hidden clock ticks, or no value if the clock does not tick.
    std::optional<Vec3> clock_m() {
        std::vector<CueRequest> sounding;
        Soundscape ears = soundscape;
        for (int tick = 0; tick < 40; ++tick) ears.tick(*world.solids, avatar.ears_m(), 0.1 * tick, sounding);
        for (const CueRequest& cue : sounding)
            if (cue.sound == SoundKind::HiddenClock && cue.loudness > 0.0) return cue.position_m;
        return std::nullopt;
    }
    // Puts the walker at the clock. Returns what the session then announces.
    std::vector<std::string> find_at(double now_s) {
        const Vec3 clock = clock_m().value();
        stand(clock - Vec3(0.0, 0.0, 1.0));
        hunt.tick(now_s);
        return said();
    }
    Soundscape soundscape;
    Rooms rooms{context};
    ClockHunt hunt{context, rooms, soundscape};
};

TEST(ClockHuntFeature, hides_a_ticking_clock_gives_hints_and_notices_when_it_is_found) {
    Hunter hunter;
    EXPECT_FALSE(hunter.clock_m());
    EXPECT_TRUE(hunter.hunt.act(Command::Hunt, 1.0));
    EXPECT_THAT(hunter.said(), ElementsAre(HasSubstr("A clock is hidden")));
    ASSERT_TRUE(hunter.clock_m());
    EXPECT_GT(glm::length(*hunter.clock_m() - hunter.avatar.feet_m()), 5.0);
    hunter.hunt.tick(2.0);
    EXPECT_THAT(hunter.said(), IsEmpty()) << "it is far off";
    EXPECT_TRUE(hunter.hunt.act(Command::Hunt, 3.0));
    EXPECT_THAT(hunter.said(), ElementsAre(HasSubstr("The clock is ")));
    EXPECT_THAT(hunter.find_at(31.0),
                ElementsAre(AllOf(HasSubstr("30 seconds, with 1 hint"), HasSubstr("first result"))));
    EXPECT_FALSE(hunter.clock_m()) << "it ticks no more";
    hunter.hunt.tick(32.0);
    EXPECT_THAT(hunter.said(), IsEmpty());
    EXPECT_FALSE(hunter.hunt.act(Command::LearnPlace, 33.0)) << "another's command";
}

TEST(ClockHuntFeature, is_won_by_reaching_for_the_clock) {
    Hunter hunter;
    EXPECT_TRUE(hunter.hunt.act(Command::Hunt, 1.0));
    hunter.hands.right.present = true;
    hunter.hands.tool.ticks = 1;
    hunter.hands.tool.waiting_for_hand = false;
    hunter.hands.tool.proxy_m = hunter.clock_m().value();
    (void)hunter.said();
    hunter.hunt.tick(5.0);
    EXPECT_THAT(hunter.said(), ElementsAre(HasSubstr("You found the clock")));
}

TEST(ClockHuntFeature, stores_the_best_time_of_a_world_in_its_folder) {
    const test::TemporaryFolder folder;
    const auto play = [&](double took_s) {
        Hunter hunter;
        hunter.hunt.keep_records_in(folder.path());
        EXPECT_TRUE(hunter.hunt.act(Command::Hunt, 1.0));
        (void)hunter.said();
        return hunter.find_at(1.0 + took_s);
    };
    EXPECT_THAT(play(20.0), ElementsAre(HasSubstr("That is the first result recorded here")));
    EXPECT_THAT(play(25.0), ElementsAre(HasSubstr("The best time here is 20 seconds")));
    EXPECT_THAT(play(12.0), ElementsAre(HasSubstr("That is a new best time. The previous best was 20 seconds")));
}

TEST(ClockHuntFeature, begins_once_in_the_world_it_waits_for_and_ends_with_that_world) {
    Hunter hunter;
    hunter.hunt.begin_awaited(1.0);
    EXPECT_THAT(hunter.said(), IsEmpty()) << "none was asked for";
    hunter.hunt.await_world();
    hunter.hunt.enter_world();
    hunter.hunt.begin_awaited(2.0);
    EXPECT_THAT(hunter.said(), ElementsAre(HasSubstr("A clock is hidden")));
    hunter.hunt.enter_world();
    EXPECT_FALSE(hunter.clock_m()) << "left behind with its world";
    hunter.hunt.begin_awaited(3.0);
    EXPECT_THAT(hunter.said(), IsEmpty());
}

}  // namespace learning_features_test
}  // namespace handrail
