// Tests a newcomer with keys and ears only, in worlds that were not made for this test.
#include "tests/unit/core/newcomer.h"

#include <cstdlib>
#include <regex>
#include <set>

#include "app/core/scenario/session_log.h"
#include "tests/support/names.h"
#include "tests/support/office_ifc.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/worlds_once.h"
#include "tests/unit/core/app_session.h"
#include "tests/unit/core/hall_with_lift.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace newcomer_test {

using test::direction_in;
using test::Newcomer;

std::shared_ptr<const Scene> real(const std::string& name) {
    const auto path = test::real_world(name);
    if (!path) return nullptr;
    return test::world_once(*path);
}

// Returns "Corridor, 6 by 26 metres, south" for "Corridor, 6 by 26 metres, south, 35 steps".
std::string name_of(const std::string& entry) { return entry.substr(0, entry.rfind(", ")); }

// Returns the name of a room in the list of routes that contains this word.
std::string room_with(Newcomer& n, const std::string& word) {
    // The announcement that the rooms are known would come between the entries, so the list is read once before that.
    (void)n.entries("Shift+4");
    for (const std::string& room : n.entries("Shift+4"))
        if (room.find(word) != std::string::npos) return name_of(room);
    return {};
}

TEST(ANewcomer, walks_through_the_first_tutorial_map_from_start_to_exit) {
    const auto world = real("agtut01.map");
    if (!world) GTEST_SKIP() << test::needs_real_world("agtut01.map");
    Newcomer n(world);
    const std::string exit_room = room_with(n, "exit");
    ASSERT_FALSE(exit_room.empty()) << n.last_lines(5);
    EXPECT_TRUE(n.go_to_room(exit_room)) << n.last_lines(20);
    EXPECT_TRUE(n.heard("Door opens")) << n.last_lines(20);
    if (!n.heard("You have reached the exit")) {
        EXPECT_TRUE(n.go_to_thing("Exit")) << n.last_lines(20);
    }
    for (int steps = 0; steps < 6 && !n.heard("You have reached the exit"); ++steps) n.walk(1);
    EXPECT_TRUE(n.heard("You have reached the exit")) << n.last_lines(20);
    std::cout << "the exit after " << n.now_s() << " s\n";
}

// Only a button opens the door before the exit. The button is two rooms away and higher up.
TEST(ANewcomer, opens_the_locked_door_of_the_fifth_tutorial_map_with_its_button_and_goes_through) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "under a sanitizer the house is enough";
    const auto world = real("agtut05.map");
    if (!world) GTEST_SKIP() << test::needs_real_world("agtut05.map");
    const auto door =
        std::find_if(world->movers.begin(), world->movers.end(), [](const Mover& mover) { return !mover.by_hand; });
    ASSERT_NE(door, world->movers.end());
    const Aabb leaf = world->features[door->feature.value].bounds_m;
    Newcomer n(world);
    const std::string exit_room = room_with(n, "exit");
    ASSERT_FALSE(exit_room.empty()) << n.last_lines(5);
    EXPECT_FALSE(n.go_to_room(exit_room)) << n.last_lines(20);
    EXPECT_TRUE(n.heard("door, locked")) << "before one has gone a step";
    ASSERT_TRUE(n.locked()) << n.last_lines(20);
    EXPECT_EQ(n.locked()->door, "Door");
    EXPECT_EQ(n.locked()->button.rfind("Button", 0), 0U) << n.locked()->button;
    EXPECT_TRUE(direction_in(n.locked()->where)) << n.locked()->where;
    EXPECT_LT(n.feet_m().x, leaf.min_m.x) << "the start is west of the door, the exit east of it";
    std::cout << n.locked()->door << " locked, " << n.locked()->button << " " << n.locked()->where << ": after "
              << n.now_s() << " s\n";
    const std::string exits = n.request("X", 1.0);
    EXPECT_TRUE(words_in_order("Locked door to " + exit_room, exits)) << exits;
    // Finds the button by the announced name, which is the same in the list of things.
    const std::string button = n.locked()->button.substr(0, n.locked()->button.find(", "));
    ASSERT_TRUE(n.go_by_words_to_thing(button)) << n.last_lines(20);
    const std::size_t before = n.lines();
    EXPECT_FALSE(n.heard(button + " pressed")) << "it is pressed by its key, not by walking against it";
    n.tap("Enter", 3.0);
    EXPECT_TRUE(n.heard(button + " pressed", before)) << n.last_lines(5);
    EXPECT_TRUE(n.heard("Door opens", before)) << n.last_lines(5);
    std::cout << "pressed after " << n.now_s() << " s\n";
    EXPECT_TRUE(n.go_to_room(exit_room)) << n.last_lines(20);
    EXPECT_FALSE(n.heard("locked", before)) << "nobody says so any longer";
    EXPECT_GT(n.feet_m().x, leaf.max_m.x + 0.25) << "through the door";
    EXPECT_TRUE(n.go_to_thing("Exit")) << n.last_lines(20);
    for (int steps = 0; steps < 6 && !n.heard("You have reached the exit"); ++steps) n.walk(1);
    EXPECT_TRUE(n.heard("You have reached the exit")) << n.last_lines(20);
    std::cout << "the exit after " << n.now_s() << " s\n";
}

// Goes to three things, each in a different room from the one before. The newcomer requests the route to the room, then
// asks what is there, and then walks to the thing by ear.
void reaches_three_things(const std::shared_ptr<const Scene>& world) {
    Newcomer n(world);
    std::set<std::string> found;
    for (const std::string& entry : n.entries("Shift+4")) {
        const std::string room = name_of(entry);
        if (found.size() == 3) break;
        if (!n.go_to_room(room)) {
            std::cout << "not to " << room << ": " << n.last_lines(1);
            continue;
        }
        const std::vector<std::string> things = n.entries("Shift+H");
        ASSERT_FALSE(things.empty()) << n.last_lines(5);
        const std::string thing = things[0].substr(0, things[0].find(", "));
        const bool there = n.go_to_thing(thing);
        std::cout << room << ": " << things[0] << (there ? " reached" : " not reached") << ", " << n.now_s() << " s\n";
        if (there) found.insert(room);
    }
    EXPECT_EQ(found.size(), 3U) << n.last_lines(30);
}

TEST(ANewcomer, reaches_three_things_that_its_questions_found_in_other_rooms_of_the_house) {
    reaches_three_things(test::our_world("house.map"));
}
TEST(ANewcomer, reaches_three_things_that_its_questions_found_in_other_rooms_of_the_school) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "under a sanitizer the house is enough";
    reaches_three_things(test::our_world("school.map"));
}
TEST(ANewcomer, reaches_three_things_that_its_questions_found_in_other_rooms_of_the_melee) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "under a sanitizer the house is enough";
    const auto world = real("agdm01.map");
    if (!world) GTEST_SKIP() << test::needs_real_world("agdm01.map");
    reaches_three_things(world);
}
TEST(ANewcomer, reaches_three_things_that_its_questions_found_in_other_rooms_of_the_office) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "under a sanitizer the house is enough";
    const auto world = real("office.map");
    if (!world) GTEST_SKIP() << test::needs_real_world("office.map");
    reaches_three_things(world);
}

// The newcomer walks from the main entrance to rooms on two storeys and out again. "E008" is on the ground floor and
// "1022" one flight up. It uses the stairs, because the lifts are out of order.
TEST(ANewcomer, walks_in_the_university_to_three_rooms_on_two_storeys_and_out_again) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "unit_osm starts the threads that read OpenStreetMap";
    const auto read = real("apb-tu-dresden.osm");
    if (!read) GTEST_SKIP() << test::needs_real_world("apb-tu-dresden.osm");
    const auto world = std::make_shared<Scene>(*read);
    for (Feature& feature : world->features)
        if (feature.kind == FeatureKind::Lift) feature.kind = FeatureKind::Object;
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "takes minutes under a sanitizer";
    Newcomer n(world);
    const double ground_m = n.feet_m().z;
    std::vector<std::string> rooms;
    for (const std::string& entry : n.entries("Shift+4")) rooms.push_back(entry.substr(0, entry.find_first_of(",;")));
    std::vector<std::string> wanted;
    for (const char first : {'E', '1', '1'})
        for (const std::string& room : rooms)
            if (room[0] == first && room.size() == 4 && std::find(wanted.begin(), wanted.end(), room) == wanted.end()) {
                wanted.push_back(room);
                break;
            }
    ASSERT_EQ(wanted.size(), 3U) << n.last_lines(5);
    for (const std::string& room : wanted) {
        EXPECT_TRUE(n.go_to_room(room)) << room << ": " << n.last_lines(60);
        if (room[0] == '1') {
            EXPECT_NEAR(n.feet_m().z, ground_m + 3.0, 0.1) << room;
        }
        std::cout << room << " after " << n.now_s() << " s\n";
    }
    // Goes back to the porch of the main entrance, and through the door that leads outside.
    EXPECT_TRUE(n.go_to_room("Windfang")) << n.last_lines(60);
    const auto is_out = [&] { return n.request("1").find("Pedestrian area") != std::string::npos; };
    // The newcomer asks only once in each round, because a second question would get a longer answer.
    bool out_there = is_out();
    for (int requested = 0; requested < 20 && !out_there; ++requested, out_there = is_out()) {
        const std::string exits = n.request("X");
        const std::size_t out = exits.find("to Pedestrian area: ");
        ASSERT_NE(out, std::string::npos) << exits;
        EXPECT_TRUE(n.obey(exits.substr(out))) << exits;
    }
    EXPECT_TRUE(out_there) << n.last_lines(30);
    EXPECT_LT(glm::length(n.feet_m() - world->starts[0].feet_m), 12.0) << "by a door of the same front";
    std::cout << "outside after " << n.now_s() << " s\n";
}

// Makes a newcomer without a device, or with the simulated hand of a device, which does not move.
std::unique_ptr<Newcomer> newcomer(const std::shared_ptr<const Scene>& world, const char* device) {
    HandFacts hand;
    if (device) {
        hand.present = hand.simulated = true;
        hand.spec = *find_device_spec(device);
    }
    return std::make_unique<Newcomer>(world, std::filesystem::path{}, hand);
}

// A building for the test. `here` and `other` say how many rooms the newcomer must know by name and reach: on the
// storey of the start, and on the storey above or below.
struct Building {
    const char* file;
    std::size_t here, other;
    bool below = false, ours = false;
    bool back = true;  // false: the way out is not tried
    bool next = true;  // false: the other storey is not next to that of the start but two storeys away
};

// Makes a two-storey office in the form that a program for architects would write.
std::shared_ptr<const Scene> office(const char* file) {
    const test::TemporaryFolder folder;
    return test::world_in(folder.write(file, test::office_ifc({2, 1, 3}).text));
}

// Returns true for stairs, but not for footways, which are named after the stairs to which they lead.
bool is_stairs(const std::string& room) {
    return room.find("tair") != std::string::npos && !room.starts_with("Footway");
}

// Goes from the outer door at the start to three rooms and back to the ground outside. The newcomer chooses each room
// from the list of routes by its announced place. It uses only what is spoken.
void walks_to_three_rooms_and_out_again(const Building& building, const char* device) {
    const auto world = building.ours ? office(building.file) : real(building.file);
    if (!world) GTEST_SKIP() << test::needs_real_world(building.file);
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "takes minutes under a sanitizer";
    const std::unique_ptr<Newcomer> walks = newcomer(world, device);
    Newcomer& n = *walks;
    const Vec3 begun_m = n.feet_m();
    (void)n.entries("Shift+4");
    std::vector<std::string> here, other;
    const std::string there =
        std::string(building.next ? "one storey " : "two storeys ") + (building.below ? "below" : "above");
    const std::regex elsewhere("storeys? (above|below)");
    for (const std::string& entry : n.entries("Shift+4")) {
        const std::string room = entry.substr(0, entry.find_first_of(",;"));
        if (room.find("round outside") != std::string::npos || is_stairs(room)) continue;
        // Skips rooms whose names do not come from the file.
        if (entry.find(", storey ") != std::string::npos || room.ends_with("oom") ||
            room.find("iche") != std::string::npos)
            continue;
        const bool is_there = entry.find(there) != std::string::npos;
        if (is_there || !std::regex_search(entry, elsewhere)) (is_there ? other : here).push_back(room);
    }
    ASSERT_GE(here.size(), building.here) << n.last_lines(20);
    ASSERT_GE(other.size(), building.other) << n.last_lines(20);
    here.resize(building.here);
    other.resize(building.other);
    std::vector<std::string> rooms = here;
    rooms.insert(rooms.end(), other.begin(), other.end());
    for (std::size_t i = 0; i < rooms.size(); ++i) {
        EXPECT_TRUE(n.go_to_room(rooms[i])) << rooms[i] << ": " << n.last_lines(60);
        if (i < here.size()) EXPECT_LT(std::abs(n.feet_m().z - begun_m.z), 1.0) << rooms[i];
        else if (building.below) EXPECT_LT(n.feet_m().z, begun_m.z - 1.0) << rooms[i];
        else EXPECT_GT(n.feet_m().z, begun_m.z + 2.0) << rooms[i];
        std::cout << building.file << (device ? " with " : " without ") << (device ? device : "a device") << ": "
                  << rooms[i] << " after " << n.now_s() << " s\n";
    }
    if (!building.back) return;
    EXPECT_TRUE(n.go_to_room("Ground outside")) << n.last_lines(60);
    EXPECT_NE(n.request("1").find("Ground outside"), std::string::npos) << n.last_lines(10);
    EXPECT_LT(std::abs(n.feet_m().z - begun_m.z), 1.0);
    std::cout << "outside after " << n.now_s() << " s\n";
}

constexpr Building kInstitute{"institute.ifczip", 1, 2}, kDuplex{"duplex-apartment.ifc", 1, 2},
    kFamilyHouse{"fzk-haus.ifc", 2, 1},
    // At the station, two routes of nearly equal length lead out from the steps that are the third destination. The
    // directions switch between them at each of two landings.
    kStation{.file = "delft-station.osm", .here = 1, .other = 2, .below = true, .next = false},
    kOffice{"office.ifc", 1, 2, false, true};

TEST(ANewcomer, walks_in_a_generated_office_to_three_rooms_on_two_storeys_and_out_again) {
    walks_to_three_rooms_and_out_again(kOffice, nullptr);
}
TEST(ANewcomer, walks_in_a_generated_office_with_a_simulated_device_to_three_rooms_on_two_storeys_and_out_again) {
    walks_to_three_rooms_and_out_again(kOffice, "SIM-T");
}
TEST(ANewcomer, walks_in_the_institute_to_three_rooms_on_two_storeys_and_out_again) {
    walks_to_three_rooms_and_out_again(kInstitute, nullptr);
}
TEST(ANewcomer, walks_in_the_institute_with_a_simulated_device_to_three_rooms_on_two_storeys_and_out_again) {
    walks_to_three_rooms_and_out_again(kInstitute, "SIM-T");
}
TEST(ANewcomer, walks_in_the_duplex_to_three_rooms_on_two_storeys_and_out_again) {
    walks_to_three_rooms_and_out_again(kDuplex, nullptr);
}
TEST(ANewcomer, walks_in_the_duplex_with_a_simulated_device_to_three_rooms_on_two_storeys_and_out_again) {
    walks_to_three_rooms_and_out_again(kDuplex, "SIM-T");
}
TEST(ANewcomer, walks_in_the_family_house_to_three_rooms_on_two_storeys_and_out_again) {
    walks_to_three_rooms_and_out_again(kFamilyHouse, nullptr);
}
TEST(ANewcomer, walks_in_the_family_house_with_a_simulated_device_to_three_rooms_on_two_storeys_and_out_again) {
    walks_to_three_rooms_and_out_again(kFamilyHouse, "SIM-T");
}

TEST(ANewcomer, walks_in_the_station_to_three_places_on_two_storeys) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "unit_osm starts the threads that read OpenStreetMap";
    walks_to_three_rooms_and_out_again(kStation, nullptr);
}
TEST(ANewcomer, walks_in_the_station_with_a_simulated_device_to_three_places_on_two_storeys) {
    if (!std::getenv("HANDRAIL_ALL_ROUTES")) GTEST_SKIP() << "set HANDRAIL_ALL_ROUTES: ten seconds of computing";
    walks_to_three_rooms_and_out_again(kStation, "SIM-T");
}

// The gallery is the only room upstairs. Its spiral stairs wind below the gallery's own floor, so that a person must
// bow their head.
TEST(ANewcomer, hears_what_is_around_in_the_family_house_and_a_stair_route_to_its_gallery) {
    const auto world = real("fzk-haus.ifc");
    if (!world) GTEST_SKIP() << test::needs_real_world("fzk-haus.ifc");
    Newcomer n(world);
    (void)n.entries("Shift+4");
    const std::string way = n.choose("Shift+4", "Galerie");
    EXPECT_EQ(way.find("in one go"), std::string::npos) << way;
    EXPECT_NE(way.find("tairs"), std::string::npos) << way;
    const std::string around = n.request("2");
    EXPECT_NE(around.find("Ahead: "), std::string::npos) << around;
    EXPECT_EQ(around.find("round outside"), std::string::npos) << "what one stands on is no thing: " << around;
}

// Goes to each named room to which a route is announced. The unnamed rooms are window ledges.
TEST(ANewcomer, walks_to_every_room_of_the_duplex_and_the_family_house) {
    if (!std::getenv("HANDRAIL_ALL_ROUTES")) GTEST_SKIP() << "set HANDRAIL_ALL_ROUTES: half a minute of computing";
    for (const char* file : {"duplex-apartment.ifc", "fzk-haus.ifc"}) {
        const auto world = real(file);
        if (!world) {
            std::cout << "Skipped: " << test::needs_real_world(file) << "\n";
            continue;
        }
        Newcomer n(world);
        (void)n.entries("Shift+4");
        std::set<std::string> rooms;
        for (const std::string& entry : n.entries("Shift+4")) rooms.insert(entry.substr(0, entry.find_first_of(",;")));
        for (const char* unnamed : {"Niche", "Roof"}) rooms.erase(unnamed);
        for (const std::string& room : rooms) {
            // The newcomer has already been on the stairs, on the way to another room.
            if (words_in_order("Stairs", n.request("1")) && room == "Stairs") continue;
            EXPECT_TRUE(n.go_to_room(room)) << room << ": " << n.last_lines(60);
        }
        std::cout << file << ": " << rooms.size() << " rooms after " << n.now_s() << " s\n";
        EXPECT_GE(rooms.size(), 6U);
    }
}

// The announcements about the lift are enough for the newcomer to ride it.
TEST(ANewcomer, rides_the_lift_of_a_building_without_stairs_to_its_highest_storey_and_down_again) {
    Newcomer n(test::hall_with_lift());
    (void)n.entries("Shift+4");
    EXPECT_TRUE(n.go_to_room("Hall, Level 2")) << n.last_lines(40);
    EXPECT_NEAR(n.feet_m().z, 6.0, 0.1);
    EXPECT_TRUE(n.heard("You are standing in it. Enter starts it")) << n.last_lines(40);
    EXPECT_TRUE(n.go_to_room("Hall, Level 0")) << n.last_lines(40);
    EXPECT_NEAR(n.feet_m().z, 0.0, 0.1);
}

// The newcomer goes one storey up by stairs and one more by lift, and out through the porch.
TEST(ANewcomer, walks_in_the_university_by_stairs_and_lift_with_a_simulated_device) {
    if (!std::getenv("HANDRAIL_ALL_ROUTES")) GTEST_SKIP() << "set HANDRAIL_ALL_ROUTES: ten seconds of computing";
    const auto world = real("apb-tu-dresden.osm");
    if (!world) GTEST_SKIP() << test::needs_real_world("apb-tu-dresden.osm");
    const std::unique_ptr<Newcomer> walks = newcomer(world, "SIM-T");
    Newcomer& n = *walks;
    (void)n.entries("Shift+4");
    const double ground_m = n.feet_m().z;
    for (const char* room : {"E027", "1009", "2013", "Windfang"}) {
        EXPECT_TRUE(n.go_to_room(room)) << room << ": " << n.last_lines(60);
        EXPECT_NEAR(n.feet_m().z, ground_m + (room[0] == '1' ? 3.0 : room[0] == '2' ? 6.0 : 0.0), 0.1) << room;
        std::cout << room << " after " << n.now_s() << " s\n";
    }
    EXPECT_TRUE(n.heard("Stairs up")) << n.last_lines(60);
    EXPECT_TRUE(n.heard("Lift Aufzug2 goes to Level 2")) << n.last_lines(60);
}

}  // namespace newcomer_test
}  // namespace handrail
