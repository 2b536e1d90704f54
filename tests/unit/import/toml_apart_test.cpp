// Tests TOML files from other people, which a reader process parses. The values must be correct, and no text may crash
// or deceive the program's own process.
#include "app/import/toml_apart.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "app/core/kept/side_file.h"
#include "app/import/reader_answer.h"
#include "tests/support/deadly_toml.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "worlds/stored/archive.h"

namespace handrail {
namespace toml_apart_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kMarks =
    "[[mark]]\nname = \"door\"\nplace_m = [1.0, 2.0, 3.0]\nset = 2026-11-28T10:00:00Z\n"
    "of_a_later_version = { deep = [1, \"x\"] }\n";

class TomlApartTest : public testing::Test {
protected:
    // Returns an object that runs `script` in place of handrail-reader. The script writes its answer to descriptor 3.
    TomlApart by(const std::string& script, ReaderLimits limits = {1'000'000'000, 5, 60.0}) {
        const fs::path program = folder_.write(fmt::format("reader{}.sh", ++count_), "#!/bin/sh\n" + script + "\n");
        fs::permissions(program, fs::perms::owner_all);
        return TomlApart(program, limits);
    }
    // A reader process that answers every text with `bytes`.
    TomlApart answering(const std::string& bytes) {
        const fs::path answer = folder_.write(fmt::format("answer{}", ++count_), bytes);
        return by(fmt::format("cat {} >&3", answer.string()));
    }
    TomlApart answering(const TomlAnswer& answer) {
        ReaderAnswer reported;
        reported.read = true;
        Packer pack;
        pack(reported, answer);
        return answering(pack.take());
    }
    TomlApart answering(const TomlValue& values) { return answering(TomlAnswer{{}, values}); }

    const test::TemporaryFolder folder_;
    int count_ = 0;
};

std::string sentence_of(const Result<TomlValue>& read) {
    if (read) return "values";
    EXPECT_EQ(read.error().line, 0) << "nobody knows of any damage";
    return read.error().sentence();
}
const std::string kFailed = "The process for reading this file failed.";

TomlValue table_with(const std::string& key, TomlValue value) {
    TomlValue table = TomlValue::empty_table();
    table.set(key, std::move(value));
    return table;
}

TEST_F(TomlApartTest, returns_the_same_values_and_faults_as_parsing_in_this_process) {
    const TomlApart apart(find_reader_program());
    for (const std::string& text :
         {std::string(), kMarks, std::string("a = 1\n[b]\nc = [nan, -0.0]\nd = 07:32:00\n")}) {
        const auto there = apart(text), here = toml_of(text);
        ASSERT_TRUE(there) << there.error().sentence();
        EXPECT_TRUE(*there == *here);
    }
    EXPECT_EQ(apart(kMarks)->find("mark")->array()->front().line, toml_of(kMarks)->find("mark")->array()->front().line);
    for (const std::string text : {"a = 1\nb = = 2\n", "a = \"\xff\"", "[a]\n[a]\n"}) {
        const auto there = apart(text), here = toml_of(text);
        ASSERT_FALSE(there);
        EXPECT_EQ(there.error().line, here.error().line);
        EXPECT_EQ(there.error().column, here.error().column);
        EXPECT_FALSE(there.error().message.empty());
    }
}

TEST_F(TomlApartTest, survives_a_text_that_crashes_the_parser) {
    const TomlApart apart(find_reader_program());
    EXPECT_EQ(sentence_of(apart(test::deadly_toml())), kFailed);
    EXPECT_TRUE(apart(kMarks)) << "and reads the next one";
}

TEST_F(TomlApartTest, returns_one_sentence_for_any_end_of_the_reader) {
    for (const char* script :
         {"kill -SEGV $$", "kill -KILL $$", "exit 3", "exit 0", "printf nonsense >&3", "head -c 2000000 /dev/zero >&3"})
        EXPECT_EQ(sentence_of(by(script)(kMarks)), kFailed) << script;
    EXPECT_EQ(sentence_of(TomlApart(folder_.path() / "none")(kMarks)), kFailed);
    const auto begun = std::chrono::steady_clock::now();
    EXPECT_EQ(sentence_of(by("sleep 600 & wait", {1'000'000'000, 5, 0.5})(kMarks)), kFailed);
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(60));
    const auto large = by("exit 0")(std::string(kLargestToml_bytes + 1, '#'));
    EXPECT_THAT(sentence_of(large), HasSubstr("16"));
}

// A malicious text may gain control of the reader process, which can then answer anything.
TEST_F(TomlApartTest, rejects_answers_that_toml_cannot_produce) {
    TomlValue text, moment, deep, wrong_line;
    text.value = std::string("a\xff");
    moment.value = TomlMoment{.has_date = true, .month = 13};
    deep = TomlValue::empty_table();
    for (int i = 0; i < 2 * kDeepestToml; ++i) deep = table_with("a", deep);
    wrong_line.line = -1;
    const TomlMember one{"b", {}}, two{"a", {}};
    TomlValue unordered, twice, no_table;
    unordered.value = TomlValue::Table{one, two};
    twice.value = TomlValue::Table{one, one};
    no_table.value = TomlValue::Array{};
    const std::map<std::string, TomlValue> wrong{{"no UTF-8", table_with("a", text)},
                                                 {"no UTF-8 in a key", table_with("\xff", {})},
                                                 {"no date", table_with("a", moment)},
                                                 {"too deep", deep},
                                                 {"a negative line", table_with("a", wrong_line)},
                                                 {"keys out of order", unordered},
                                                 {"a key twice", twice},
                                                 {"no table", no_table}};
    for (const auto& [name, values] : wrong) EXPECT_EQ(sentence_of(answering(values)(kMarks)), kFailed) << name;
    EXPECT_TRUE(answering(table_with("a", {}))(kMarks)) << "a good one";

    const auto fault = answering(TomlAnswer{{"", 7, -3, "\x1b[2J\nwipes\x07 " + std::string(5000, 'x')}, {}})(kMarks);
    ASSERT_FALSE(fault);
    EXPECT_EQ(fault.error().line, 7);
    EXPECT_EQ(fault.error().message.find_first_of("\x1b\n\x07"), std::string::npos);
    EXPECT_LE(fault.error().message.size(), 300U);
}

TEST_F(TomlApartTest, parses_identical_bytes_only_once) {
    const fs::path count = folder_.path() / "count";
    const TomlApart fails = by(fmt::format("echo x >> {}; exit 1", count.string())), copy = fails;
    for (int i = 0; i < 5; ++i) EXPECT_EQ(sentence_of((i % 2 ? copy : fails)(kMarks)), kFailed);
    EXPECT_EQ(test::content_of(count), "x\n");
    EXPECT_EQ(sentence_of(copy(kMarks + "\n")), kFailed);
    EXPECT_EQ(test::content_of(count), "x\nx\n");
    std::vector<std::string> texts;
    for (std::size_t i = 0; i <= TomlApart::kMostKnown; ++i) texts.push_back(fmt::format("a = {}", i));
    const TomlApart none(folder_.path() / "none");
    for (const std::string& text : texts) EXPECT_EQ(sentence_of(none(text)), kFailed);
}

class SideFileApart : public TomlApartTest {
protected:
    SideFileApart() {
        world_ = folder_.write("house.map", "{ }");
        near_ = folder_.path() / "house.map.handrail.toml";
    }
    SideFile opened(const TomlReader& toml = TomlApart(find_reader_program())) {
        return SideFile::of_world(world_, data_.path(), false, toml);
    }
    static std::vector<std::string> names_in(const SideFile& file) {
        std::vector<std::string> names;
        for (const SideEntry& entry : file.entries("mark")) names.push_back(text_of(entry, "name"));
        return names;
    }
    static void add(SideFile& file, const std::string& name) {
        std::vector<SideEntry> marks = file.entries("mark");
        marks.push_back({{"name", name}, {"place_m", std::vector<double>{0.0, 0.5, 1.0}}});
        file.set_entries("mark", marks);
    }

    const test::TemporaryFolder data_;
    fs::path world_, near_;
};

TEST_F(SideFileApart, is_saved_and_merged_with_the_changes_of_another_session) {
    folder_.write("house.map.handrail.toml", kMarks);
    SideFile one = opened(), other = opened();
    EXPECT_THAT(names_in(one), ElementsAre("door"));
    add(one, "window");
    ASSERT_TRUE(one.save());
    add(other, "stairs");
    ASSERT_TRUE(other.save());
    EXPECT_TRUE(other.take_over().differs);
    const SideFile again = opened();
    EXPECT_TRUE(again.news().empty());
    EXPECT_THAT(names_in(again), testing::UnorderedElementsAre("door", "window", "stairs"));
    EXPECT_THAT(test::content_of(near_), HasSubstr("of_a_later_version = { deep = [ 1, \"x\" ] }"));
    EXPECT_THAT(test::content_of(near_), HasSubstr("2026-11-28"));
}

TEST_F(SideFileApart, that_crashes_its_reader_stays_unchanged_and_additions_go_to_another_file) {
    folder_.write("house.map.handrail.toml", test::deadly_toml());
    for (const char* name : {"first", "second"}) {
        SideFile file = opened();
        ASSERT_EQ(file.news().size(), 1U);
        EXPECT_THAT(file.news().front(), HasSubstr("remains in house.map.handrail.toml"));
        add(file, name);
        ASSERT_TRUE(file.save());
        EXPECT_NE(file.path(), near_);
    }
    EXPECT_THAT(names_in(opened()), ElementsAre("first", "second")) << "those of the last session too";
    SideFile file = opened();
    file.set_table("unit", {{"metres", 0.5}});
    ASSERT_TRUE(file.save());
    const TomlApart toml(find_reader_program());
    EXPECT_EQ(number_of(SideFile::peek(world_, data_.path(), false, "unit", toml), "metres", 0.0), 0.5);
    EXPECT_EQ(test::content_of(near_), test::deadly_toml());
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_.path()))
        EXPECT_EQ(entry.path().string().find("damaged"), std::string::npos) << entry.path();
}

TEST_F(SideFileApart, that_crashes_its_reader_and_has_no_alternative_place_is_not_overwritten) {
    folder_.write("house.map.handrail.toml", test::deadly_toml());
    SideFile file = SideFile::of_world(world_, {}, false, TomlApart(find_reader_program()));
    add(file, "lost otherwise");
    const auto saved = file.save();
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().sentence(), "house.map.handrail.toml: " + kFailed);
    EXPECT_EQ(test::content_of(near_), test::deadly_toml());
    EXPECT_THAT(names_in(file), ElementsAre("lost otherwise")) << "they are still here";
    fs::remove(near_);
    EXPECT_TRUE(file.save());
}

// Another program writes the side file while this session runs.
TEST_F(SideFileApart, that_changed_during_the_session_and_crashes_its_reader_is_not_overwritten) {
    SideFile file = opened();
    add(file, "here");
    ASSERT_TRUE(file.save());
    folder_.write("house.map.handrail.toml", test::deadly_toml());
    add(file, "there");
    ASSERT_TRUE(file.save());
    EXPECT_NE(file.path(), near_);
    EXPECT_EQ(test::content_of(near_), test::deadly_toml());
    EXPECT_THAT(names_in(file), ElementsAre("here", "there"));
    EXPECT_THAT(names_in(opened()), ElementsAre("here", "there"));
}

// If a file is in this program's own format, the program must save it again without starting a reader process.
TEST_F(SideFileApart, is_saved_without_starting_a_reader_if_nobody_else_wrote_it) {
    const fs::path count = folder_.path() / "count";
    SideFile file = opened(by(fmt::format("echo x >> {}; exit 1", count.string())));
    for (const char* name : {"one", "two", "three"}) {
        add(file, name);
        ASSERT_TRUE(file.save());
    }
    EXPECT_FALSE(fs::exists(count));
    EXPECT_THAT(names_in(opened()), ElementsAre("one", "two", "three"));
}

}  // namespace toml_apart_test
}  // namespace handrail
