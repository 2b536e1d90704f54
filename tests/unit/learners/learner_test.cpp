// Tests how the program reads and writes learner.toml.
#include "app/learners/learner.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace learner_test {

const std::string kWhole =
    "name = \"Maple Heron\"\ncreated = \"2026-11-24\"\ncane = \"long\"\n\n"
    "[consent.record]\ngiven = \"2026-11-24\"\nby = \"the learner\"\nuntil = \"2027-11-24\"\nwitness = 2\n\n"
    "[consent.research]\ngiven = \"2026-11-25\"\n";

TEST(Learner, is_read_as_the_file_says) {
    const auto learner = read_learner(kWhole, "learner.toml");
    ASSERT_TRUE(learner) << learner.error().sentence();
    EXPECT_EQ(learner->name, "Maple Heron");
    EXPECT_EQ(learner->created, "2026-11-24");
    ASSERT_TRUE(learner->consent(Purpose::Record));
    EXPECT_EQ(learner->consent(Purpose::Record)->by, "the learner");
    EXPECT_FALSE(learner->consent(Purpose::Remember));
}

TEST(Learner, consents_only_to_the_agreed_purposes_and_until_the_last_day) {
    const auto learner = read_learner(kWhole, "learner.toml");
    ASSERT_TRUE(learner);
    EXPECT_TRUE(learner->allows(Purpose::Record, "2027-11-24"));
    EXPECT_FALSE(learner->allows(Purpose::Record, "2027-11-25"));
    EXPECT_FALSE(learner->allows(Purpose::Remember, "2026-11-24"));
    EXPECT_FALSE(learner->allows(Purpose::Share, "2026-11-24"));
}

TEST(Learner, is_saved_with_all_unknown_keys) {
    auto learner = read_learner(kWhole, "learner.toml");
    ASSERT_TRUE(learner);
    learner->consent(Purpose::Record)->until = "2028-01-01";
    learner->consent(Purpose::Remember) = Consent{"2026-12-01", "", ""};
    const auto text = text_of(*learner, kWhole, "learner.toml");
    ASSERT_TRUE(text) << text.error().sentence();
    for (const char* kept : {"cane", "witness", "research"}) EXPECT_NE(text->find(kept), std::string::npos) << *text;
    const auto again = read_learner(*text, "learner.toml");
    ASSERT_TRUE(again);
    EXPECT_EQ(again->consent(Purpose::Record)->until, "2028-01-01");
    EXPECT_EQ(again->consent(Purpose::Remember)->given, "2026-12-01");
    EXPECT_EQ(again->name, learner->name);
}

TEST(Learner, withdrawal_of_consent_leaves_no_trace_of_it) {
    auto learner = read_learner(kWhole, "learner.toml");
    ASSERT_TRUE(learner);
    learner->consent(Purpose::Record).reset();
    const auto text = text_of(*learner, kWhole, "learner.toml");
    ASSERT_TRUE(text);
    EXPECT_EQ(text->find("record"), std::string::npos) << *text;
}

// Each row contains a damaged file, the line in which the fault must be reported, and part of the message.
TEST(Learner, file_that_is_damaged_is_refused_with_file_and_line) {
    struct Row {
        const char* text;
        int line;
        const char* says;
    };
    for (const Row& row : {Row{"created = \"2026-11-24\"\n", 1, "name"}, Row{"name = \"x\"\nname = \"y\"\n", 2, "TOML"},
                           Row{"name = 3\n", 1, "quotation"}, Row{"name = \"x\"\n\ncreated = \"today\"\n", 3, "a date"},
                           Row{"name = \"x\"\n[consent.record]\nby = \"y\"\n", 2, "the date"},
                           Row{"name = \"x\"\n[consent.record]\ngiven = \"2026-02-30\"\n", 3, "2026-02-30"},
                           Row{"name = \"x\"\nconsent = 1\n", 2, "table"}, Row{"name = \"a/b\"\n", 1, "slash"}}) {
        const auto learner = read_learner(row.text, "learner.toml");
        ASSERT_FALSE(learner) << row.text;
        EXPECT_EQ(learner.error().file, "learner.toml");
        EXPECT_EQ(learner.error().line, row.line) << row.text;
        EXPECT_NE(learner.error().message.find(row.says), std::string::npos) << learner.error().message;
    }
}

TEST(Learner, cut_at_every_byte_is_refused_or_consents_to_no_more_than_before) {
    for (std::size_t length = 0; length < kWhole.size(); ++length) {
        const auto learner = read_learner(kWhole.substr(0, length), "learner.toml");
        if (!learner) {
            EXPECT_FALSE(learner.error().message.empty()) << length;
            continue;
        }
        EXPECT_TRUE(std::string("Maple Heron").starts_with(learner->name)) << length;
        for (const Purpose purpose : {Purpose::Remember, Purpose::Share})
            EXPECT_FALSE(learner->allows(purpose, "2026-11-24")) << length;
    }
}

TEST(Learner, dates_are_those_of_the_calendar) {
    EXPECT_TRUE(is_day("2028-02-29"));
    for (const char* none : {"2026-02-29", "2026-13-01", "2026-1-01", "26-01-01", "2026-01-01T", "", "2026/01/01"})
        EXPECT_FALSE(is_day(none)) << none;
    EXPECT_TRUE(is_day(today()));
}

TEST(Learner, suggestions_are_4096_names_per_language_that_never_look_like_real_names) {
    for (const char* language : {"en", "de"}) {
        const test::InLanguage spoken(language);
        std::set<std::string> names;
        for (std::uint32_t i = 0; i < 64 * 64; ++i) {
            const std::string name = offered_name(i);
            names.insert(name);
            EXPECT_FALSE(may_be_real(name)) << name;
            EXPECT_TRUE(good_learner_name(name)) << name;
        }
        EXPECT_EQ(names.size(), 64U * 64U) << language;
    }
    EXPECT_TRUE(may_be_real("Anna Schmidt"));
    EXPECT_TRUE(may_be_real("Anna von Berg Österreich"));
    EXPECT_FALSE(may_be_real("the tall one"));
    EXPECT_FALSE(may_be_real("Kim"));
}

}  // namespace learner_test
}  // namespace handrail
