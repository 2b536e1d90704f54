// Tests a lesson that the program teaches to a named learner, by text alone and with the desk. The program records the
// lesson if the learner has agreed. The test replays the recording, reports on it and deletes the learner's data.
#include <gmock/gmock.h>

#include <filesystem>

#include "app/report/report_page.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace lesson_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class TaughtByTheProgram : public testing::Test {
protected:
    void SetUp() override {
        for (const char* name : {"data", "state", "run"}) fs::create_directories(home_.path() / name);
        fs::permissions(home_.path() / "run", fs::perms::owner_all);
    }
    std::map<std::string, std::string> environment() const {
        auto all = bare_environment(home_.path().string());
        all["XDG_DATA_HOME"] = (home_.path() / "data").string();
        all["XDG_STATE_HOME"] = (home_.path() / "state").string();
        all["XDG_RUNTIME_DIR"] = (home_.path() / "run").string();
        return all;
    }
    ProgramRun run(std::vector<std::string> words, const std::string& input = {}) const {
        ProgramCall call;
        call.program = test::built_program("handrail");
        call.arguments = std::move(words);
        call.input = input;
        call.environment = environment();
        return run_program(call);
    }
    // Simulates a learner at a terminal, who waits for announced words before typing the next line.
    class Pupil {
    public:
        Pupil(const TaughtByTheProgram& test, const char* name, std::vector<std::string> words)
            : output_(test.home_.path() / name) {
            words.insert(words.begin(), test::built_program("handrail"));
            child_ = ChildProcess::start(words, test.environment(), output_);
        }
        bool hears(const std::string& words) {
            return eventually([&] { return content_of(output_).find(words, heard_) != std::string::npos; }) &&
                   (heard_ = content_of(output_).find(words, heard_) + words.size(), true);
        }
        void type(const std::string& line) { child_->type(line + "\n"); }
        int leave() {
            child_->end_input();
            return child_->exit_status();
        }
        int ends() { return child_->exit_status(); }
        std::string all() const { return content_of(output_); }

    private:
        fs::path output_;
        std::unique_ptr<ChildProcess> child_;
        std::size_t heard_ = 0;
    };
    std::vector<std::string> taught(const char* session) const {
        return {"lesson",      test::bundled_world("school.lesson.toml"),
                "--session",   session,
                "--learner",   "oak owl",
                "--no-window", "--device",
                "none"};
    }
    std::vector<std::string> recordings() const {
        std::vector<std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(home_.path() / "data"))
            if (entry.path().filename() == "events.jsonl") found.push_back(entry.path().parent_path().string());
        std::sort(found.begin(), found.end());
        return found;
    }
    TemporaryFolder home_;
};

TEST_F(TaughtByTheProgram, keeps_marks_and_recordings_of_its_learner_and_can_be_watched_replayed_and_reported_on) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "takes minutes under a sanitizer, where one lesson is enough";
    EXPECT_EQ(run({"learner", "new", "Oak Owl", "--give", "record,share"}).exit_status, 0);
    Pupil first(*this, "first", taught("1"));
    ASSERT_TRUE(first.hears("Oak Owl is learning.")) << first.all();
    ASSERT_TRUE(first.hears("Walls, 2 tasks.")) << first.all();
    Pupil desk(*this, "desk", {"lesson", "watch"});
    ASSERT_TRUE(desk.hears("Watching the lesson.")) << desk.all();
    desk.type("note holds the rail");
    ASSERT_TRUE(desk.hears("Noted.")) << desk.all();
    desk.type("repeat");
    ASSERT_TRUE(first.hears("Get to know Entrance hall")) << first.all();
    first.type("mark");
    first.type("door");
    desk.type("summary");  // request a line, because otherwise the desk prints one only every ten seconds
    ASSERT_TRUE(desk.hears("walls done")) << desk.all();
    first.type("done");
    ASSERT_TRUE(first.hears("Face Trophy case")) << first.all();
    first.type("done");
    ASSERT_TRUE(first.hears("Face Drinking fountain")) << first.all();
    first.type("done");
    ASSERT_TRUE(first.hears("Walls is over. Well done. Next time: Route with help.")) << first.all();
    EXPECT_EQ(first.leave(), 0);
    EXPECT_EQ(desk.ends(), 0) << "it ends with the session";

    Pupil last(*this, "last", taught("3"));
    ASSERT_TRUE(last.hears("4 tasks.")) << last.all();
    ASSERT_TRUE(last.hears("Go to Library")) << last.all();
    last.type("marks");
    ASSERT_TRUE(last.hears("1 of 3")) << "the learner's own mark: " << last.all();
    last.type("escape");
    last.type("done");
    ASSERT_TRUE(last.hears("How far is it to Drinking fountain")) << last.all();
    last.type("20");
    ASSERT_TRUE(last.hears("Put 3 places in order")) << last.all();
    last.type("1");
    ASSERT_TRUE(last.hears("comes after")) << last.all();
    last.type("1");
    ASSERT_TRUE(last.hears("How sure were you of the route?")) << last.all();
    last.type("6");
    ASSERT_TRUE(last.hears("Free, with a blocked door is over.")) << last.all();
    EXPECT_EQ(last.leave(), 0);

    const std::vector<std::string> folders = recordings();
    ASSERT_EQ(folders.size(), 2U);
    EXPECT_THAT(content_of(fs::path(folders[0]) / "events.jsonl"), HasSubstr("holds the rail"));
    for (const std::string& folder : folders) {
        const ProgramRun again = run({"replay", folder, "--check"});
        EXPECT_EQ(again.exit_status, 0) << again.out << again.err;
    }
    const std::string page = (home_.path() / "page.html").string(), table = (home_.path() / "results.csv").string(),
                      json = (home_.path() / "results.json").string();
    const ProgramRun report = run({"report", "--learner", "Oak Owl", "--html", page, "--csv", table, "--json", json});
    EXPECT_EQ(report.exit_status, 0) << report.err;
    EXPECT_THAT(content_of(page), HasSubstr("You did not reach Library this time."));
    EXPECT_THAT(content_of(page), Not(HasSubstr("You made all the turns."))) << "of a way that was given up";
    EXPECT_THAT(content_of(page), HasSubstr("You got to know Entrance hall."));
    EXPECT_THAT(content_of(table), HasSubstr("From the main door to the library"));
    const auto rows = read_results_csv(content_of(table), table), same = read_results_json(content_of(json), json);
    ASSERT_TRUE(rows && same);
    EXPECT_EQ(*rows, *same);
    std::string measured;
    for (const ResultRow& row : *rows) measured += row.session + " " + row.measure + "\n";
    for (const char* one : {"1 walls_percent", "1 pointing_off", "2 distance_judged", "2 order_kept"})
        EXPECT_THAT(measured, HasSubstr(one));

    const ProgramRun deleted = run({"learner", "delete", "Oak Owl", "--yes"});
    EXPECT_EQ(deleted.exit_status, 0) << deleted.out << deleted.err;
    EXPECT_THAT(deleted.out, HasSubstr("no traces found"));
    EXPECT_FALSE(fs::exists(page) || fs::exists(table) || fs::exists(json));
}

TEST_F(TaughtByTheProgram, resumes_with_the_next_session_and_stores_results_only_with_consent) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "takes minutes under a sanitizer, where one lesson is enough";
    EXPECT_EQ(run({"learner", "new", "Oak Owl", "--give", "remember,share"}).exit_status, 0);
    const std::vector<std::string> words = {
        "lesson", test::bundled_world("school.lesson.toml"), "--learner", "oak owl", "--no-window", "--device", "none"};
    Pupil first(*this, "first", words);
    ASSERT_TRUE(first.hears("Session 1 of 3 is next.")) << first.all();
    ASSERT_TRUE(first.hears("Get to know Entrance hall")) << first.all();
    for (const char* requested : {"Face Trophy case", "Face Drinking fountain", "Walls is over."}) {
        first.type("done");
        ASSERT_TRUE(first.hears(requested)) << first.all();
    }
    // The list of lessons must show the started session immediately.
    first.type("task");
    ASSERT_TRUE(first.hears("Begin From the main door to the library, session 2 of 3")) << first.all();
    first.type("1");
    ASSERT_TRUE(first.hears("Route with help, 1 task.")) << first.all();
    // The learner leaves in the middle of the session, so the next lesson begins with the same session.
    EXPECT_EQ(first.leave(), 0);
    EXPECT_TRUE(recordings().empty());

    // A report must show the measures, also those of the session that the learner left. The program must not store any
    // announced text.
    const std::string table = (home_.path() / "results.csv").string(), page = (home_.path() / "page.html").string();
    const ProgramRun report = run({"report", "--learner", "Oak Owl", "--csv", table, "--html", page});
    EXPECT_EQ(report.exit_status, 0) << report.err;
    const auto rows = read_results_csv(content_of(table), table);
    ASSERT_TRUE(rows);
    std::string measured;
    for (const ResultRow& row : *rows) measured += row.session + " " + row.task + " " + row.measure + "\n";
    for (const char* one : {"1 1 learn Entrance hall time", "1 2 point pointing_off", "pointing_passed"})
        EXPECT_THAT(measured, HasSubstr(one));
    EXPECT_THAT(measured, Not(HasSubstr("strategy"))) << "where one went is not kept";
    EXPECT_THAT(content_of(page), Not(HasSubstr("Face Trophy case")));

    Pupil second(*this, "second", words);
    ASSERT_TRUE(second.hears("Session 2 of 3 is next.")) << second.all();
    ASSERT_TRUE(second.hears("Lap 1 of 4.")) << second.all();
    second.type("learners");
    ASSERT_TRUE(second.hears("Oak Owl is here.")) << second.all();
    second.type("2");
    ASSERT_TRUE(second.hears("From the main door to the library: session 2 of 3 is next.")) << second.all();
    EXPECT_EQ(second.leave(), 0);

    // The learner has withdrawn consent to be remembered. So the course must begin again, and the stored data must be
    // deleted.
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--withdraw", "remember"}).exit_status, 0);
    Pupil third(*this, "third", words);
    ASSERT_TRUE(third.hears("Walls, 2 tasks.")) << third.all();
    EXPECT_EQ(third.leave(), 0);
    EXPECT_THAT(third.all(), Not(HasSubstr("is next.")));
    EXPECT_EQ(run({"report", "--learner", "Oak Owl", "--csv", table, "--force"}).exit_status, 1);
    for (const auto& entry : fs::recursive_directory_iterator(home_.path() / "data"))
        for (const char* gone : {"lessons.toml", "results.jsonl"}) EXPECT_NE(entry.path().filename(), gone);
}

TEST_F(TaughtByTheProgram, has_a_step_order_that_depends_on_the_learner_whether_the_lesson_is_named_or_chosen) {
    EXPECT_EQ(run({"learner", "new", "Oak Owl"}).exit_status, 0);
    fs::create_directories(home_.path() / "data/handrail/lessons");
    std::string text =
        "handrail_lesson = 1\ntitle = \"Questions\"\nworld = \"first_room.map\"\n[[landmark]]\nname = \"Here\"\n"
        "place_m = [0.0, 0.0, 0.0]\n[[session]]\nname = \"All\"\norder = \"shuffle\"\n";
    const std::vector<std::string> names = {"Ash", "Birch", "Cedar", "Dogwood", "Elm", "Fir"};
    for (const std::string& name : names)
        text += "[[session.step]]\ndo = \"ask\"\nsay = \"What is " + name + "?\"\nscale = [1, 7]\n";
    const std::string file = (home_.path() / "data/handrail/lessons/questions.lesson.toml").string();
    std::filesystem::copy_file(home_.write("questions.lesson.toml", text), file);
    const std::string protocol = run({"lesson", file, "--protocol", "--learner", "Oak Owl"}).out;
    std::vector<std::string> order = names;
    std::sort(order.begin(), order.end(), [&](const std::string& a, const std::string& b) {
        return protocol.find("What is " + a) < protocol.find("What is " + b);
    });
    EXPECT_NE(order, names) << protocol;
    Pupil pupil(*this, "pupil",
                {test::bundled_world("first_room.map"), "--learner", "oak owl", "--no-window", "--device", "none"});
    ASSERT_TRUE(pupil.hears("Oak Owl is learning.")) << pupil.all();
    ASSERT_TRUE(pupil.hears("First room")) << pupil.all();
    pupil.type("task");
    ASSERT_TRUE(pupil.hears("Begin Questions")) << pupil.all();
    pupil.type("1");
    for (const std::string& name : order) {
        ASSERT_TRUE(pupil.hears("What is ")) << pupil.all();
        ASSERT_TRUE(pupil.hears(name + "?")) << name << protocol << pupil.all();
        pupil.type("4");
    }
    ASSERT_TRUE(pupil.hears("All is over.")) << pupil.all();
    EXPECT_EQ(pupil.leave(), 0);
}

// The lesson's scale must apply from the beginning of the lesson to its end, whether the command line or the list
// started the lesson.
TEST_F(TaughtByTheProgram, applies_the_lesson_settings_until_it_ends_whether_it_is_named_or_chosen) {
    fs::create_directories(home_.path() / "data/handrail/lessons");
    const std::string file = (home_.path() / "data/handrail/lessons/scale.lesson.toml").string();
    fs::copy_file(home_.write("scale.lesson.toml",
                              "handrail_lesson = 1\ntitle = \"Scale\"\nworld = \"first_room.map\"\n[settings]\n"
                              "\"workspace.scale\" = \"8\"\n[[landmark]]\nname = \"Here\"\nplace_m = [0.0, 0.0, 0.0]\n"
                              "[[session]]\nname = \"All\"\n[[session.step]]\ndo = \"free\"\n"
                              "say = \"Look around.\"\n"),
                  file);
    const std::string room = test::bundled_world("first_room.map");
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"lesson", file}, std::vector<std::string>{room}}) {
        std::vector<std::string> all = words;
        all.insert(all.end(), {"--no-window", "--device", "sim-t"});
        Pupil pupil(*this, ("pupil " + std::to_string(words.size())).c_str(), all);
        ASSERT_TRUE(pupil.hears("First room")) << pupil.all();
        if (words.size() == 1) {
            pupil.type("scale-bar");
            ASSERT_TRUE(pupil.hears("metres are 5.8")) << pupil.all();
            pupil.type("task");
            ASSERT_TRUE(pupil.hears("Begin Scale")) << pupil.all();
            pupil.type("1");
        }
        ASSERT_TRUE(pupil.hears("Look around.")) << pupil.all();
        pupil.type("scale-bar");
        ASSERT_TRUE(pupil.hears("metres are 43.8")) << pupil.all();
        pupil.type("done");
        ASSERT_TRUE(pupil.hears("All is over.")) << pupil.all();
        pupil.type("scale-bar");
        ASSERT_TRUE(pupil.hears("metres are 5.8")) << pupil.all();
        EXPECT_EQ(pupil.leave(), 0);
    }
}

TEST_F(TaughtByTheProgram, is_not_recorded_without_consent_and_not_taught_to_an_unknown_learner) {
    EXPECT_EQ(run({"learner", "new", "Oak Owl"}).exit_status, 0);
    std::vector<std::string> words = taught("2");
    words.push_back("--record");
    const ProgramRun refused = run(words);
    EXPECT_EQ(refused.exit_status, 1);
    EXPECT_THAT(refused.err, HasSubstr("Oak Owl has not agreed to be recorded"));
    Pupil pupil(*this, "pupil", taught("2"));
    ASSERT_TRUE(pupil.hears("Lap 1 of 4.")) << pupil.all();
    EXPECT_EQ(pupil.leave(), 0);
    EXPECT_THAT(pupil.all(), Not(HasSubstr("recorded")));
    EXPECT_TRUE(recordings().empty());
    words = taught("2");
    words[5] = "Oak Ovl";
    const ProgramRun unknown = run(words);
    EXPECT_EQ(unknown.exit_status, 1);
    EXPECT_THAT(unknown.err, HasSubstr("Did you mean Oak Owl?"));
    const std::string protocol =
        run({"lesson", test::bundled_world("school.lesson.toml"), "--protocol", "--learner", "oak owl"}).out;
    EXPECT_THAT(protocol, HasSubstr("[100, 60, 30, 0]"));
    EXPECT_EQ(protocol,
              run({"lesson", test::bundled_world("school.lesson.toml"), "--protocol", "--learner", "Oak Owl"}).out);
    EXPECT_EQ(protocol, run({"lesson", "school", "--protocol", "--learner", "Oak Owl"}).out);
    const ProgramRun missing = run({"lesson", "scool", "--check"});
    EXPECT_EQ(missing.exit_status, 2);
    EXPECT_EQ(missing.err,
              "There is no lesson \"scool\". Give the path of a file NAME.lesson.toml, or the name of one of these: "
              "school.\n");
}

TEST_F(TaughtByTheProgram, gives_the_same_errors_in_the_check_and_in_the_lesson_if_the_world_lacks_named_things) {
    const std::string good = content_of(test::bundled_world("school.lesson.toml"));
    const std::vector<std::pair<std::string, std::string>> faults = {
        {"thing = \"Trophy case\"", "thing = \"Trophy caze\""},
        {"{ room = \"Library\" }", "{ room = \"Libary\" }"},
        {"room = \"Entrance hall\"", "room = \"Entrance hal\""},
        {"to = [\"Trophy case\", \"Drinking fountain\"]", "to = [\"Trophy case\", \"Drinking fontain\"]"},
        {"block = [\"Lift door\"]", "block = [\"Lift dor\"]"},
        {"from = \"base\"", "from = \"bass\""},
    };
    for (const auto& [right, wrong] : faults) {
        std::string text = good;
        ASSERT_NE(text.find(right), std::string::npos) << right;
        text.replace(text.find(right), right.size(), wrong);
        const std::string file = home_.write("wrong.lesson.toml", text);
        const ProgramRun checked = run({"lesson", file, "--check"}), written = run({"lesson", file, "--protocol"});
        EXPECT_EQ(checked.exit_status, 2) << wrong;
        EXPECT_EQ(written.exit_status, 2) << wrong;
        // Compare only the last line, because on a busy machine progress messages may precede it.
        const auto last_line = [](const std::string& reported) {
            return reported.substr(reported.rfind('\n', reported.size() - 2) + 1);
        };
        EXPECT_EQ(last_line(written.err), last_line(checked.err));
        EXPECT_THAT(written.err, HasSubstr("line"));
        EXPECT_EQ(written.out, "");
    }
    // A lesson may name its world without the file extension.
    std::string named = good;
    const std::string world = "world = \"school.map\"";
    named.replace(named.find(world), world.size(), "world = \"school\"");
    const ProgramRun written = run({"lesson", home_.write("named.lesson.toml", named), "--protocol"});
    EXPECT_EQ(written.exit_status, 0) << written.err;
}

}  // namespace lesson_test
}  // namespace handrail::test
