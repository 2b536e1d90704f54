// Tests that a thing has the same place and the same distance in the answers to all questions: exits, where am I, what
// is ahead, the list of all things and the routes to rooms. The test runs in every room of the house and the school.
#include <gmock/gmock.h>

#include <map>
#include <regex>
#include <set>

#include "tests/support/every.h"
#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace one_place_test {

using test::AppSession;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// Calls `each` in the middle of each room, with a different heading each time.
template <class Each>
void in_every_room(const char* world, Each each) {
    AppSession s;
    s.app.apply(WorldEntered{make_ready(test::our_world(world))}, 0.0);
    s.run(0.1);
    s.request(Command::Exits);
    s.run(0.1);
    const auto rooms = s.app.view({}).rooms;
    ASSERT_TRUE(rooms);
    double heading_rad = 0.0;
    for (const DrawnRoom& room : *rooms) {
        s.app.apply(Placed{room.middle_m, heading_rad += 5.0 * kPi / 8.0}, s.now);
        s.run(0.1);
        each(s);
    }
}

// Returns a map from names to places, such as "Study door" to "3 steps, half right", for exits whose name occurs once.
std::map<std::string, std::string> exits_announced(AppSession& s) {
    std::map<std::string, std::string> listed;
    std::set<std::string> twice;
    std::string text = s.request(Command::Exits);
    for (std::size_t at = text.find(". "); at != std::string::npos;) {
        const std::size_t next = text.find(". ", at + 2);
        std::string one = text.substr(at + 2, next == std::string::npos ? next : next - at - 2);
        if (one.ends_with('.')) one.pop_back();
        at = next;
        const std::size_t colon = one.find(": ");
        if (colon == std::string::npos) continue;
        const std::string name = one.substr(0, one.substr(0, colon).find(" to "));
        if (!listed.emplace(name, one.substr(colon + 2)).second) twice.insert(name);
    }
    for (const std::string& name : twice) listed.erase(name);
    return listed;
}

std::map<std::string, std::string> list_announced(AppSession& s, Command command) {
    s.request(command);
    // A long list begins with kinds.
    if (s.app.dialogue().has_use_for(phrase("kinds.everything"))) s.line(phrase("kinds.everything"));
    std::map<std::string, std::string> listed;
    for (const ListItem& item : s.app.dialogue().view().items) listed.emplace(item.name, item.value);
    while (s.app.dialogue().is_open()) s.app.apply(KeyTapped{"Escape"}, s.now);
    s.listen();
    return listed;
}

TEST(OnePlace, of_a_door_is_the_same_in_exits_where_ahead_and_the_find_list) {
    for (const char* world : {"house.map", "school.map"}) {
        int in_list = 0, seen = 0, where = 0;
        in_every_room(world, [&](AppSession& s) {
            const auto exits = exits_announced(s);
            const auto things = list_announced(s, Command::Find);
            const std::string ahead = s.request(Command::AheadOfMe), here = s.request(Command::WhereAmI);
            for (const auto& [name, place] : exits) {
                if (name.find("door") == std::string::npos && name.find("Door") == std::string::npos) continue;
                if (const auto thing = things.find(name); thing != things.end()) {
                    EXPECT_THAT(thing->second, StartsWith(place)) << world << ": " << name << ", " << here;
                    ++in_list;
                }
                if (ahead.find(name + ", ") != std::string::npos) {
                    EXPECT_THAT(ahead, HasSubstr(name + ", " + place)) << world << ": " << here;
                    ++seen;
                }
                if (here.find(name + " to ") != std::string::npos) {
                    EXPECT_THAT(here, HasSubstr(": " + place)) << world << ": " << name;
                    ++where;
                }
            }
        });
        EXPECT_GT(in_list, 10) << world;
        EXPECT_GT(seen, 0) << world;
        EXPECT_GT(where, 10) << world;
    }
}

TEST(OnePlace, of_a_thing_in_another_room_has_the_walking_distance_and_says_so) {
    int on_foot = 0, straight = 0;
    in_every_room("house.map", [&](AppSession& s) {
        const Vec3 waist_m = s.app.feet_m() + Vec3(0.0, 0.0, 1.0);
        for (const auto& [name, value] : list_announced(s, Command::Find)) {
            const bool listed = value.find(" on foot") != std::string::npos;
            ++(listed ? on_foot : straight);
            if (!listed) continue;
            // The value also contains the room, unless thing and room have the same name. No walking route is shorter
            // than the straight line, apart from rounding to five steps.
            EXPECT_GE(std::count(value.begin(), value.end(), ','), name == "Pond" ? 1 : 2) << name << ": " << value;
            const auto things = named_things(*s.app.scene());
            double nearest_m = 1e9;
            for (const NamedThing& thing : things)
                if (sentence_case(thing.name) == name)
                    nearest_m = std::min(nearest_m, glm::length(nearest_place(thing.bounds_m, waist_m) - waist_m));
            const std::size_t number_ends = value.find(" step");
            ASSERT_NE(number_ends, std::string::npos) << value;
            const double steps = std::stod(value.substr(number_ends < 2 ? 0 : number_ends - 2));
            if (nearest_m < 1e9) {
                EXPECT_GE((steps + 3.0) * 0.65, nearest_m - 1.0) << name << ": " << value;
            }
        }
    });
    EXPECT_GT(on_foot, 100);
    EXPECT_GT(straight, 50);
}

// Returns the length of the announced route in steps, or no value if no length was announced. The legs count the stairs
// of a flight apart from the steps; two of them are about as long as a step.
std::optional<double> steps_in_all(const std::vector<std::string>& said) {
    static const std::regex length("([0-9]+) steps?(?: and ([0-9]+) stairs?)? in all");
    std::smatch found;
    for (const std::string& text : said)
        if (std::regex_search(text, found, length))
            return std::stod(found[1]) + (found[2].matched ? 0.5 * std::stod(found[2]) : 0.0);
    return std::nullopt;
}

TEST(OnePlace, of_a_room_has_about_the_distance_of_its_route_and_its_storey_in_the_route_list) {
    for (const char* world : {"house.map", "school.map"}) {
        if (test::kSanitizerScale < 1.0 && world == std::string_view("school.map")) continue;
        // The school has many routes, so each run tries only some of them.
        const int every_way = world == std::string_view("school.map") ? 5 * static_cast<int>(test::every(3, 3)) : 5;
        int rooms = 0, ways = 0, other_storeys = 0;
        in_every_room(world, [&](AppSession& s) {
            if (++rooms % 6 != 0) return;
            const auto listed = list_announced(s, Command::Routes);
            int one = 0;
            for (const auto& [name, value] : listed) {
                other_storeys += value.find("storey") != std::string::npos ? 1 : 0;
                if (value.find("step") == std::string::npos || ++one % every_way != 0) continue;
                s.said.clear();
                s.request(Command::Routes);
                s.line(name);
                s.run(0.1);
                const auto announced = steps_in_all(s.said);
                EXPECT_TRUE(announced || s.heard("No walking route")) << name << ": " << s.news();
                if (announced) {
                    EXPECT_NEAR(*announced, std::stod(value), 4.0 + 0.25 * std::stod(value))
                        << name << ": " << s.news();
                    ++ways;
                }
                s.request(Command::Routes);
                s.line("stop following");
            }
        });
        EXPECT_GT(ways, 2) << world;
        EXPECT_GT(other_storeys, 2) << world;
    }
}

}  // namespace one_place_test
}  // namespace handrail
