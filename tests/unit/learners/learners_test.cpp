// Tests learners in a data folder: listing, exporting and deleting them. Also tests the command that does all of this.
#include "app/learners/learners.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "app/learners/export_gate.h"
#include "app/learners/exported.h"
#include "app/learners/forget.h"
#include "app/main/commands.h"
#include "app/record/gzip_pieces.h"
#include "tests/support/environment.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/files.h"

namespace handrail {
namespace learners_test {

namespace fs = std::filesystem;
using test::TemporaryFolder;

TEST(Learners, are_created_and_found_by_name_or_folder) {
    const TemporaryFolder data;
    const Learners learners(data.path());
    EXPECT_TRUE(learners.all().learners.empty());
    const auto made = learners.make("Maple Heron", "[walk]\nturn_deg = 45.0\n");
    ASSERT_TRUE(made) << made.error().sentence();
    ASSERT_TRUE(learners.find("maple heron"));
    EXPECT_EQ(learners.find("maple heron")->id, made->id);
    ASSERT_TRUE(learners.find(made->id));
    EXPECT_EQ(test::content_of(learners.settings_of(made->id)), "[walk]\nturn_deg = 45.0\n");
    EXPECT_EQ(learners.folder_of(made->id).string().find("Maple"), std::string::npos) << "no name in a file's name";
    const auto twice = learners.make("MAPLE Heron", "");
    ASSERT_FALSE(twice);
    EXPECT_NE(twice.error().message.find("already"), std::string::npos);
    const auto other = learners.find("Maple Hero");
    ASSERT_FALSE(other);
    EXPECT_NE(other.error().message.find("Maple Heron"), std::string::npos) << "the nearest is named";
}

TEST(Learners, are_readable_only_by_the_person) {
    const TemporaryFolder data;
    const Learners learners(data.path());
    const auto made = learners.make("Oak Owl", "");
    ASSERT_TRUE(made);
    using fs::perms;
    EXPECT_EQ(fs::status(learners.folder()).permissions(), perms::owner_all);
    EXPECT_EQ(fs::status(learners.folder_of(made->id)).permissions(), perms::owner_all);
    for (const auto& file : fs::directory_iterator(learners.folder_of(made->id)))
        EXPECT_EQ(file.status().permissions(), perms::owner_read | perms::owner_write) << file.path();
}

TEST(Learners, in_one_damaged_file_hide_nobody_else_and_the_file_stays_unchanged) {
    const TemporaryFolder data;
    const Learners learners(data.path());
    const auto first = learners.make("Oak Owl", ""), second = learners.make("Fig Finch", "");
    ASSERT_TRUE(first && second);
    const fs::path file = learners.folder_of(first->id) / "learner.toml";
    ASSERT_TRUE(write_file_atomically(file, "name = \"Oak Owl\nconsent"));
    const Learners::Found found = learners.all();
    ASSERT_EQ(found.learners.size(), 1U);
    EXPECT_EQ(found.learners[0].name, "Fig Finch");
    ASSERT_EQ(found.faults.size(), 1U);
    EXPECT_EQ(found.faults[0].file, file.string());
    EXPECT_EQ(found.faults[0].line, 1);
    EXPECT_FALSE(learners.change(first->id, [](Learner& one) { one.name = "other"; }));
    EXPECT_EQ(test::content_of(file), "name = \"Oak Owl\nconsent");
    EXPECT_EQ(learners.id_of(first->id), first->id) << "can still be deleted";
}

TEST(Exported, file_is_recognised_until_it_changes) {
    const TemporaryFolder data, elsewhere;
    const fs::path page = elsewhere.write("page.html", "<p>One"), table = elsewhere.write("table.csv", "a,b");
    ASSERT_TRUE(note_exported(data.path(), page, "<p>One"));
    ASSERT_TRUE(note_exported(data.path(), table, "a,b"));
    ASSERT_TRUE(note_exported(data.path(), page, "<p>Two, which was noted and could not be written"));
    std::vector<Error> faults;
    const auto all = exported_of(data.path(), faults);
    ASSERT_EQ(all.size(), 2U) << "written over is one file";
    EXPECT_TRUE(faults.empty());
    EXPECT_TRUE(unchanged(all[0]) && unchanged(all[1]));
    elsewhere.write("table.csv", "a,c");
    const Holdings holdings = holdings_of(data.path());
    EXPECT_EQ(holdings.exported, std::vector{page});
    EXPECT_EQ(holdings.exported_other, std::vector{table});
}

TEST(Exported, list_cut_at_every_byte_reports_the_line_and_keeps_earlier_entries) {
    const TemporaryFolder data, elsewhere;
    ASSERT_TRUE(note_exported(data.path(), elsewhere.path() / "a", "1"));
    ASSERT_TRUE(note_exported(data.path(), elsewhere.path() / "b", "2"));
    const std::string whole = test::content_of(data.path() / "exports.jsonl");
    const std::size_t first = whole.find('\n');
    for (std::size_t length = 0; length < whole.size(); ++length) {
        ASSERT_TRUE(write_file_atomically(data.path() / "exports.jsonl", whole.substr(0, length)));
        std::vector<Error> faults;
        const auto all = exported_of(data.path(), faults);
        EXPECT_EQ(all.size(), length < first ? 0U : length < whole.size() - 1 ? 1U : 2U) << length;
        const bool cut = length != 0 && length != first && length != first + 1 && length != whole.size() - 1;
        ASSERT_EQ(faults.size(), cut ? 1U : 0U) << length;
        if (cut) {
            EXPECT_EQ(faults[0].line, length < first ? 1 : 2) << length;
        }
    }
}

TEST(ExportGate, identifies_the_owner_of_data_by_its_folder_after_resolving_links) {
    const TemporaryFolder data, elsewhere;
    const Learners learners(data.path());
    const auto owl = learners.make("Oak Owl", ""), finch = learners.make("Fig Finch", "");
    ASSERT_TRUE(owl && finch);
    const fs::path recording = learners.recordings_of(owl->id) / "one", link = elsewhere.path() / "link",
                   out = elsewhere.path() / "out.csv";
    fs::create_directories(recording);
    fs::create_directory_symlink(recording, link);
    EXPECT_FALSE(ExportGate::of(learners, elsewhere.path())->learner());
    EXPECT_FALSE(ExportGate::of(Learners({}), recording)->learner()) << "without a home there are no learners";
    for (const fs::path& from : {recording, link, link / "events.jsonl", recording / "../one"}) {
        const auto way = ExportGate::of(learners, from);
        ASSERT_TRUE(way && way->learner()) << from;
        EXPECT_EQ(way->learner()->id, owl->id);
        EXPECT_FALSE(way->allows(out));
        EXPECT_FALSE(way->write(out, "1", write_file_atomically));
        EXPECT_FALSE(fs::exists(out));
        EXPECT_FALSE(way->allows(learners.folder_of(finch->id) / "out.csv")) << "another learner's folder is elsewhere";
        EXPECT_TRUE(way->allows(recording / "../out.csv")) << "in the learner's own folder nobody else looks";
    }
    ASSERT_TRUE(learners.change(owl->id, [](Learner& one) { one.consent(Purpose::Share) = Consent{today(), {}, {}}; }));
    EXPECT_TRUE(ExportGate::of(learners, link)->write(out, "1", write_file_atomically));
    EXPECT_EQ(holdings_of(learners.folder_of(owl->id)).exported, std::vector{out});
    ASSERT_TRUE(write_file_atomically(learners.folder_of(owl->id) / "learner.toml", "name = "));
    EXPECT_FALSE(ExportGate::of(learners, link)) << "nobody knows what was agreed to";
}

TEST(ExportGate, writes_no_file_that_it_cannot_note) {
    const TemporaryFolder data, elsewhere;
    const Learners learners(data.path());
    const auto owl = learners.make("Oak Owl", "");
    ASSERT_TRUE(owl);
    ASSERT_TRUE(learners.change(owl->id, [](Learner& one) { one.consent(Purpose::Share) = Consent{today(), {}, {}}; }));
    fs::create_directory(learners.folder_of(owl->id) / "exports.jsonl");
    const fs::path out = elsewhere.path() / "out.csv";
    EXPECT_FALSE(ExportGate::of(learners, learners.folder_of(owl->id))->write(out, "1", write_file_atomically));
    EXPECT_FALSE(fs::exists(out));
}

TEST(Search, finds_words_in_file_names_in_texts_and_in_compressed_files) {
    const TemporaryFolder data;
    fs::create_directories(data.path() / "a/b");
    const fs::path plain = data.write("a/plain.txt", "said to Oak Owl, twice"),
                   other = data.write("a/other.txt", "Oak Owls");
    const fs::path packed = data.write("a/b/rows.csv.gz", gzip_piece("t\n1\n") + gzip_piece("=2 for Oak Owl\n"));
    const fs::path named = data.write("a/k7f2m3qa.txt", "x");
    const std::vector<std::string> words = {"Oak Owl", "k7f2m3qa", ""};
    const std::vector<fs::path> folders = {data.path(), data.path() / "nowhere"};
    const Search found = search_for(words, folders);
    EXPECT_EQ(found.hits, (std::vector{packed, named, plain}));
    EXPECT_EQ(found.files, 4U);
    EXPECT_TRUE(found.unread.empty());
}

// ---- the command `handrail learner` ----

struct Said {
    int status = 0;
    std::string out, err;
};
class LearnerCommand : public testing::Test {
protected:
    Said run(LearnerArguments arguments, const std::string& typed = {}) {
        std::istringstream in(typed);
        std::ostringstream out, err;
        Said said;
        said.status = run_learner(arguments, in, out, err);
        said.out = out.str();
        said.err = err.str();
        return said;
    }
    fs::path data() const { return home_.path() / "data/handrail"; }

    TemporaryFolder home_;
    test::WithEnvironment data_{"XDG_DATA_HOME", (home_.path() / "data").c_str()},
        state_{"XDG_STATE_HOME", (home_.path() / "state").c_str()},
        config_{"XDG_CONFIG_HOME", (home_.path() / "config").c_str()};
};

TEST_F(LearnerCommand, suggests_a_name_and_creates_and_lists_learners) {
    EXPECT_NE(run({}).out.find("no learners yet"), std::string::npos);
    const Said offered = run({.action = "new"});
    EXPECT_EQ(offered.status, 0);
    EXPECT_FALSE(fs::exists(data() / "learners")) << "an offer makes nobody";
    EXPECT_EQ(run({.action = "new", .name = "Maple Heron"}).status, 0);
    const Said listed = run({});
    EXPECT_EQ(listed.out, "Maple Heron: has agreed to nothing. No recordings.\n");
}

TEST_F(LearnerCommand, asks_before_it_accepts_a_possible_real_name) {
    EXPECT_EQ(run({.action = "new", .name = "Anna Schmidt"}).status, 1) << "nobody answered";
    EXPECT_EQ(run({.action = "new", .name = "Anna Schmidt"}, "no\n").status, 1);
    EXPECT_FALSE(fs::exists(data() / "learners"));
    EXPECT_EQ(run({.action = "new", .name = "Anna Schmidt"}, "Yes\n").status, 0);
}

TEST_F(LearnerCommand, creates_a_consenting_learner_at_once_and_none_for_an_unknown_purpose) {
    EXPECT_EQ(run({.action = "new", .name = "Maple Heron", .give = "remmeber"}).status, 2);
    EXPECT_NE(run({}).out.find("no learners yet"), std::string::npos);
    const Said made = run({.action = "new", .name = "Maple Heron", .give = "remember"});
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(made.out.find("not agreed that Maple Heron is remembered"), std::string::npos) << made.out;
    EXPECT_NE(made.out.find("Nobody has agreed that Maple Heron is recorded"), std::string::npos) << made.out;
}

TEST_F(LearnerCommand, gives_and_withdraws_consent_by_purpose) {
    ASSERT_EQ(run({.action = "new", .name = "Oak Owl"}).status, 0);
    const Said given = run(
        {.action = "consent", .name = "Oak Owl", .give = "remember,record", .by = "her father", .until = "2999-01-31"});
    EXPECT_EQ(given.status, 0) << given.err;
    EXPECT_NE(given.out.find("as agreed by her father, until 2999-01-31"), std::string::npos) << given.out;
    EXPECT_EQ(run({}).out, "Oak Owl: is remembered and is recorded. No recordings.\n");
    EXPECT_EQ(run({.action = "consent", .name = "Oak Owl", .withdraw = "record"}).status, 0);
    EXPECT_EQ(run({}).out, "Oak Owl: is remembered. No recordings.\n");
    for (const LearnerArguments& wrong :
         {LearnerArguments{.action = "consent", .name = "Oak Owl"},
          LearnerArguments{.action = "consent", .name = "Oak Owl", .give = "everything"},
          LearnerArguments{.action = "consent", .name = "Oak Owl", .give = "share", .until = "2000-01-01"},
          LearnerArguments{.action = "consent", .name = "Oak Owl", .give = "share", .until = "soon"},
          LearnerArguments{.action = "consent"}, LearnerArguments{.action = "lost"}}) {
        const Said said = run(wrong);
        EXPECT_EQ(said.status, 2);
        EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
    }
    EXPECT_EQ(run({}).out, "Oak Owl: is remembered. No recordings.\n") << "nothing of it was taken";
}

// The learner has data of every kind: recordings with the learner's name, additions to worlds and settings. Some
// exports are unchanged; others were changed after the export.
TEST_F(LearnerCommand, deletes_after_confirmation_and_a_search_then_finds_nothing) {
    ASSERT_EQ(run({.action = "new", .name = "Oak Owl"}).status, 0);
    ASSERT_EQ(run({.action = "new", .name = "Fig Finch"}).status, 0);
    const Learners learners(data());
    const auto learner = learners.find("Oak Owl");
    ASSERT_TRUE(learner);
    const fs::path folder = learners.folder_of(learner->id), page = home_.path() / "page.html";
    ASSERT_TRUE(write_file_atomically(folder / "recordings/one/events.jsonl", "{\"text\":\"Oak Owl learns.\"}\n"));
    ASSERT_TRUE(write_file_atomically(folder / "recordings/one/frames.csv.gz", gzip_piece("Oak Owl")));
    ASSERT_TRUE(write_file_atomically(folder / "worlds/house.map.toml", "x = 1\n"));
    ASSERT_TRUE(write_file_atomically(page, "<p>Oak Owl</p>"));
    ASSERT_TRUE(note_exported(folder, page, "<p>Oak Owl</p>"));
    EXPECT_EQ(run({.action = "delete", .name = "Oak Owl"}, "no\n").status, 1);
    EXPECT_TRUE(fs::exists(page));
    const Said deleted = run({.action = "delete", .name = "Oak Owl"}, "yes\n");
    EXPECT_EQ(deleted.status, 0) << deleted.out << deleted.err;
    EXPECT_NE(deleted.out.find("1 recording, "), std::string::npos) << deleted.out;
    EXPECT_NE(deleted.out.find(page.string()), std::string::npos);
    EXPECT_NE(deleted.out.find("no traces found"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder));
    EXPECT_FALSE(fs::exists(page));
    EXPECT_TRUE(learners.find("Fig Finch"));
}

TEST_F(LearnerCommand, lists_files_where_traces_of_a_deleted_learner_remain) {
    ASSERT_EQ(run({.action = "new", .name = "Oak Owl"}).status, 0);
    const fs::path left = data() / "recordings/two/events.jsonl.gz";
    ASSERT_TRUE(write_file_atomically(left, gzip_piece("said: Oak Owl, well done")));
    const Said deleted = run({.action = "delete", .name = "Oak Owl", .yes = true});
    EXPECT_EQ(deleted.status, 1);
    EXPECT_NE(deleted.out.find("left in 1 file"), std::string::npos) << deleted.out;
    EXPECT_NE(deleted.out.find(left.string()), std::string::npos);
}

}  // namespace learners_test
}  // namespace handrail
