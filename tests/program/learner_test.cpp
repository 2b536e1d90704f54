// Learners with the program itself: each has settings, marks and recordings of their own, and is gone once deleted.
#include <gmock/gmock.h>

#include <filesystem>

#include "tests/support/run_program.h"
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
        call.program = HANDRAIL_PROGRAM;
        call.arguments = std::move(words);
        call.input = input;
        call.environment = {{"XDG_DATA_HOME", (home_.path() / "data").string()},
                            {"XDG_STATE_HOME", (home_.path() / "state").string()}};
        return run_program(call);
    }
    ProgramRun explore(const std::string& learner, const std::string& input) {
        return run({TEST_WORLDS "/house.map", "--no-window", "--device", "none", "--learner", learner}, input);
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

TEST_F(LearnerProgram, keeps_marks_and_settings_of_each_apart_records_who_agreed_and_leaves_nothing_of_who_is_deleted) {
    for (const char* name : {"Oak Owl", "Fig Finch"}) EXPECT_EQ(run({"learner", "new", name}).exit_status, 0);
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--give", "record"}).exit_status, 0);
    const ProgramRun first = explore("Oak Owl", "verbosity\nmark\n");
    EXPECT_EQ(first.exit_status, 0) << first.err;
    EXPECT_THAT(first.out, HasSubstr("Oak Owl learns."));
    EXPECT_THAT(first.out, HasSubstr("This session is recorded."));
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
    EXPECT_THAT(deleted.out, HasSubstr("0 hits"));
    EXPECT_EQ(recordings(), 0U);
}

TEST_F(LearnerProgram, goes_on_learning_where_it_ended_as_long_as_that_is_agreed) {
    EXPECT_EQ(run({"learner", "new", "Oak Owl"}).exit_status, 0);
    const auto rooms_learnt = [this] {  // what the list of rooms begins with
        const std::string out = explore("Oak Owl", "learnt\n").out;
        const std::size_t list = out.find("Rooms learnt");
        return list == std::string::npos ? "no list in " + out : out.substr(list);
    };
    const std::string fresh = rooms_learnt();
    EXPECT_THAT(fresh, HasSubstr("floor"));
    EXPECT_EQ(explore("Oak Owl", "forward 4\nright 2\n").exit_status, 0);
    EXPECT_EQ(rooms_learnt(), fresh) << "without consent nothing is remembered";
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--give", "remember"}).exit_status, 0);
    EXPECT_EQ(explore("Oak Owl", "forward 4\n").exit_status, 0);
    EXPECT_THAT(explore("Oak Owl", "where\n").out, HasSubstr("You learnt here once before"));
    const std::string remembered = rooms_learnt();
    EXPECT_THAT(remembered, HasSubstr("Rooms learnt"));
    EXPECT_NE(remembered, fresh);
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--withdraw", "remember"}).exit_status, 0);
    EXPECT_EQ(rooms_learnt(), fresh) << "and what was is forgotten";
}

TEST_F(LearnerProgram, is_reported_on_over_all_sessions_and_shared_only_where_that_is_agreed) {
    EXPECT_EQ(run({"learner", "new", "Oak Owl"}).exit_status, 0);
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--give", "record"}).exit_status, 0);
    const std::string page = (home_.path() / "page.html").string(), table = (home_.path() / "table.csv").string();
    const std::vector<std::string> report = {"report", "--learner", "Oak Owl", "--html", page, "--csv", table};
    EXPECT_EQ(run({"learner", "consent", "Oak Owl", "--give", "share"}).exit_status, 0);
    EXPECT_THAT(run(report).err, HasSubstr("no recorded session of Oak Owl"));
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

}  // namespace learner_test
}  // namespace handrail::test
