// Tests lesson files. The reader must read all their contents, and report each mistake in one sentence with its line.
#include "app/teaching/lesson_file.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/files.h"

namespace handrail {
namespace lesson_file_test {

const std::filesystem::path kSeed = test::project_root() / "tests/fuzz/inputs/lesson/seeds/everything.lesson.toml";

// The sample lesson, in a folder with its world.
class Given {
public:
    Given() { folder_.write("box.map", "{\n\"classname\" \"worldspawn\"\n}\n"); }
    Result<LessonFile> read(const std::string& text) const {
        return read_lesson_text(text, folder_.path() / "a.lesson.toml", {});
    }
    std::string seed() const { return *read_whole_file(kSeed, 1 << 20); }
    // Replaces a text in the sample lesson. Returns the message of the reader.
    std::string refused(const std::string& what, const std::string& by) const {
        std::string text = seed();
        const std::size_t at = text.find(what);
        if (at == std::string::npos) return "the seed has no " + what;
        text.replace(at, what.size(), by);
        const auto read_back = read(text);
        return read_back ? std::string("taken") : read_back.error().sentence();
    }

private:
    test::TemporaryFolder folder_;
};

TEST(LessonFileRead, contains_everything_in_the_file) {
    const Given given;
    const auto lesson = given.read(given.seed());
    ASSERT_TRUE(lesson) << lesson.error().sentence();
    EXPECT_EQ(lesson->title.text, "From the front door to the utility room");
    ASSERT_EQ(lesson->title.others.size(), 1U);
    EXPECT_EQ(lesson->title.others[0].language, "de");
    EXPECT_EQ(*lesson->base_feet_m, Vec3(2.0, -0.4, 0.0));
    EXPECT_DOUBLE_EQ(lesson->base_heading_rad, radians_from_degrees(15.0));
    ASSERT_EQ(lesson->landmarks.size(), 2U);
    EXPECT_EQ(lesson->landmarks[0].thing, "Grandfather clock");
    EXPECT_EQ(lesson->landmarks[1].name, "Turn \"to\" the utility room");
    ASSERT_EQ(lesson->routes.size(), 1U);
    EXPECT_EQ(lesson->routes[0].stops.size(), 3U);
    ASSERT_EQ(lesson->sessions.size(), 2U);
    const TaughtSession& second = lesson->sessions[1];
    EXPECT_TRUE(second.shuffle);
    EXPECT_EQ(second.settings.at("walk.callouts"), "true");
    ASSERT_EQ(second.steps.size(), 5U);
    EXPECT_EQ(second.steps[0].kind, StepKind::Go);
    EXPECT_EQ(second.steps[0].help_percent, (std::vector{100, 60, 30, 0}));
    EXPECT_EQ(second.steps[0].block, (std::vector<std::string>{"Utility room door"}));
    EXPECT_TRUE(second.steps[2].along_way);
    EXPECT_EQ((*second.steps[4].scale)[1], 7);
    ASSERT_EQ(lesson->pupils.size(), 1U);
    EXPECT_EQ(lesson->pupils[0].actions.size(), 1U);
    EXPECT_EQ(lesson->pupils[0].expectations.size(), 1U);
    EXPECT_EQ(lesson->pupils[0].measured.size(), 2U);
}

TEST(LessonFileRead, reads_its_own_text_back_unchanged) {
    const Given given;
    auto lesson = given.read(given.seed());
    ASSERT_TRUE(lesson);
    lesson->pupils.clear();
    const std::string text = lesson_text(*lesson);
    const auto again = given.read(text);
    ASSERT_TRUE(again) << again.error().sentence() << text;
    EXPECT_EQ(lesson_text(*again), text);
    EXPECT_EQ(again->landmarks[1].name, lesson->landmarks[1].name);
    EXPECT_EQ(again->sessions[1].steps[0].block, lesson->sessions[1].steps[0].block);
}

TEST(LessonFileRead, reports_each_mistake_with_its_line_and_the_probable_meaning) {
    const Given given;
    const auto reports = [&](const std::string& what, const std::string& by, const std::string& line,
                             const std::string& words) {
        const std::string sentence = given.refused(what, by);
        EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
        EXPECT_NE(sentence.find(line), std::string::npos) << sentence;
    };
    reports("minutes = 15", "minuts = 15", "line 23", "minutes");
    reports("do = \"learn\"", "do = \"lern\"", "line 25", "learn");
    reports("route = \"to the utility room\"", "route = \"to the utilty room\"", "line 43", "to the utility room");
    reports("help_percent = [100, 60, 30, 0]", "help_percent = [100, 160]", "line 45", "0 to 100");
    reports("world = \"box.map\"", "world = \"bax.map\"", "line 4", "bax.map");
    reports("\"workspace.scale\" = 60", "\"haptic.max_force_n\" = 60", "line 9", "may not set");
    reports("place_m = [2.1, 6.2, 0.0]\n\n", "place_m = [2.1, inf, 0.0]\n\n", "line 15", "finite");
    reports("session = \"Walls\"", "session = \"Wals\"", "line 65", "Walls");
    reports("strategy = \"perimeter\"", "strategy = \"perimetre\"", "line 70", "perimeter");
    reports("scale = [1, 7]", "scale = [7, 7]", "line 61", "different");
    reports("handrail_lesson = 1", "handrail_lesson = 2", "line 1", "must be 1");
    reports("thing = \"Grandfather clock\"", "thing = \"Turn \\\"to\\\" the utility room\"", "line 13", "twice");
}

TEST(LessonFileRead, refuses_more_than_a_lesson_can_hold) {
    const Given given;
    std::string text = *read_whole_file(kSeed.parent_path() / "short.lesson.toml", 1 << 20);
    for (int i = 0; i < 25; ++i)
        text += "[[session]]\nname = \"S" + std::to_string(i) + "\"\n[[session.step]]\ndo = \"free\"\n";
    const auto many = given.read(text);
    ASSERT_FALSE(many);
    EXPECT_NE(many.error().sentence().find("at most 20"), std::string::npos) << many.error().sentence();
}

TEST(LessonFileRead, is_complete_or_refused_in_one_sentence_if_cut_anywhere) {
    const Given given;
    const std::string text = given.seed();
    std::size_t taken = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const auto lesson = given.read(text.substr(0, at));
        if (lesson) ++taken;
        else EXPECT_NE(lesson.error().sentence().find("a.lesson.toml"), std::string::npos) << at;
    }
    EXPECT_GT(taken, 0U);  // the part before a cut between two sessions is a valid lesson
    EXPECT_LT(taken, text.size() / 2);
}

TEST(LessonFileRead, finds_its_world_by_name_or_next_to_it_after_both_were_moved) {
    const Given given;
    for (const char* world : {"box", "../elsewhere/box.map", "box.map"}) {
        std::string text = given.seed();
        const std::string written = "world = \"box.map\"";
        text.replace(text.find(written), written.size(), "world = \"" + std::string(world) + "\"");
        const auto lesson = given.read(text);
        ASSERT_TRUE(lesson) << world << ": " << lesson.error().sentence();
        EXPECT_EQ(lesson->world.filename(), "box.map") << world;
    }
    EXPECT_NE(given.refused("world = \"box.map\"", "world = \"bax\"").find("bax"), std::string::npos);
}

// A lesson that the program saves must refer to its world relative to its own folder, so that a user can move both
// together.
TEST(LessonFileRead, created_by_the_program_names_its_world_relative_to_its_own_folder) {
    const test::TemporaryFolder home;
    const auto lessons = home.path() / "data/lessons", worlds = home.path() / "worlds";
    std::filesystem::create_directories(lessons);
    std::filesystem::create_directories(worlds);
    home.write("worlds/flat.map", "{\n\"classname\" \"worldspawn\"\n}\n");
    const std::string named = named_from(lessons, worlds / "flat.map");
    EXPECT_EQ(named, "../../worlds/flat.map");
    EXPECT_EQ(named_from(worlds, worlds / "flat.map"), "flat.map");
    const Given given;
    std::string text = given.seed();
    const std::string written = "world = \"box.map\"";
    text.replace(text.find(written), written.size(), "world = \"" + named + "\"");
    const std::filesystem::path moved = home.path() / "elsewhere";
    std::filesystem::create_directories(moved);
    for (const char* folder : {"data", "worlds"}) std::filesystem::rename(home.path() / folder, moved / folder);
    const auto lesson = read_lesson_text(text, moved / "data/lessons/a.lesson.toml", {});
    ASSERT_TRUE(lesson) << lesson.error().sentence();
    EXPECT_TRUE(std::filesystem::equivalent(lesson->world, moved / "worlds/flat.map"));
}

TEST(LessonFileRead, leaves_the_last_lap_without_help) {
    const Given given;
    std::string text = given.seed();
    const std::size_t at = text.find("help_percent = [100, 60, 30, 0]");
    text.replace(at, 31, "help_percent = [100, 60]");
    const auto lesson = given.read(text);
    ASSERT_TRUE(lesson) << lesson.error().sentence();
    EXPECT_EQ(lesson->sessions[1].steps[0].help_percent, (std::vector{100, 60, 60, 0}));
}

TEST(StepOrder, is_the_same_each_time_for_one_learner_but_differs_between_learners) {
    TaughtSession session;
    session.steps.resize(6);
    EXPECT_EQ(step_order(session, 0, 3), (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
    session.shuffle = true;
    std::set<std::vector<std::size_t>> orders;
    for (std::uint64_t learner = 0; learner < 20; ++learner) {
        const auto order = step_order(session, 0, learner);
        EXPECT_EQ(order, step_order(session, 0, learner));
        EXPECT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), 6U);
        orders.insert(order);
    }
    EXPECT_GT(orders.size(), 10U);
}

}  // namespace lesson_file_test
}  // namespace handrail
