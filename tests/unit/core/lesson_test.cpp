#include "app/core/lessons/lesson.h"

#include "app/core/session/session.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "worlds/base/language.h"

namespace handrail {
namespace lesson_test {

using testing::HasSubstr;

struct World {
    World() {
        test::SceneBuilder b;
        b.box({0, 0, -0.2}, {6, 4, 0}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
        north = b.box({0, 4, 0}, {6, 4.2, 2.6}, "north wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
        east = b.box({6, 0, 0}, {6.2, 4, 2.6}, "east wall", SolidRole::Solid, "wood", FeatureKind::Wall);
        table = b.box({1, 1, 0}, {2, 2, 0.7}, "Table", SolidRole::Solid, "wood", FeatureKind::Object);
        door = b.box({2, -0.2, 0}, {3, 0, 2}, "Door", SolidRole::Solid, "wood", FeatureKind::Door);
        radiator = b.box({4, 3.8, 0}, {5, 4, 0.7}, "Radiator", SolidRole::Solid, "metal", FeatureKind::Object);
        b.start({3, 0.5, 0}, 0.0);
        scene = b.share();
    }
    FeatureId north, east, table, door, radiator;
    std::shared_ptr<const Scene> scene;
};

LessonSense met(FeatureId id) {
    LessonSense sense;
    sense.met = {id};
    return sense;
}
LessonSense did(Command command, bool at_home = false) {
    LessonSense sense;
    sense.did = {command};
    sense.at_home = at_home;
    return sense;
}

TEST(Lessons, end_only_when_the_person_has_done_each_thing) {
    const World w;
    LessonRun corner(lessons()[1], true, "");
    EXPECT_THAT(corner.begin().instruction, HasSubstr("reach forward"));
    EXPECT_FALSE(corner.tick(LessonSense{}, *w.scene).done);
    EXPECT_FALSE(corner.tick(met(w.table), *w.scene).done) << "a table is no wall";
    EXPECT_TRUE(corner.tick(met(w.north), *w.scene).done);
    EXPECT_FALSE(corner.tick(met(w.north), *w.scene).done) << "the same wall is no corner";
    const LessonReply last = corner.tick(met(w.east), *w.scene);
    EXPECT_TRUE(last.done && last.finished && last.at_once);
    EXPECT_EQ(last.praise, "Corner.");

    LessonRun where(lessons()[3], false, "");
    where.begin();
    EXPECT_FALSE(where.tick(did(Command::Heading), *w.scene).done);
    EXPECT_TRUE(where.tick(did(Command::WhereAmI), *w.scene).done);
    EXPECT_FALSE(where.tick(did(Command::Home, false), *w.scene).done);
    EXPECT_TRUE(where.tick(did(Command::Home, true), *w.scene).finished);

    LessonRun door(lessons()[2], false, "");
    door.begin();
    EXPECT_FALSE(door.tick(met(w.door), *w.scene).done) << "asked first";
    EXPECT_TRUE(door.tick(did(Command::AroundMe), *w.scene).done);
    EXPECT_TRUE(door.tick(met(w.door), *w.scene).finished);
}

TEST(Lessons, about_forces_need_a_device_and_observe_the_actual_force) {
    const World w;
    LessonRun keys(lessons()[4], false, "");
    EXPECT_EQ(keys.begin().instruction, "This lesson needs a touch device.");
    LessonRun hand(lessons()[4], true, "");
    hand.begin();
    LessonSense on, off;
    off.forces_on = false;
    EXPECT_FALSE(hand.tick(on, *w.scene).done);
    EXPECT_TRUE(hand.tick(off, *w.scene).done);
    EXPECT_FALSE(hand.tick(off, *w.scene).done);
    EXPECT_TRUE(hand.tick(on, *w.scene).finished);
}

TEST(Lessons, about_the_beacon_end_once_it_was_set_and_reached_and_not_when_it_is_just_removed) {
    const World w;
    LessonRun lesson(lessons()[5], false, "");
    EXPECT_THAT(lesson.begin().instruction, HasSubstr("Shift+H"));
    LessonSense calls, reached;
    calls.beacon = true;
    reached.at_beacon = true;
    EXPECT_FALSE(lesson.tick(LessonSense{}, *w.scene).done);
    EXPECT_THAT(lesson.tick(calls, *w.scene).instruction, HasSubstr("rings clear"));
    EXPECT_FALSE(lesson.tick(calls, *w.scene).done);
    EXPECT_FALSE(lesson.tick(LessonSense{}, *w.scene).done) << "taken off on the way";
    EXPECT_TRUE(lesson.tick(reached, *w.scene).finished);
}

// In a session, the person chooses the thing from the list, the walker goes there, and the beacon ends.
TEST(Lessons, about_the_beacon_lead_the_walker_to_the_chosen_thing) {
    const World w;
    Session app(Settings{}, HandFacts{});
    double now = 0.0;
    std::string text;
    const auto run = [&](double seconds) {
        for (const double until = now + seconds; now < until;) {
            app.tick(now += 0.05, ToolState{});
            for (const CueRequest& cue : app.take_cues())
                if (cue.kind == CueRequestKind::Say) text += cue.text + " ";
        }
    };
    const auto press = [&](Command command) {
        app.apply(CommandDown{command}, now);
        app.apply(CommandUp{command}, now);
        run(0.1);
    };
    app.apply(WorldEntered{make_ready(w.scene)}, now);
    press(Command::Lessons);
    for (const char* key : {"End", "Up", "Enter"}) app.apply(KeyTapped{key}, now);
    run(0.2);
    EXPECT_THAT(text, HasSubstr("Press Shift+H"));
    press(Command::Find);
    const auto at = [&] { return app.dialogue().view().items.at(app.dialogue().view().at).name; };
    for (int i = 0; i < 9 && at() != "Radiator"; ++i) app.apply(KeyTapped{"Down"}, now);
    ASSERT_EQ(at(), "Radiator");
    app.apply(KeyTapped{"Enter"}, now);
    app.apply(KeyTapped{"Enter"}, now);
    run(2.0);
    EXPECT_THAT(text, HasSubstr("Beacon on Radiator"));
    EXPECT_THAT(text, HasSubstr("rings clear"));
    press(Command::TurnRight);
    run(0.5);
    app.apply(CommandDown{Command::Forward}, now);
    run(6.0);
    app.apply(CommandUp{Command::Forward}, now);
    run(3.0);
    EXPECT_THAT(text, HasSubstr("Here: Radiator"));
    EXPECT_THAT(text, HasSubstr("That is the end of the lesson."));
}

TEST(Lessons, are_short_enough_for_two_minutes) {
    for (const Lesson& lesson : lessons()) {
        std::size_t words = 0;
        for (const LessonStep& step : lesson.steps)
            for (const std::string& text : {phrase(step.hand.empty() ? step.body : step.hand), phrase(step.praise)})
                words += static_cast<std::size_t>(std::count(text.begin(), text.end(), ' ')) + 1;
        EXPECT_LT(words, 150U) << lesson.name << ": at 175 words a minute less than half of two minutes is listening";
    }
}

// In a session, the first minutes continue at the step where the person left them.
TEST(FirstMinutes, resume_where_they_were_left_and_never_start_again_once_done) {
    const World w;
    Session app(Settings{}, HandFacts{});
    std::map<std::string, std::string> saved;
    double now = 0.0;
    const auto said = [&] {
        std::string text;
        for (const CueRequest& cue : app.take_cues())
            if (cue.kind == CueRequestKind::Say) text += cue.text + " ";
        for (const auto& [key, value] : app.take_setting_changes()) saved[key] = value;
        return text;
    };
    const auto run = [&](double seconds) {
        std::string text;
        for (const double until = now + seconds; now < until;) {
            app.tick(now += 0.1, ToolState{});
            text += said();
        }
        return text;
    };
    app.apply(FirstMinutesBegun{"a voice", true}, now);
    EXPECT_THAT(said(), HasSubstr("Handrail is speaking with a voice"));
    app.apply(WorldEntered{make_ready(w.scene)}, now);
    EXPECT_TRUE(app.greeting_waits());
    EXPECT_EQ(said(), "") << "the world's own greeting waits";
    app.apply(CommandDown{Command::Use}, now += 0.1);
    app.apply(CommandUp{Command::Use}, now);
    EXPECT_THAT(run(1.0), HasSubstr("your headphones"));
    EXPECT_TRUE(app.requests().take_first_set_up());
    EXPECT_TRUE(app.requests().take_set_up());
    EXPECT_FALSE(app.requests().take_set_up());
    app.apply(SetUpOver{}, now);
    EXPECT_THAT(run(1.0), HasSubstr("You are in a small room"));
    EXPECT_EQ(saved["welcome.step"], "3");

    Settings next;
    next.welcome.step = 3;
    Session later(next, HandFacts{});
    later.apply(FirstMinutesBegun{"a voice", true}, 0.0);
    later.apply(WorldEntered{make_ready(w.scene)}, 0.0);
    std::string text;
    for (const CueRequest& cue : later.take_cues())
        if (cue.kind == CueRequestKind::Say) text += cue.text + " ";
    EXPECT_THAT(text, HasSubstr("Welcome back."));
    EXPECT_THAT(text, HasSubstr("You are in a small room"));

    // The first Escape explains how to leave the lesson. The second Escape ends the lesson without another question.
    app.apply(CommandDown{Command::Leave}, now += 10.0);
    EXPECT_THAT(said(), HasSubstr("Press Escape again to leave the lesson"));
    app.apply(CommandUp{Command::Leave}, now);
    app.apply(CommandDown{Command::Leave}, now += 1.0);
    EXPECT_THAT(said(), HasSubstr("You have left the introduction"));
    EXPECT_EQ(saved["welcome.done"], "true");
    EXPECT_FALSE(app.requests().leave);
}

TEST(FirstMinutes, are_skipped_by_any_other_command_and_the_world_then_greets) {
    const World w;
    Session app(Settings{}, HandFacts{});
    app.apply(FirstMinutesBegun{"a voice", true}, 0.0);
    app.apply(WorldEntered{make_ready(w.scene)}, 0.0);
    app.take_cues();
    app.apply(CommandDown{Command::Forward}, 0.5);
    app.apply(CommandUp{Command::Forward}, 0.5);
    std::string text;
    for (const CueRequest& cue : app.take_cues())
        if (cue.kind == CueRequestKind::Say) text += cue.text + " ";
    EXPECT_THAT(text, HasSubstr("facing north"));
    EXPECT_FALSE(app.idle()) << "and what was wanted is done";
}

}  // namespace lesson_test
}  // namespace handrail
