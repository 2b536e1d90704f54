// Tests that lists of large places begin with the kinds of their entries.
#include <gmock/gmock.h>

#include "app/core/context/kinds_first.h"
#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"
#include "tests/unit/osm/drawing.h"

namespace handrail {
namespace long_lists_test {

using test::AppSession;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// Makes a building of two storeys, each with a corridor and `rooms` rooms along it.
std::shared_ptr<const Scene> building_with(int rooms) {
    test::Drawing drawing;
    for (const auto& [level, mark] : {std::pair("0", 'G'), std::pair("1", 'U')}) {
        drawing.box(0, 0, 3.0 * rooms, 2,
                    {{"indoor", "corridor"}, {"level", level}, {"name", fmt::format("Corridor {}", mark)}});
        for (int r = 1; r <= rooms; ++r) {
            const double west_m = 3.0 * (r - 1);
            drawing.box(west_m, 2, west_m + 3, 6,
                        {{"indoor", "room"}, {"level", level}, {"name", fmt::format("Room {}{}", mark, 100 + r)}});
            drawing.node(west_m + 1.5, 2,
                         {{"door", "hinged"}, {"level", level}, {"name", fmt::format("Gate {}{}", mark, 100 + r)}});
        }
        drawing.node(2, 1, {{"amenity", "bench"}, {"level", level}, {"name", "Bench"}});
    }
    drawing.node(1.5, 0, {{"door", "hinged"}, {"level", "0"}, {"entrance", "main"}});
    return std::make_shared<const Scene>(drawing.scene());
}

struct Visitor : AppSession {
    explicit Visitor(int rooms) {
        app.apply(WorldEntered{make_ready(building_with(rooms))}, 0.0);
        run(0.1);
        request(Command::Exits);
        run(0.1);
    }
    std::vector<std::string> names(Command command) {
        request(command);
        return shown();
    }
    std::vector<std::string> shown() const {
        std::vector<std::string> names;
        for (const ListItem& item : app.dialogue().view().items) names.push_back(item.name);
        return names;
    }
};

TEST(LongLists, of_more_than_fifty_entries_begin_with_kinds_and_shorter_ones_do_not) {
    for (const int rooms : {5, 40}) {
        Visitor s(rooms);
        for (const Command command : {Command::Routes, Command::Describe}) {
            const std::vector<std::string> names = s.names(command);
            if (rooms == 5) {
                EXPECT_THAT(names, Contains("Room G101"));
            } else {
                EXPECT_LE(names.size(), 5U);
                EXPECT_THAT(names, Contains("Everything"));
                EXPECT_THAT(names, testing::Not(Contains("Room G101")));
            }
            s.app.apply(KeyTapped{"Escape"}, s.now);
            s.run(0.1);
            EXPECT_FALSE(s.app.dialogue().is_open());
        }
    }
}

TEST(LongLists, open_a_kind_and_return_to_the_kinds) {
    Visitor s(40);
    const std::vector<std::string> kinds = s.names(Command::Describe);
    EXPECT_THAT(kinds, ElementsAre(testing::_, "Level 0", "Level 1", "Everything"))
        << "the room of the person comes first";
    s.line("level 1");
    EXPECT_THAT(s.shown(), Contains("Room U140"));
    EXPECT_THAT(s.shown(), testing::Not(Contains("Room G101")));
    s.app.apply(KeyTapped{"Escape"}, s.now);
    EXPECT_EQ(s.shown(), kinds);
    s.line("everything");
    EXPECT_EQ(s.shown().size(), 83U) << "with the ground outside";
    EXPECT_THAT(s.line("room u140"), StartsWith("Room U140: "));
    EXPECT_FALSE(s.app.dialogue().is_open());
}

TEST(LongLists, choose_any_entry_by_its_typed_name) {
    Visitor s(40);
    s.request(Command::Describe);
    EXPECT_TRUE(s.app.dialogue().has_use_for("room u140"));
    EXPECT_FALSE(s.app.dialogue().has_use_for("Room U141"));
    EXPECT_THAT(s.line("room g139"), StartsWith("Room G139: "));
    EXPECT_FALSE(s.app.dialogue().is_open());
    s.request(Command::Routes);
    EXPECT_THAT(s.line("Room G139"), HasSubstr("Room G139"));
    // Numbers choose among the kinds.
    const std::vector<std::string> kinds = s.names(Command::Describe);
    EXPECT_THAT(s.line("1"), StartsWith(kinds[0]));
    EXPECT_FALSE(s.app.dialogue().is_open());
}

TEST(LongLists, show_all_entries_when_letters_of_one_are_typed) {
    Visitor s(40);
    s.request(Command::Describe);
    for (const char* letters : {"r", "o", "o", "m", " ", "u", "1", "4"}) s.app.apply(TextTyped{letters}, s.now);
    EXPECT_EQ(s.shown()[s.app.dialogue().view().at], "Room U140");
    s.app.apply(KeyTapped{"Enter"}, s.now);
    s.listen();
    EXPECT_THAT(s.said.back(), StartsWith("Room U140: "));
    EXPECT_FALSE(s.app.dialogue().is_open());
}

TEST(LongLists, of_things_begin_with_kinds_that_lead_to_each_thing) {
    Visitor s(60);
    const std::vector<std::string> kinds = s.names(Command::Find);
    EXPECT_THAT(kinds, Contains("Doors"));
    EXPECT_THAT(kinds, Contains("Everything"));
    EXPECT_LE(kinds.size(), 6U);
    s.line("doors");
    EXPECT_GT(s.shown().size(), kMostEntries);
    const std::string name = s.shown()[3];
    s.line(name);
    ASSERT_TRUE(s.app.dialogue().is_open()) << "the list of ways to go there";
    EXPECT_EQ(s.app.dialogue().view().title, name);
}

}  // namespace long_lists_test
}  // namespace handrail
