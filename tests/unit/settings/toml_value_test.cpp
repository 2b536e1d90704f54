// Tests TOML files as plain values. The values must equal those that toml++ reads. After writing, they must read back
// unchanged.
#include "settings/toml_value.h"
#include "tests/support/names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace handrail {
namespace toml_value_test {

using testing::HasSubstr;

const std::string kAllKinds = R"(flag = true
whole = -7
fraction = 0.1
not_a_number = nan
text = "Zażółć \"家\"\n\u0007"
day = 1979-05-27
time = 07:32:00.5
moment = 1979-05-27T07:32:00
moment_there = 1979-05-27T07:32:00-07:30
mixed = [1, [2.5, []], "x", {k = {deep = 1}}]
braces = {a = 1}
empty = []
[table.within]
key = 1
[[list]]
name = "first"
  [[list.of]]
  at = [1.0, 2.0]
[[list]]
)";

TEST(TomlValue, of_a_file_contains_every_value_with_its_line) {
    const auto read = toml_of(kAllKinds);
    ASSERT_TRUE(read) << read.error().sentence();
    const TomlValue& root = *read;
    EXPECT_TRUE(*root.find("flag")->flag());
    EXPECT_EQ(*root.find("whole")->whole(), -7);
    EXPECT_EQ(root.find("whole")->number(), -7.0);
    EXPECT_EQ(*root.find("fraction")->fraction(), 0.1);
    EXPECT_TRUE(std::isnan(*root.find("not_a_number")->number()));
    EXPECT_EQ(*root.find("text")->text(), "Zażółć \"家\"\n\a");
    EXPECT_EQ(root.find("text")->line, 5);
    EXPECT_EQ(root.find("text")->column, 8);
    EXPECT_EQ(std::get<TomlMoment>(root.find("moment_there")->value).offset_minutes, -450);
    EXPECT_FALSE(std::get<TomlMoment>(root.find("moment")->value).has_offset);
    EXPECT_FALSE(std::get<TomlMoment>(root.find("day")->value).has_time);
    EXPECT_EQ(std::get<TomlMoment>(root.find("time")->value).nanosecond, 500'000'000U);
    EXPECT_EQ(root.find("mixed")->array()->size(), 4U);
    EXPECT_TRUE(root.find("braces")->in_line);
    EXPECT_FALSE(root.find("empty")->is_tables());
    EXPECT_EQ(*root.find("table")->find("within")->find("key")->whole(), 1);
    ASSERT_TRUE(root.find("list")->is_tables());
    EXPECT_EQ(root.find("list")->array()->at(1).line, 19);
    EXPECT_EQ(root.find("missing"), nullptr);
    EXPECT_EQ(root.find("flag")->find("of no table"), nullptr);
}

TEST(TomlValue, is_read_back_as_it_was_written) {
    const TomlValue read = toml_of(kAllKinds).value();
    const std::string text = written_toml(read);
    const auto again = toml_of(text);
    ASSERT_TRUE(again) << again.error().sentence() << text;
    EXPECT_TRUE(*again == read) << text;
    EXPECT_THAT(text, HasSubstr("braces = { a = 1 }"));
    EXPECT_THAT(text, HasSubstr("[[list.of]]"));
    TomlValue other = read;
    other.erase("flag");
    EXPECT_FALSE(other == read);
    other.set("flag", *read.find("flag"));
    EXPECT_TRUE(other == read) << "keys are in order, whatever came last";
    other.set("flag", TomlValue::empty_table());
    EXPECT_FALSE(other == read);
}

TEST(TomlValue, of_a_damaged_file_is_an_error_with_its_place) {
    const auto damaged = toml_of("a = 1\nb = = 2\n");
    ASSERT_FALSE(damaged);
    EXPECT_EQ(damaged.error().line, 2);
    EXPECT_GT(damaged.error().column, 0);
    EXPECT_FALSE(damaged.error().message.empty());
}

// toml++ limits the depth of brackets, but not the number of names in a dotted key.
TEST(TomlValue, with_too_deeply_nested_tables_is_refused) {
    std::string key = "\n[a";
    for (int i = 1; i < 2000; ++i) key += ".a";
    const auto deep = toml_of(key + "]\nx = 1\n");
    ASSERT_FALSE(deep);
    EXPECT_EQ(deep.error().line, 2);
    EXPECT_THAT(deep.error().message, HasSubstr("deep"));
}

}  // namespace toml_value_test
}  // namespace handrail
