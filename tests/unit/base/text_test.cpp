#include "worlds/base/text.h"
#include "tests/support/names.h"
#include "worlds/base/markup.h"

namespace handrail {
namespace text_test {

TEST(NearestName, finds_the_closest_spelling_and_the_first_of_equals) {
    const std::vector<std::string> names{"plaster", "wood", "word"};
    EXPECT_EQ(nearest_name("Plastre", names), "plaster");
    EXPECT_EQ(nearest_name("wo", names), "wood");
    EXPECT_EQ(nearest_name("x", {}), "");
}

TEST(NearestKey, is_in_the_same_table_if_that_table_has_a_similar_key) {
    const std::vector<std::string> keys{"sound.volume", "speech.rate", "speech.voice", "keys.where"};
    EXPECT_EQ(nearest_key("speech.volume", keys), "speech.voice");
    EXPECT_EQ(nearest_key("Speech.rate", keys), "speech.rate");
    EXPECT_EQ(nearest_key("sond.volume", keys), "sound.volume");
    EXPECT_EQ(nearest_key("where", keys), "keys.where");
    EXPECT_EQ(nearest_key("speech.x", {}), "");
}

TEST(ParseFinite, accepts_only_complete_numbers_and_refuses_nan_and_infinity) {
    double value = 7.0;
    EXPECT_TRUE(parse_finite("+1.5e2", value));
    EXPECT_EQ(value, 150.0);
    EXPECT_TRUE(parse_finite("3.", value));
    EXPECT_TRUE(parse_finite("-0", value));
    for (const char* bad : {"", "nan", "inf", "1e999", "1,5", "12x", "--1", "+-1", " 1"})
        EXPECT_FALSE(parse_finite(bad, value)) << bad;
}

TEST(TakeNumber, parses_a_leading_number_and_reports_when_it_exceeds_the_range_of_a_double) {
    struct Row {
        std::string_view text, rest;
        double value;
        bool in_range, exponent;
    };
    const double largest = std::numeric_limits<double>::max();
    for (const Row& row : {Row{"2.5;3", ";3", 2.5, true, true}, Row{"+1e3x", "x", 1000.0, true, true},
                           Row{"1e3x", "e3x", 1.0, true, false}, Row{"-1e999 ", " ", -largest, false, true},
                           Row{"1e-999", "", 0.0, false, true}, Row{"inf", "", HUGE_VAL, true, true}}) {
        std::string_view text = row.text;
        const auto taken = take_number(text, row.exponent);
        ASSERT_TRUE(taken) << row.text;
        EXPECT_EQ(taken->value, row.value) << row.text;
        EXPECT_EQ(taken->in_range, row.in_range) << row.text;
        EXPECT_EQ(text, row.rest) << row.text;
    }
    for (std::string_view none : {"", "x", "+-1", "- 1"}) {
        const std::string_view before = none;
        EXPECT_FALSE(take_number(none)) << before;
        EXPECT_EQ(none, before);
    }
}

TEST(LowerAscii, does_not_change_bytes_beyond_ascii) { EXPECT_EQ(lower_ascii("AbZ\xC3\x89[`"), "abz\xC3\x89[`"); }

TEST(IsUtf8, accepts_every_valid_length_and_refuses_every_kind_of_damage) {
    for (const char* good :
         {"", "plain", "\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x98\x80", "\xED\x9F\xBF", "\xF4\x8F\xBF\xBF"})
        EXPECT_TRUE(is_utf8(good)) << good;
    // Kinds of damage: a stray continuation byte, cut-off and overlong forms, a surrogate, a code above U+10FFFF, and
    // bytes that never occur in UTF-8.
    for (const char* bad : {"\x80", "\xC3", "\xE2\x82", "a\xF0\x9F\x98", "\xC3(", "\xC0\xAF", "\xE0\x80\xAF",
                            "\xF0\x80\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xFE", "\xFF"})
        EXPECT_FALSE(is_utf8(bad)) << testing::PrintToString(std::string(bad));
}

TEST(OneLine, removes_only_unspeakable_characters_and_terminal_controls) {
    EXPECT_EQ(one_line("T\xC3\xBCr, \xE2\x82\xAC 5, \xC2\xA0x"), "T\xC3\xBCr, \xE2\x82\xAC 5, \xC2\xA0x");
    EXPECT_EQ(one_line(std::string("a\0b\n\tc\x1B[2J\x7F", 11)), "a b  c [2J ");
    EXPECT_EQ(one_line("a\xC2\x9Bz"), "a z");  // the single character U+009B also begins a terminal escape sequence
    EXPECT_EQ(one_line("\xFFx\xC3"), "\xEF\xBF\xBDx\xEF\xBF\xBD");
    EXPECT_EQ(one_line(""), "");
}

// After a U+202E in a name, terminals and pages would show everything that follows backwards.
TEST(OneLine, and_text_for_pages_contain_no_direction_controls) {
    for (const char* control : {"\u061c", "\u200e", "\u200f", "\u202a", "\u202b", "\u202c", "\u202d", "\u202e",
                                "\u2066", "\u2067", "\u2068", "\u2069"}) {
        EXPECT_EQ(one_line(std::string("a") + control + "b" + control), "ab");
        EXPECT_EQ(markup_text(std::string("a") + control + "<" + control), "a&lt;");
    }
    for (const char* kept :
         {"\u061b", "\u200d", "\u2010", "\u202f", "\u2065", "\u206a", "\u05d0\u05d1", "\xd8", "\xe2\x80"}) {
        EXPECT_EQ(markup_text(kept), kept);
        EXPECT_FALSE(begins_with_direction_control(kept));
    }
    EXPECT_EQ(one_line("a\u2028b\u2029c"), "a b c");
}

// The reference for the comparison: the textbook recursion without optimisation.
std::size_t plain_distance(std::string_view a, std::string_view b) {
    if (a.empty() || b.empty()) return a.size() + b.size();
    return std::min({plain_distance(a.substr(1), b) + 1, plain_distance(a, b.substr(1)) + 1,
                     plain_distance(a.substr(1), b.substr(1)) + (a[0] == b[0] ? 0U : 1U)});
}

TEST(NearestName, agrees_with_a_simple_recursive_algorithm_on_all_short_words) {
    std::vector<std::string> words{""};
    for (std::size_t i = 0; i < 40; ++i)
        for (const char c : {'a', 'b', 'c'}) words.push_back(words[i] + c);
    for (const std::string& word : words) {
        const std::vector<std::string> others(words.begin() + 1, words.begin() + 40);
        std::size_t best = 100;
        for (const std::string& other : others) best = std::min(best, plain_distance(word, other));
        ASSERT_EQ(plain_distance(word, nearest_name(word, others)), best) << word;
    }
}

}  // namespace text_test
}  // namespace handrail
