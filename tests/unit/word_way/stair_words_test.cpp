// Tests that a walker who only hears announcements can climb stairs of each form by following the announcements with
// the keys, and can come down again.
#include "tests/support/names.h"
#include "tests/support/stair_house.h"
#include "tests/support/word_walker.h"

namespace handrail {
namespace stair_words_test {

class StairWords : public testing::TestWithParam<test::StairForm> {};

TEST_P(StairWords, lead_up_to_the_gallery_and_down_to_the_hall) {
    const test::StairHouse house(GetParam());
    test::WordWalker walker(house.share());
    for (const auto& [room, goal_m] : {std::pair("Gallery", house.gallery_m()), std::pair("Hall", house.hall_m())}) {
        EXPECT_EQ(walker.go(room), test::WordWalker::End::Arrived) << room << '\n' << walker.last_lines(12);
        EXPECT_NEAR(walker.feet_m().z, goal_m.z, 0.05) << room << '\n' << walker.last_lines(40);
        EXPECT_EQ(walker.climbs(), 0) << room << ": nothing is taken in one go\n" << walker.last_lines(12);
    }
}

INSTANTIATE_TEST_SUITE_P(OfEachForm, StairWords, testing::ValuesIn(test::kStairForms),
                         [](const testing::TestParamInfo<test::StairForm>& form) {
                             std::string name = test::form_name(form.param);
                             std::replace(name.begin(), name.end(), ' ', '_');
                             return name;
                         });

}  // namespace stair_words_test
}  // namespace handrail
