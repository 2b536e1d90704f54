// Tests cards with directions: their lines, pages and contents.
#include "worlds/exports/route_card.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

namespace handrail::test {
namespace route_card_test {

TEST(RouteCard, in_print_breaks_lines_at_blanks_and_indents_continuation_lines) {
    EXPECT_EQ(card_text({{"From the base to Kitchen.", "28 steps in all. Turn slightly left. 14 steps to Front door."},
                         {"Ü."}}),
              "From the base to Kitchen.\n28 steps in all. Turn slightly left. 14\n  steps to Front door.\n\nÜ.\n");
}

TEST(RouteCard, in_braille_starts_a_page_for_each_route_and_after_25_lines) {
    const Result<std::string> one = card_brf({{"one", "two"}, {"three"}}, BrailleTable::EnUebG1);
    ASSERT_TRUE(one);
    EXPECT_EQ(*one, "ONE\r\nTWO\r\n\fTHREE\r\n");
    const Result<std::string> full = card_brf({CardRoute(26, "a")}, BrailleTable::EnUebG1);
    ASSERT_TRUE(full);
    EXPECT_EQ(full->find('\f'), 25U * 3U);
    EXPECT_EQ(std::count(full->begin(), full->end(), '\f'), 1);
}

}  // namespace route_card_test
}  // namespace handrail::test
