// Tests lessons without a session. The test itself provides the plain state that the lessons use.
#include "app/core/lessons/lesson_session.h"

#include <gmock/gmock.h>

#include <map>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/unit/features/plain_session.h"

namespace handrail {
namespace lesson_session_test {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

std::shared_ptr<const Scene> room() {
    test::SceneBuilder builder;
    builder.box({-10.0, -10.0, -0.5}, {10.0, 10.0, 0.0}, "floor");
    builder.box({-10.0, 9.0, 0.0}, {10.0, 10.0, 2.5}, "north wall", SolidRole::Solid, {}, FeatureKind::Wall);
    builder.start({0.0, 0.0, 0.0}, 0.0);
    return builder.share();
}

class LessonsAlone : public ::testing::Test {
protected:
    LessonsAlone() {
        plain.context.session_requests.perform = [this](Command command, double) { performed.push_back(command); };
        plain.context.session_requests.set = [this](std::string_view key, const std::string& value,
                                                    double) -> Result<void> {
            kept[std::string(key)] = value;
            return {};
        };
        lessons.beacon_calls = [this] { return beacon; };
        lessons.at_beacon = [this] { return there; };
        lessons.world_greeting = [] { return "A small room."; };
        lessons.on_begin_here = [this](double) { ++begun_here; };
        lessons.on_hunt = [this](double) { went_to = "hunt"; };
        lessons.on_worlds = [this](double) { went_to = "worlds"; };
        lessons.on_settings = [this](double) { went_to = "settings"; };
    }
    std::vector<std::string> tick(double seconds = 0.1) {
        plain.context.tick_s = now_s += seconds;
        lessons.tick(now_s);
        return plain.said();
    }
    void key(std::string_view name) { plain.lists.dialogue.key(name, now_s); }

    test::PlainSession plain{room()};
    LeaveRequested leave_requested;
    LessonSession lessons{plain.context, leave_requested};
    std::vector<Command> performed;
    std::map<std::string, std::string> kept;
    bool beacon = false, there = false;
    int begun_here = 0;
    std::string went_to;
    double now_s = 1.0;
};

TEST_F(LessonsAlone, run_the_first_minutes_from_welcome_through_setup) {
    lessons.begin_first_minutes("a voice", true, now_s);
    EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("with a voice")));
    EXPECT_TRUE(lessons.greeting_waits());
    EXPECT_THAT(tick(), IsEmpty()) << "nothing was done";
    EXPECT_TRUE(lessons.takes(Command::Use, now_s));
    EXPECT_FALSE(lessons.idle());
    EXPECT_EQ(tick().size(), 1U);
    EXPECT_TRUE(plain.requests.take_set_up());
    EXPECT_TRUE(plain.requests.take_first_set_up());
    EXPECT_FALSE(plain.requests.take_first_set_up()) << "once";
    EXPECT_THAT(kept, Contains(Pair("welcome.step", "1")));
    lessons.know_set_up_over();
    EXPECT_EQ(tick().size(), 1U);
    EXPECT_FALSE(lessons.greeting_waits());
    EXPECT_EQ(begun_here, 0) << "there is no hand to begin with";
}

TEST_F(LessonsAlone, end_when_leave_is_repeated_within_five_seconds) {
    lessons.begin_first_minutes("a voice", false, now_s);
    lessons.takes(Command::Use, now_s);
    tick();
    plain.said();
    EXPECT_TRUE(lessons.takes(Command::Leave, 10.0));
    EXPECT_TRUE(lessons.takes(Command::Leave, 16.0));
    EXPECT_EQ(plain.said().size(), 2U) << "asked again";
    EXPECT_THAT(kept, ::testing::Not(Contains(Pair("welcome.done", "true"))));
    EXPECT_TRUE(lessons.takes(Command::Leave, 18.0));
    EXPECT_THAT(kept, Contains(Pair("welcome.done", "true")));
    EXPECT_FALSE(lessons.takes(Command::Leave, 19.0)) << "there is no lesson any more";
    EXPECT_FALSE(leave_requested.lately(19.0)) << "leaving the program is another matter";

    leave_requested.at_s = 20.0;
    lessons.act(Command::FirstMinutes, 21.0);
    lessons.takes(Command::Use, 21.0);
    tick();
    plain.said();
    EXPECT_TRUE(lessons.takes(Command::Leave, 22.0));
    EXPECT_FALSE(lessons.takes(Command::Leave, 23.0)) << "who was asked a moment before is not asked again";
}

TEST_F(LessonsAlone, give_way_to_any_other_command_and_let_the_world_greet) {
    lessons.begin_first_minutes("a voice", true, now_s);
    plain.said();
    EXPECT_FALSE(lessons.takes(Command::StopSpeech, now_s));
    EXPECT_TRUE(lessons.greeting_waits());
    EXPECT_FALSE(lessons.takes(Command::Forward, now_s)) << "it is done as ever";
    EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("A small room.")));
    EXPECT_FALSE(lessons.greeting_waits());
}

TEST_F(LessonsAlone, accept_typed_lines_only_while_they_wait_for_a_key) {
    EXPECT_FALSE(lessons.take_line("enter", now_s));
    lessons.begin_first_minutes("a voice", true, now_s);
    EXPECT_FALSE(lessons.take_line("forward", now_s));
    EXPECT_TRUE(lessons.take_line("", now_s));
    EXPECT_TRUE(lessons.take_line("Space", now_s));
    EXPECT_THAT(performed, ElementsAre(Command::Use, Command::Repeat));
}

TEST_F(LessonsAlone, follow_the_reported_state_of_the_beacon) {
    EXPECT_FALSE(lessons.act(Command::Menu, now_s)) << "another's command";
    EXPECT_TRUE(lessons.act(Command::Lessons, now_s));
    for (const char* one : {"End", "Up", "Enter"}) key(one);
    plain.said();
    there = true;
    EXPECT_THAT(tick(), IsEmpty()) << "the beacon was never on";
    beacon = true;
    EXPECT_THAT(tick(), IsEmpty()) << "what the hand met is named first";
    EXPECT_EQ(tick(2.0).size(), 2U) << "praise, and what to do next";
    EXPECT_THAT(tick(), IsEmpty()) << "it still calls";
    beacon = false;
    tick();
    EXPECT_THAT(tick(2.0), Contains(HasSubstr("That is the end of the lesson.")));
    EXPECT_TRUE(lessons.idle());
}

TEST_F(LessonsAlone, detect_a_wall_met_by_the_body_and_continue_with_the_chosen_item) {
    lessons.act(Command::Lessons, now_s);
    for (const char* one : {"Home", "Enter"}) key(one);
    plain.said();
    lessons.note_bump(FeatureId{1});
    tick();
    EXPECT_THAT(tick(2.0), ::testing::Not(IsEmpty()));

    // Resumes the first minutes at the last step that was saved, so that they end soon.
    plain.person.settings.welcome.step = static_cast<int>(first_minutes().steps.size()) - 1;
    lessons.begin_first_minutes("a voice", false, now_s);
    plain.said();
    EXPECT_FALSE(lessons.takes(Command::Home, now_s));
    lessons.note(Command::Home);
    tick();
    tick(2.0);
    ASSERT_TRUE(plain.lists.dialogue.is_open()) << "what next";
    for (const char* one : {"End", "Up", "Enter"}) key(one);
    EXPECT_EQ(went_to, "worlds");
    EXPECT_THAT(kept, AllOf(Contains(Pair("welcome.done", "true")), Contains(Pair("welcome.step", "0"))));
}

}  // namespace lesson_session_test
}  // namespace handrail
