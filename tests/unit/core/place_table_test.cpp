// Tests the table of all places.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/support/names.h"
#include "tests/unit/core/in_the_house.h"

namespace handrail {
namespace place_table_test {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::StartsWith;

struct PlacesOfTheHouse : test::InTheHouse {
    std::vector<std::string> table(const std::string& line_typed) {
        said.clear();
        line(line_typed);
        EXPECT_FALSE(app.dialogue().is_open());
        return std::exchange(said, {});
    }
};

std::string name_in(const std::string& line) { return line.substr(0, line.find(':')); }
std::string field(const std::string& line, int which) {
    std::string rest = line.substr(line.find(": ") + 2);
    for (int i = 0; i < which; ++i) rest = rest.substr(rest.find(", ") + 2);
    return rest.substr(0, rest.find_first_of(",."));
}

TEST(PlaceTable, has_one_line_for_each_place_in_the_order_that_is_typed) {
    PlacesOfTheHouse s;
    const std::vector<std::string> by_name = s.table("places by name");
    ASSERT_GT(by_name.size(), 30U);
    EXPECT_THAT(by_name, Contains(StartsWith("Sofa: landmark, Living room, ")));
    EXPECT_THAT(by_name, Contains(StartsWith("Kitchen: room, ")));
    EXPECT_THAT(by_name, Contains(StartsWith("Garden door: door, ")));
    EXPECT_TRUE(std::is_sorted(by_name.begin(), by_name.end(), [](const auto& a, const auto& b) {
        std::string one = name_in(a), other = name_in(b);
        for (std::string* name : {&one, &other})
            std::transform(name->begin(), name->end(), name->begin(), [](unsigned char c) { return std::tolower(c); });
        return one < other;
    }));
    const std::vector<std::string> by_kind = s.table("places by kind");
    EXPECT_EQ(by_kind.size(), by_name.size());
    EXPECT_EQ(field(by_kind.front(), 0), "room");
    EXPECT_NE(field(by_kind.back(), 0), "room");
    const std::vector<std::string> by_room = s.table("places by room");
    std::vector<std::string> rooms;
    for (const std::string& line : by_room)
        if (field(line, 0) == "thing" && (rooms.empty() || rooms.back() != field(line, 1)))
            rooms.push_back(field(line, 1));
    std::vector<std::string> once = rooms;
    std::sort(once.begin(), once.end());
    once.erase(std::unique(once.begin(), once.end()), once.end());
    EXPECT_EQ(rooms.size(), once.size()) << "each room is one block";
    EXPECT_EQ(name_in(s.table("places by distance").front()), "Hall");
}

TEST(PlaceTable, is_a_list_from_which_a_room_or_a_thing_is_chosen) {
    PlacesOfTheHouse s;
    s.request(Command::Places);
    ASSERT_TRUE(s.app.dialogue().is_open());
    EXPECT_THAT(s.line("kitchen"), StartsWith("To Kitchen. "));
    s.line("places sofa");
    ASSERT_TRUE(s.app.dialogue().is_open());
    EXPECT_EQ(s.app.dialogue().view().title, "Sofa");
}

}  // namespace place_table_test
}  // namespace handrail
