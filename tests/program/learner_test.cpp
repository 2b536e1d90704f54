// Runs the program with several learners. Each must have separate settings, marks and recordings, and nothing may
// remain of a deleted learner.
#include <gmock/gmock.h>

#include <filesystem>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace learner_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class LearnerProgram : public testing::Test {
protected:
    ProgramRun run(std::vector<std::string> words, const std::string& input = {}) {
        ProgramCall call;
        call.program = test::built_program("handrail");
        call.arguments = std::move(words);
        call.input = input;
        call.environment = {{"XDG_DATA_HOME", (home_.path() / "data").string()},
                            {"XDG_STATE_HOME", (home_.path() / "state").string()}};
        return run_program(call);
    }
    ProgramRun explore(const std::string& learner, const std::string& input) {
        return run({test::bundled_world("house.map"), "--no-window", "--device", "none", "--learner", learner}, input);
    }
    std::size_t recordings() const {
        std::size_t count = 0;
        std::error_code ec;
        for (const auto& entry : fs::recursive_directory_iterator(home_.path() / "data", ec))
            count += entry.path().filename() == "events.jsonl";
        return count;
    }
    int settings_that_say(const std::string& word) const {
        int count = 0;
        for (const auto& entry : fs::recursive_directory_iterator(home_.path() / "data"))
            count +=
                entry.path().filename() == "settings.toml" && content_of(entry.path()).find(word) != std::string::npos;
        return count;
    }
    TemporaryFolder home_;
};

TEST_F(LearnerProgram, separates_marks_and_settings_records_only_with_consent_and_deletes_everything_of_a_learner) {
    for (const char* name : {"Oak Owl", "Fig Finch"}) EXPECT_EQ(run({"learner", "new", name}).exit_status, 0);
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--give", "record"}).exit_status, 0);
    const ProgramRun first = explore("Oak Owl", "verbosity\nmark\n");
    EXPECT_EQ(first.exit_status, 0) << first.err;
    EXPECT_THAT(first.out, HasSubstr("Oak Owl is learning."));
    EXPECT_THAT(first.out, HasSubstr("This session is being recorded."));
    EXPECT_EQ(recordings(), 1U);
    const ProgramRun other = explore("Fig Finch", "marks\n");
    EXPECT_THAT(other.out, HasSubstr("1 of 2"));
    EXPECT_THAT(other.out, Not(HasSubstr("recorded")));
    EXPECT_EQ(recordings(), 1U);
    const ProgramRun again = explore("oak owl", "marks\n");
    EXPECT_THAT(again.out, HasSubstr("1 of 3"));
    EXPECT_EQ(settings_that_say("verbosity"), 1) << "of one who changed it";
    const ProgramRun refused = run({"--learner", "Fig Finch", "--record"});
    EXPECT_EQ(refused.exit_status, 1);
    EXPECT_THAT(refused.err, HasSubstr("Fig Finch has not agreed to be recorded"));
    EXPECT_THAT(run({"--learner", "Oak Ovl"}).err, HasSubstr("Did you mean Oak Owl?"));
    const ProgramRun deleted = run({"learner", "delete", "Oak Owl"}, "yes\n");
    EXPECT_EQ(deleted.exit_status, 0) << deleted.out << deleted.err;
    EXPECT_THAT(deleted.out, HasSubstr("2 recordings"));
    EXPECT_THAT(deleted.out, HasSubstr("no traces found"));
    EXPECT_EQ(recordings(), 0U);
}

TEST_F(LearnerProgram, has_a_learner_chosen_in_the_session_and_named_in_no_other_recording) {
    for (const char* name : {"Fig Finch", "Oak Owl"})
        EXPECT_EQ(run({"learner", "new", name, "--give", "remember,record"}).exit_status, 0);
    EXPECT_EQ(run({"learner", "consent", "Fig Finch", "--withdraw", "record"}).exit_status, 0);
    const ProgramRun all = explore("Oak Owl",
                                   "mark\nmine\nlearners\n2\nmarks\nescape\nlearners\n2\nlearners fig finch\n"
                                   "learners oak owl\nmarks\nescape\nlearners\n1\nwhere\n");
    EXPECT_EQ(all.exit_status, 0) << all.err;
    std::size_t at = 0;
    for (const char* words : {
             "Oak Owl is learning.",
             "Oak Owl is here.",  // the current item is the learner's own entry, so the list announces it first
             "Oak Owl, is remembered and is recorded, 3 of 3",
             "Fig Finch is learning.",
             "1 of 2",  // the list of marks has two entries, and neither is the mark of the other learner
             "Fig Finch is here.",
             "Fig Finch, is remembered, 2 of 3",
             // Choosing the current learner announces what is stored about them.
             "Fig Finch: is remembered. No recordings.",
             "Oak Owl is learning.",
             "1 of 3",
             "No learner is signed in.",
             "facing",
         }) {
        const std::size_t found = all.out.find(words, at);
        ASSERT_NE(found, std::string::npos) << words << "\n" << all.out;
        at = found;
    }
    std::vector<fs::path> folders;
    for (const auto& entry : fs::recursive_directory_iterator(home_.path() / "data"))
        if (entry.path().filename() == "events.jsonl") folders.push_back(entry.path().parent_path());
    EXPECT_EQ(folders.size(), 2U) << "Oak Owl was here twice";
    for (const fs::path& folder : folders) {
        EXPECT_THAT(content_of(folder / "events.jsonl"), Not(HasSubstr("Fig Finch")));
        const ProgramRun again = run({"replay", folder.string(), "--check"});
        EXPECT_EQ(again.exit_status, 0) << again.out << again.err;
    }
    EXPECT_THAT(run({"learner", "delete", "Fig Finch", "--yes"}).out, HasSubstr("no traces found"));
}

TEST_F(LearnerProgram, is_recorded_only_in_the_learners_own_folder) {
    EXPECT_EQ(run({"learner", "new", "Oak Owl", "--give", "record"}).exit_status, 0);
    const std::string elsewhere = (home_.path() / "elsewhere").string();
    for (const std::vector<std::string>& words : {std::vector<std::string>{test::bundled_world("house.map")},
                                                  {"lesson", test::bundled_world("school.lesson.toml")}}) {
        std::vector<std::string> all = words;
        all.insert(all.end(), {"--no-window", "--device", "none", "--learner", "Oak Owl", "--record-in", elsewhere});
        const ProgramRun refused = run(all);
        EXPECT_EQ(refused.exit_status, 2) << refused.out;
        EXPECT_THAT(refused.err, HasSubstr("--record-in"));
        EXPECT_FALSE(fs::exists(elsewhere));
    }
    EXPECT_EQ(recordings(), 0U);
}

TEST_F(LearnerProgram, does_not_list_a_learners_world_among_everyones_recent_worlds) {
    EXPECT_EQ(run({"learner", "new", "Oak Owl", "--give", "remember"}).exit_status, 0);
    const fs::path own = home_.path() / "worlds/owls_very_own.map";
    fs::create_directories(own.parent_path());
    fs::copy_file(test::bundled_world("first_room.map"), own);
    const auto files_that_say = [this](const std::string& words) {
        std::vector<std::string> files;
        fs::create_directories(home_.path() / "state");
        for (const char* folder : {"data", "state"})
            for (const auto& entry : fs::recursive_directory_iterator(home_.path() / folder))
                if (entry.path().string().find(words) != std::string::npos ||
                    (entry.is_regular_file() && content_of(entry.path()).find(words) != std::string::npos))
                    files.push_back(entry.path().filename().string());
        return files;
    };
    const std::vector<std::string> here = {own.string(), "--no-window", "--device", "none", "--learner", "Oak Owl"};
    EXPECT_EQ(run(here, "forward 2\n").exit_status, 0);
    EXPECT_THAT(files_that_say("owls_very_own"), testing::Contains("recent-worlds.txt"));
    EXPECT_FALSE(fs::exists(home_.path() / "state/handrail/recent-worlds.txt"));
    // In a later session, the program must also offer this place to the learner.
    EXPECT_THAT(run({test::bundled_world("house.map"), "--no-window", "--device", "none", "--learner", "Oak Owl"},
                    "menu\n2\n2\n")
                    .out,
                HasSubstr("6 by 4 metres"));
    const ProgramRun deleted = run({"learner", "delete", "Oak Owl", "--yes"});
    EXPECT_EQ(deleted.exit_status, 0) << deleted.out << deleted.err;
    EXPECT_THAT(files_that_say("owls_very_own"), testing::IsEmpty());
}

TEST_F(LearnerProgram, resumes_the_learning_progress_only_with_consent) {
    EXPECT_EQ(run({"learner", "new", "Oak Owl"}).exit_status, 0);
    // Returns the beginning of the list of rooms. On a busy machine, the program may announce more after the list.
    const auto rooms_learnt = [this] {
        const std::string out = explore("Oak Owl", "learnt\n").out;
        const std::size_t list = out.find("Rooms learnt");
        return list == std::string::npos ? "no list in " + out : out.substr(list, out.find('\n', list) - list);
    };
    const std::string fresh = rooms_learnt();
    EXPECT_THAT(fresh, HasSubstr("floor"));
    EXPECT_EQ(explore("Oak Owl", "forward 4\nright 2\n").exit_status, 0);
    EXPECT_EQ(rooms_learnt(), fresh) << "without consent nothing is remembered";
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--give", "remember"}).exit_status, 0);
    EXPECT_EQ(explore("Oak Owl", "forward 4\n").exit_status, 0);
    EXPECT_THAT(explore("Oak Owl", "where\n").out, HasSubstr("You have learnt this place once before"));
    const std::string remembered = rooms_learnt();
    EXPECT_THAT(remembered, HasSubstr("Rooms learnt"));
    EXPECT_NE(remembered, fresh);
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--withdraw", "remember"}).exit_status, 0);
    EXPECT_EQ(rooms_learnt(), fresh) << "and what was is forgotten";
}

TEST_F(LearnerProgram, is_reported_on_over_all_sessions_and_shared_only_with_consent) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "LearnerProgram.resumes_the_learning_* runs the same threads";
    EXPECT_EQ(run({"learner", "new", "Oak Owl"}).exit_status, 0);
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--give", "record"}).exit_status, 0);
    const std::string page = (home_.path() / "page.html").string(), table = (home_.path() / "table.csv").string();
    const std::vector<std::string> report = {"report", "--learner", "Oak Owl", "--html", page, "--csv", table};
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--give", "share"}).exit_status, 0);
    EXPECT_THAT(run(report).err, HasSubstr("any recorded session of Oak Owl"));
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--withdraw", "share"}).exit_status, 0);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(explore("Oak Owl", "where\nforward 3\n").exit_status, 0);
    const ProgramRun refused = run(report);
    EXPECT_EQ(refused.exit_status, 1);
    EXPECT_THAT(refused.err, HasSubstr("has not agreed"));
    EXPECT_FALSE(fs::exists(page));
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--give", "share"}).exit_status, 0);
    const ProgramRun made = run(report);
    EXPECT_EQ(made.exit_status, 0) << made.err;
    EXPECT_THAT(made.out, HasSubstr("There were 2 sessions"));
    EXPECT_THAT(content_of(page), HasSubstr("Oak Owl"));
    EXPECT_THAT(content_of(table), Not(HasSubstr("Oak Owl")));
    const ProgramRun deleted = run({"learner", "delete", "Oak Owl", "--yes"});
    EXPECT_EQ(deleted.exit_status, 0) << deleted.out << deleted.err;
    EXPECT_FALSE(fs::exists(page) || fs::exists(table)) << "what was written elsewhere and is as it was goes too";
}

TEST_F(LearnerProgram, has_a_diary_that_is_exported_only_with_consent_to_share) {
    EXPECT_EQ(run({"learner", "new", "Oak Owl"}).exit_status, 0);
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--give", "remember"}).exit_status, 0);
    EXPECT_THAT(explore("Oak Owl", "forward 4\ndiary\n").out, HasSubstr("iary"));
    const std::string table = (home_.path() / "diary.csv").string();
    EXPECT_EQ(run({"learner", "diary", "Oak Owl"}).exit_status, 2);
    const ProgramRun refused = run({"learner", "diary", "Oak Owl", "--to", table});
    EXPECT_EQ(refused.exit_status, 1);
    EXPECT_THAT(refused.err, HasSubstr("has not agreed"));
    EXPECT_FALSE(fs::exists(table));
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--give", "share"}).exit_status, 0);
    const ProgramRun made = run({"learner", "diary", "Oak Owl", "--to", table});
    EXPECT_EQ(made.exit_status, 0) << made.err;
    EXPECT_THAT(content_of(table), testing::StartsWith("world,day,room,seconds,walls_percent,floor_percent\r\n"));
    EXPECT_EQ(run({"learner", "delete", "Oak Owl", "--yes"}).exit_status, 0);
    EXPECT_FALSE(fs::exists(table)) << "what was written elsewhere goes too";
}

}  // namespace learner_test
}  // namespace handrail::test
