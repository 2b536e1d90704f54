#include "worlds/base/text.h"

namespace handrail {
namespace {

TEST(NearestName, finds_the_closest_spelling_and_keeps_the_first_of_equals) {
    const std::vector<std::string> names{"plaster", "wood", "word"};
    EXPECT_EQ(nearest_name("Plastre", names), "plaster");
    EXPECT_EQ(nearest_name("wo", names), "wood");
    EXPECT_EQ(nearest_name("x", {}), "");
}

TEST(ParseFinite, takes_whole_numbers_only_and_refuses_nan_and_infinity) {
    double value = 7.0;
    EXPECT_TRUE(parse_finite("+1.5e2", value));
    EXPECT_EQ(value, 150.0);
    EXPECT_TRUE(parse_finite("3.", value));
    EXPECT_TRUE(parse_finite("-0", value));
    for (const char* bad : {"", "nan", "inf", "1e999", "1,5", "12x", "--1", " 1"}) EXPECT_FALSE(parse_finite(bad, value)) << bad;
}

}  // namespace
}  // namespace handrail
