// Tests the summary of a route, and the leaps from leg to leg along it.
#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/unit/core/in_the_house.h"

namespace handrail {
namespace route_leaps_test {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

struct RoutesOfTheHouse : test::InTheHouse {
    std::string room() {
        const std::string where = request(Command::WhereAmI);
        return where.substr(0, where.find(','));
    }
};

TEST(RouteSummary, counts_turns_doors_and_storeys_in_the_sentence_of_the_length) {
    RoutesOfTheHouse s;
    s.line("route bedroom");
    s.run(0.2);
    EXPECT_THAT(s.news(), ContainsRegex("About [0-9]+ steps in all: [^.]*[0-9]+ turns, [^.]*one storey up[.] "));
}

TEST(RouteSummary, of_a_route_on_one_storey_counts_doors_and_no_storeys) {
    RoutesOfTheHouse s;
    s.line("route kitchen");
    s.run(0.2);
    const std::string said = s.news();
    EXPECT_THAT(said, ContainsRegex("steps in all[^.]*: [^.]*(one door|[0-9]+ doors)[.] "));
    EXPECT_THAT(said, Not(HasSubstr("storey")));
}

TEST(LeapsAlongARoute, lead_leg_by_leg_to_the_goal_and_give_the_next_leg) {
    RoutesOfTheHouse s;
    s.line("route kitchen");
    s.run(0.2);
    std::string before = s.request(Command::RepeatLeg);
    int leaps = 0;
    while (s.app.guide().leads() && leaps < 12) {
        const Vec3 from_m = s.app.feet_m();
        const std::string there = s.request(Command::LeapNext);
        ++leaps;
        EXPECT_GT(glm::length(s.app.feet_m() - from_m), 0.3) << there;
        EXPECT_THAT(there, HasSubstr(", facing ")) << there;
        s.run(0.2);
    }
    EXPECT_FALSE(s.app.guide().leads()) << s.news();
    EXPECT_EQ(s.room(), "Kitchen");
    EXPECT_GE(leaps, 2);
}

TEST(LeapsAlongARoute, are_taken_back_one_by_one_and_the_route_goes_on_from_there) {
    RoutesOfTheHouse s;
    s.line("route bedroom");
    s.run(0.2);
    const Vec3 begin_m = s.app.feet_m();
    const std::string first = s.request(Command::RepeatLeg);
    s.request(Command::LeapNext);
    const Vec3 second_m = s.app.feet_m();
    s.request(Command::LeapNext);
    ASSERT_GT(glm::length(s.app.feet_m() - second_m), 0.3);
    s.request(Command::LeapLast);
    s.run(0.2);
    EXPECT_LT(glm::length(s.app.feet_m() - second_m), 0.05);
    s.request(Command::LeapLast);
    s.run(0.2);
    EXPECT_LT(glm::length(s.app.feet_m() - begin_m), 0.05);
    EXPECT_EQ(s.request(Command::RepeatLeg), first);
    EXPECT_TRUE(s.app.guide().leads());
}

TEST(LeapsAlongARoute, are_leaps_to_things_as_before_if_no_route_is_followed) {
    RoutesOfTheHouse s;
    EXPECT_THAT(s.request(Command::LeapNext), StartsWith("Now at "));
}

}  // namespace route_leaps_test
}  // namespace handrail
