// Tests the scene that the reader makes of a small building drawn with Simple Indoor Tagging.
#include <bzlib.h>
#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/unit/osm/osm_text.h"
#include "worlds/navigation/navigation.h"
#include "worlds/osm/osm_levels.h"
#include "worlds/scene/honest_report.h"

namespace handrail {
namespace test_house_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::UnorderedElementsAre;

Scene read_house(const std::string& text = test::test_house(), const std::string& building = {}) {
    ReadOptions options;
    options.building = building;
    Result<Scene> scene = read_osm(text, "house.osm", options);
    EXPECT_TRUE(scene.has_value()) << scene.error().sentence();
    if (!scene) return {};
    const Result<void> valid = validate(*scene);
    EXPECT_TRUE(valid.has_value()) << valid.error().sentence();
    return std::move(*scene);
}

TEST(OsmLevels, may_be_lists_ranges_negative_numbers_and_halves) {
    EXPECT_THAT(levels_of("0;1;2").levels, ElementsAre(0, 1, 2));
    EXPECT_THAT(levels_of("0-3").levels, ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(levels_of("-1-3").levels, ElementsAre(-1, 0, 1, 2, 3));
    EXPECT_THAT(levels_of("-2--1").levels, ElementsAre(-2, -1));
    EXPECT_THAT(levels_of("-2;-1;0").levels, ElementsAre(-2, -1, 0));
    EXPECT_THAT(levels_of("0.5").levels, ElementsAre(0.5));
    EXPECT_THAT(levels_of("1; 4 - 5").levels, ElementsAre(1, 4, 5));
    EXPECT_THAT(levels_of("0", "1-2;5").levels, ElementsAre(0, 1, 2, 5));
    EXPECT_THAT(levels_of("3-1").levels, ElementsAre(1, 2, 3));
    EXPECT_THAT(levels_of("").levels, IsEmpty());
    for (const char* odd : {"EG", "1e9", "0-9999999", "--", "0;x"}) EXPECT_TRUE(levels_of(odd).damaged) << odd;
    EXPECT_LE(levels_of("0-300;-100-300").levels.size(), 401U);
}

TEST(OsmHouse, rooms_doors_and_levels_match_the_file) {
    const Scene scene = read_house();
    EXPECT_EQ(scene.name, "Test House");
    std::vector<std::string> names;
    for (const StatedRoom& room : scene.stated->rooms) names.push_back(room.name);
    EXPECT_THAT(names, UnorderedElementsAre("Corridor F1, Level 0", "Corridor F1, Level 1", "Library, Level 0",
                                            "Library, Level 1", "102", "Women's toilets T1, Level 0",
                                            "Women's toilets T1, Level 1", "Stairs S1, Level 0", "Stairs S1, Level 1",
                                            "Lift L1, Level 0", "Lift L1, Level 1", "Foyer", "Vault"));
    EXPECT_THAT(test::joins_of(scene, StatedPortalKind::Door),
                IsSupersetOf({"Corridor F1, Level 0", "Corridor F1, Level 0 | Library, Level 0",
                              "Corridor F1, Level 1 | Library, Level 1", "Library, Level 1",
                              "Corridor F1, Level 0 | Women's toilets T1, Level 0",
                              "Corridor F1, Level 1 | Stairs S1, Level 1", "Corridor F1, Level 0 | Lift L1, Level 0"}));
    EXPECT_THAT(test::joins_of(scene, StatedPortalKind::Opening),
                UnorderedElementsAre("Corridor F1, Level 0 | 102", "Corridor F1, Level 0 | Foyer"));
    EXPECT_THAT(test::joins_of(scene, StatedPortalKind::Stairs),
                ElementsAre("Stairs S1, Level 0 | Stairs S1, Level 1"));
    EXPECT_THAT(test::joins_of(scene, StatedPortalKind::Lift), ElementsAre("Lift L1, Level 0 | Lift L1, Level 1"));
    ASSERT_EQ(scene.stated->storeys.size(), 2U);
    EXPECT_NEAR(scene.stated->storeys[1].floor_m, 3.5, 1e-9) << "seven metres in two levels";
    EXPECT_NEAR(test::room_named(scene, "102")->area_m2, 16.0, 0.1);
}

TEST(OsmHouse, can_be_walked_from_the_main_entrance_to_every_room_with_a_door) {
    const Scene scene = read_house();
    ASSERT_FALSE(scene.starts.empty());
    EXPECT_TRUE(scene.starts[0].base);
    EXPECT_EQ(scene.starts[0].name, "main entrance");
    const auto ways = Navigation::make(scene, walker_measures(scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(ways.has_value()) << ways.error().sentence();
    for (const StatedRoom& room : scene.stated->rooms) {
        if (room.name.starts_with("Stairs")) continue;
        EXPECT_EQ((*ways)->reachable(scene.starts[0].feet_m, room.at_m), room.name != "Vault") << room.name;
    }
}

TEST(OsmHouse, reports_what_was_assumed_missing_or_omitted) {
    const Scene scene = read_house();
    EXPECT_THAT(scene.report.guessed, Contains(HasSubstr("3.5 metres high")));
    EXPECT_THAT(scene.report.guessed, Contains(HasSubstr("90 centimetres")));
    EXPECT_THAT(scene.report.left_out, Contains(HasSubstr("2 Annex")));
    EXPECT_THAT(scene.report.left_out, Contains(HasSubstr("leads nowhere")));
    std::string warnings;
    for (const Diagnostic& warning : scene.report.warnings) warnings += warning.sentence() + "\n";
    EXPECT_THAT(warnings, HasSubstr("not closed: 1"));
    EXPECT_THAT(warnings, HasSubstr("neither a door nor an opening: Vault"));
    const HonestReport report = honest_report(scene);
    EXPECT_EQ(report.rooms, 13);
    EXPECT_EQ(report.largest_connected, 12);
    EXPECT_EQ(report.lifts, 1);
    EXPECT_EQ(report.stairs, 1);
}

TEST(OsmHouse, announces_tags_that_matter_to_blind_people_on_entering) {
    const Scene scene = read_house();
    std::vector<std::string> said;
    for (const Solid& solid : scene.solids)
        if (solid.role == SolidRole::Trigger) said.push_back(scene.features[solid.feature.value].message);
    EXPECT_THAT(said, Contains("Tactile paving. Handrails on both sides. 18 steps."));
    EXPECT_THAT(said, Contains("Accessible by wheelchair. With toilets for wheelchair users."));
    EXPECT_THAT(said, Contains("With voice announcements."));
    const auto machine = std::find_if(scene.features.begin(), scene.features.end(),
                                      [](const Feature& f) { return f.name == "Vending machine"; });
    ASSERT_NE(machine, scene.features.end());
    EXPECT_EQ(machine->message, "It takes coins only.");
}

TEST(OsmHouse, of_several_buildings_is_chosen_by_name_or_number) {
    for (const char* building : {"Annex", "annex", "2"}) {
        const Scene scene = read_house(test::test_house(), building);
        EXPECT_EQ(scene.name, "Annex");
        ASSERT_EQ(scene.stated->rooms.size(), 1U);
        EXPECT_EQ(scene.stated->rooms[0].name, "Shed");
        EXPECT_THAT(test::joins_of(scene, StatedPortalKind::Door), ElementsAre("Shed"));
    }
    ReadOptions options;
    options.building = "Palace";
    const Result<Scene> none = read_osm(test::test_house(), "house.osm", options);
    ASSERT_FALSE(none.has_value());
    EXPECT_THAT(none.error().sentence(), HasSubstr("1 Test House, 2 Annex"));
}

TEST(OsmHouse, is_the_same_if_compressed) {
    std::string text = test::test_house();
    std::string packed(text.size() + 10'000, '\0');
    auto size = static_cast<unsigned>(packed.size());
    ASSERT_EQ(BZ2_bzBuffToBuffCompress(packed.data(), &size, text.data(), static_cast<unsigned>(text.size()), 9, 0, 0),
              BZ_OK);
    packed.resize(size);
    const Result<Scene> scene = read_osm(packed, "house.osm.bz2");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    const Scene plain = read_house();
    EXPECT_EQ(scene->solids.size(), plain.solids.size());
    EXPECT_EQ(scene->stated->rooms.size(), plain.stated->rooms.size());
    const Result<Scene> cut = read_osm(packed.substr(0, packed.size() / 2), "house.osm.bz2");
    ASSERT_FALSE(cut.has_value());
    EXPECT_THAT(cut.error().sentence(), HasSubstr("damaged or cut short"));
}

TEST(OsmHouse, in_pbf_form_is_the_same_and_a_truncated_file_is_reported) {
    const std::string packed = test::content_of(test::project_root() / "tests/unit/osm/worlds/test_house.osm.pbf");
    const Result<Scene> scene = read_osm(packed, "house.osm.pbf");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_EQ(scene->stated->rooms.size(), read_house().stated->rooms.size());
    EXPECT_EQ(scene->report.left_out, read_house().report.left_out);
    for (std::size_t at = 1; at < packed.size(); at += 37) {
        const Result<Scene> cut = read_osm(packed.substr(0, at), "cut.osm.pbf");
        if (!cut) EXPECT_FALSE(cut.error().sentence().empty()) << "cut at " << at;
        else EXPECT_TRUE(validate(*cut).has_value()) << "cut at " << at;
    }
}

TEST(OsmHouse, gives_the_same_scene_for_the_same_bytes) {
    const Scene a = read_house(), b = read_house();
    ASSERT_EQ(a.solids.size(), b.solids.size());
    for (std::size_t i = 0; i < a.solids.size(); ++i) {
        EXPECT_EQ(a.solids[i].shape.bounds_m.min_m, b.solids[i].shape.bounds_m.min_m);
        EXPECT_EQ(a.solids[i].shape.bounds_m.max_m, b.solids[i].shape.bounds_m.max_m);
    }
    EXPECT_EQ(a.features.size(), b.features.size());
}

TEST(OsmRealFiles, include_the_rooms_and_footways_of_the_university_across_storeys) {
    const auto path = test::real_world("apb-tu-dresden.osm");
    if (!path) GTEST_SKIP() << test::needs_real_world("apb-tu-dresden.osm");
    const Result<Scene> scene = read_world(*path);
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_EQ(scene->name, "Andreas-Pfitzmann-Bau");
    const HonestReport report = honest_report(*scene);
    EXPECT_EQ(report.storeys, 5);
    // The file has 475 spaces drawn as ways, the foyer as a relation, and 22 footways and platforms outside.
    EXPECT_EQ(report.rooms, 476 + 22);
    EXPECT_GE(report.largest_connected, 466);
    EXPECT_GE(report.doors, 490);
    // The impassable doors are doors above the ground that lead nowhere, and a winding stair of 3.6 m.
    EXPECT_LE(report.doors_impassable, 6);
    EXPECT_EQ(report.lifts, 2);
    EXPECT_EQ(report.stairs, 8 + 2) << "two of them outside";
    EXPECT_EQ(std::count_if(scene->stated->rooms.begin(), scene->stated->rooms.end(),
                            [](const StatedRoom& room) { return room.name.empty(); }),
              0);
    const auto ways = Navigation::make(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(ways.has_value()) << ways.error().sentence();
    for (const std::string name : {"1022", "2028", "3029", "E008"}) {
        const StatedRoom* room = test::room_named(*scene, name);
        ASSERT_NE(room, nullptr) << name;
        EXPECT_TRUE((*ways)->reachable(scene->starts[0].feet_m, room->at_m)) << name;
    }
}

TEST(OsmRealFiles, of_a_station_without_rooms_can_be_walked_along_footways) {
    const auto path = test::real_world("delft-station.osm");
    if (!path) GTEST_SKIP() << test::needs_real_world("delft-station.osm");
    const Result<Scene> scene = read_world(*path);
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_THAT(scene->report.guessed, Contains(HasSubstr("not connected by doors")));
    EXPECT_GT(scene->stated->rooms.size(), 10U);
    EXPECT_EQ(scene->stated->stairs, 6) << "as many as the file holds places for";
    EXPECT_GE(honest_report(*scene).largest_connected, 15);
    EXPECT_THAT(scene->report.left_out, Contains(HasSubstr("footways lack")));
    EXPECT_FALSE(scene->starts.empty());
}

// The university's file draws glass walls with a corner in each doorway. The upper flight to the station's platforms
// states no level.
TEST(OsmRealFiles, lead_to_rooms_behind_drawn_walls_and_to_platforms_below_two_flights) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "takes minutes under a sanitizer";
    const std::pair<const char*, std::vector<std::string>> worlds[] = {
        {"aachen-university.osm", {"U05", "005", "U01", "010", "113", "111", "211", "334", "U11"}},
        {"delft-station.osm", {"Spoor 3", "Spoor 4"}}};
    bool any = false;
    for (const auto& [file, names] : worlds) {
        const auto path = test::real_world(file);
        if (!path) continue;
        any = true;
        const Result<Scene> scene = read_world(*path);
        ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
        const auto ways = Navigation::make(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
        ASSERT_TRUE(ways.has_value()) << ways.error().sentence();
        for (const std::string& name : names) {
            const StatedRoom* room = test::room_named(*scene, name);
            ASSERT_NE(room, nullptr) << name;
            const auto route = (*ways)->plan(scene->starts[0].feet_m, room->at_m);
            EXPECT_TRUE(route.reaches) << file << ": " << name << ", short of it by " << route.short_of_m;
        }
    }
    if (!any) GTEST_SKIP() << test::needs_real_world("aachen-university.osm");
}

}  // namespace test_house_test
}  // namespace handrail
