// Tests how the reader reads archives in the Indoor Mapping Data Format.
#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/real_worlds.h"
#include "tests/support/zip_text.h"
#include "worlds/navigation/navigation.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/honest_report.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace venue_test {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

// Degrees per metre at 51 degrees north.
constexpr double kPerMetre_lon = 1.0 / 70'197.6, kPerMetre_lat = 1.0 / 111'249.5;

std::string point(double x_m, double y_m) {
    return fmt::format("[{:.9f},{:.9f}]", 13.0 + x_m * kPerMetre_lon, 51.0 + y_m * kPerMetre_lat);
}

std::string box(double x0, double y0, double x1, double y1) {
    return R"({"type":"Polygon","coordinates":[[)" + point(x0, y0) + "," + point(x1, y0) + "," + point(x1, y1) + "," +
           point(x0, y1) + "," + point(x0, y0) + "]]}";
}

std::string line(double x0, double y0, double x1, double y1) {
    return R"({"type":"LineString","coordinates":[)" + point(x0, y0) + "," + point(x1, y1) + "]}";
}

std::string feature(const std::string& id, const std::string& geometry, const std::string& properties) {
    return R"({"type":"Feature","id":")" + id + R"(","geometry":)" + geometry + R"(,"properties":{)" + properties +
           "}}";
}

std::string collection(const std::vector<std::string>& features) {
    std::string all;
    for (const std::string& one : features) all += (all.empty() ? "" : ",") + one;
    return R"({"type":"FeatureCollection","features":[)" + all + "]}";
}

std::string unit(const std::string& id, const std::string& where, const std::string& level, const std::string& category,
                 const std::string& name = "null", const std::string& more = "") {
    return feature(id, where,
                   R"("level_id":")" + level + R"(","category":")" + category + R"(","name":)" + name + more);
}

// Returns a venue with a walkway. An office has a hinged door, and toilets have an opening without a door. Stairs and a
// lift join two levels. A room on the upper level is of an unknown kind. The main entrance is in the west.
std::map<std::string, std::string> venue() {
    std::map<std::string, std::string> files;
    files["manifest.json"] = R"({"version":"1.0.0","language":"en"})";
    files["venue.geojson"] =
        collection({feature("v", box(0, 0, 20, 10), R"("name":{"en":"Town hall","de":"Rathaus"})")});
    files["building.geojson"] = collection(
        {feature("b1", "null", R"("name":{"en":"Old wing"})"), feature("b2", "null", R"("name":{"en":"Annex"})")});
    files["level.geojson"] = collection(
        {feature("l0", box(0, 0, 20, 10), R"("ordinal":0,"name":{"en":"Ground floor"},"building_ids":["b1"])"),
         feature("l1", box(0, 0, 20, 10), R"("ordinal":1,"name":null,"building_ids":["b1"])"),
         feature("l9", box(0, 0, 20, 10), R"("ordinal":0,"name":{"en":"Ground floor"},"building_ids":["b2"])")});
    files["unit.geojson"] = collection(
        {unit("u1", box(0, 4, 12, 6), "l0", "walkway"),
         unit("u2", box(0, 0, 6, 4), "l0", "office", R"({"en":"Passports","de":"Pässe"})"),
         unit("u3", box(6, 0, 12, 4), "l0", "restroom.female", "null", R"(,"accessibility":["wheelchair"])"),
         unit("u4", box(0, 6, 6, 10), "l0", "stairs"), unit("u5", box(0, 6, 6, 10), "l1", "stairs"),
         unit("u6", box(12, 4, 14, 6), "l0", "elevator"), unit("u7", box(12, 4, 14, 6), "l1", "elevator"),
         unit("u8", box(0, 4, 12, 6), "l1", "walkway"), unit("u9", box(0, 0, 12, 4), "l1", "acme.brewery_room"),
         unit("u10", box(30, 0, 34, 4), "l9", "room", R"({"en":"Shed"})")});
    files["opening.geojson"] = collection(
        {feature("o1", line(0, 4.5, 0, 5.5),
                 R"("level_id":"l0","category":"pedestrian.principal",)"
                 R"("name":{"en":"Front door"},"door":{"type":"revolving"})"),
         feature("o2", line(2, 4, 3, 4), R"("level_id":"l0","category":"pedestrian","door":{"type":"door"})"),
         feature("o3", line(8, 4, 9, 4), R"("level_id":"l0","category":"pedestrian","door":null)"),
         feature("o4", line(2.5, 6, 3.5, 6), R"("level_id":"l0","category":"pedestrian","door":{"type":"door"})"),
         feature("o5", line(2.5, 6, 3.5, 6), R"("level_id":"l1","category":"pedestrian","door":{"type":"door"})"),
         feature("o6", line(12, 4.5, 12, 5.5),
                 R"("level_id":"l0","category":"pedestrian",)"
                 R"("door":{"type":"sliding","automatic":true})"),
         feature("o7", line(2, 4, 3, 4), R"("level_id":"l1","category":"pedestrian","door":{"type":"door"})")});
    files["fixture.geojson"] =
        collection({feature("f1", box(1, 1, 2, 2), R"("level_id":"l0","category":"desk","name":null)")});
    return files;
}

Scene read(const std::map<std::string, std::string>& files, const std::string& building = {}) {
    ReadOptions options;
    options.building = building;
    Result<Scene> scene = read_imdf(test::zipped(files, true), "town.imdf.zip", options);
    EXPECT_TRUE(scene.has_value()) << scene.error().sentence();
    if (!scene) return {};
    const Result<void> valid = validate(*scene);
    EXPECT_TRUE(valid.has_value()) << valid.error().sentence();
    return std::move(*scene);
}

std::vector<std::string> names_of(const Scene& scene) {
    std::vector<std::string> names;
    for (const StatedRoom& room : scene.stated->rooms) names.push_back(room.name);
    return names;
}

TEST(ImdfVenue, turns_units_openings_and_levels_into_rooms_and_doors) {
    const Scene scene = read(venue(), "Old wing");
    EXPECT_EQ(scene.name, "Old wing");
    EXPECT_THAT(names_of(scene), UnorderedElementsAre("Walkway, Ground floor", "Walkway, Level 1", "Passports",
                                                      "Women's toilets", "Stairs, Ground floor", "Stairs, Level 1",
                                                      "Lift, Ground floor", "Lift, Level 1", "Acme brewery room"));
    const HonestReport report = honest_report(scene);
    EXPECT_EQ(report.doors, 6);
    EXPECT_EQ(report.stairs, 1);
    EXPECT_EQ(report.lifts, 1);
    EXPECT_EQ(report.largest_connected, 9);
    EXPECT_EQ(report.furnishings, 1);
    EXPECT_THAT(scene.report.simplified, Contains(HasSubstr("does not know")));
    ASSERT_FALSE(scene.starts.empty());
    EXPECT_EQ(scene.starts[0].name, "Front door");
    const auto ways = Navigation::make(scene, walker_measures(scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(ways.has_value());
    for (const StatedRoom& room : scene.stated->rooms)
        if (room.name == "Passports" || room.name == "Women's toilets" || room.name == "Acme brewery room") {
            // The desk is at the room's centre, so the test goes to a place one metre next to the centre.
            EXPECT_TRUE((*ways)->reachable(scene.starts[0].feet_m, room.at_m + Vec3(1.0, 0.0, 0.0))) << room.name;
        }
}

TEST(ImdfVenue, includes_all_buildings_unless_one_is_requested) {
    const Scene all = read(venue());
    EXPECT_EQ(all.name, "Town hall");
    EXPECT_THAT(names_of(all), Contains("Shed"));
    EXPECT_THAT(names_of(read(venue(), "2")), UnorderedElementsAre("Shed"));
    ReadOptions options;
    options.building = "castle";
    const Result<Scene> none = read_imdf(test::zipped(venue()), "town.imdf.zip", options);
    ASSERT_FALSE(none.has_value());
    EXPECT_THAT(none.error().sentence(), HasSubstr("1 Old wing, 2 Annex"));
}

TEST(ImdfVenue, is_read_the_same_in_a_folder_and_among_other_files) {
    std::map<std::string, std::string> wrapped{{"town/readme.txt", "hello"}, {"__MACOSX/._x", "junk"}};
    for (const auto& [name, content] : venue()) wrapped["town/" + name] = content;
    EXPECT_EQ(names_of(read(wrapped)), names_of(read(venue())));
}

TEST(ImdfVenue, without_openings_gets_assumed_doorways_from_a_walkway_into_its_rooms) {
    std::map<std::string, std::string> files = venue();
    files.erase("opening.geojson");
    const Scene scene = read(files, "Old wing");
    EXPECT_THAT(scene.report.left_out, Contains(HasSubstr("lists no openings")));
    EXPECT_THAT(scene.report.guessed, Contains(HasSubstr("5 rooms have no door in the file")));
    EXPECT_EQ(honest_report(scene).doors, 0) << "a guess is no door of the file";
    EXPECT_EQ(honest_report(scene).largest_connected, 9);
    const auto room = [&](const std::string& name) {
        const auto found = std::find_if(scene.stated->rooms.begin(), scene.stated->rooms.end(),
                                        [&](const StatedRoom& one) { return one.name == name; });
        EXPECT_NE(found, scene.stated->rooms.end()) << name;
        return found->at_m;
    };
    const auto ways = Navigation::make(scene, walker_measures(scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(ways.has_value());
    const Vec3 beside_the_desk = room("Passports") + Vec3(1.0, 0.0, 0.0);
    EXPECT_TRUE((*ways)->reachable(room("Walkway, Ground floor"), beside_the_desk));
    EXPECT_TRUE((*ways)->reachable(room("Walkway, Ground floor"), room("Women's toilets")));
    EXPECT_TRUE((*ways)->reachable(room("Walkway, Level 1"), room("Acme brewery room")));
}

TEST(ImdfVenue, gives_a_room_behind_another_a_doorway_to_it) {
    std::map<std::string, std::string> files;
    files["level.geojson"] = collection({feature("l0", box(0, 0, 20, 10), R"("ordinal":0,"name":null)")});
    files["unit.geojson"] = collection({unit("a", box(0, 8, 4, 12), "l0", "storage", R"({"en":"Behind both"})"),
                                        unit("b", box(0, 4, 4, 8), "l0", "office", R"({"en":"Behind"})"),
                                        unit("c", box(0, 0, 4, 4), "l0", "office", R"({"en":"Front"})"),
                                        unit("d", box(0, -3, 12, 0), "l0", "walkway"),
                                        unit("e", box(20, 0, 24, 4), "l0", "office", R"({"en":"Alone"})")});
    const Scene scene = read(files);
    EXPECT_EQ(honest_report(scene).largest_connected, 4);
    EXPECT_THAT(scene.report.guessed, Contains(HasSubstr("3 rooms have no door in the file")));
    EXPECT_EQ(honest_report(scene).doors, 0);
}

// Returns a venue with a hall and an annex. The annex counts its levels from a different floor.
std::map<std::string, std::string> with_annex(int hall_ordinal, int annex_ordinal, bool joined) {
    std::map<std::string, std::string> files;
    files["building.geojson"] = collection(
        {feature("b1", "null", R"("name":{"en":"Hall"})"), feature("b2", "null", R"("name":{"en":"Annex"})")});
    files["level.geojson"] = collection(
        {feature("l0", box(0, 0, 20, 10),
                 fmt::format(R"("ordinal":{},"name":{{"en":"Ground"}},"building_ids":["b1"])", hall_ordinal)),
         feature("m1", box(0, 0, 20, 10),
                 fmt::format(R"("ordinal":{},"name":{{"en":"First"}},"building_ids":["b2"])", annex_ordinal))});
    const double gap = joined ? 0.0 : 10.0;
    files["unit.geojson"] = collection({unit("u1", box(0, 0, 12, 6), "l0", "walkway", R"({"en":"Hall"})"),
                                        unit("u2", box(0, 6, 12, 9), "l0", "office", R"({"en":"Office"})"),
                                        unit("u3", box(12 + gap, 0, 20 + gap, 6), "m1", "room", R"({"en":"Annex"})")});
    const auto door = [&](const char* id, double x, const char* level) {
        return feature(id, line(x, 2, x, 3),
                       std::string(R"("level_id":")") + level + R"(","category":"pedestrian","door":{"type":"door"})");
    };
    files["opening.geojson"] = collection(
        {door("o1", 0, "l0"), door("o2", 12 + gap, "m1"),
         feature("o3", line(2, 6, 3, 6), R"("level_id":"l0","category":"pedestrian","door":{"type":"door"})")});
    return files;
}

TEST(ImdfVenue, aligns_the_floors_of_two_buildings_at_shared_doors_or_else_on_the_ground) {
    for (const int hall : {0, 1, -1})
        for (const int annex : {-1, 0, 1, 2, 4}) {
            SCOPED_TRACE(fmt::format("hall {}, annex {}", hall, annex));
            const Scene scene = read(with_annex(hall, annex, true));
            EXPECT_EQ(honest_report(scene).largest_connected, 3);
            std::vector<double> floors;
            for (const StatedRoom& room : scene.stated->rooms) floors.push_back(room.floor_m);
            EXPECT_THAT(floors, testing::Each(hall * 3.0));
            EXPECT_EQ(scene.report.guessed.end() !=
                          std::find_if(scene.report.guessed.begin(), scene.report.guessed.end(),
                                       [](const std::string& sentence) {
                                           return sentence.find("counts levels") != std::string::npos;
                                       }),
                      hall != annex);
        }
    const Scene apart = read(with_annex(0, 1, false));
    for (const StatedRoom& room : apart.stated->rooms) EXPECT_NEAR(room.floor_m, 0.0, 1e-6) << room.name;
    const Scene below = read(with_annex(0, -1, false));
    EXPECT_NEAR(below.stated->rooms.back().floor_m, -3.0, 1e-6) << "a cellar stays one";
}

TEST(ImdfVenue, speaks_a_name_shared_by_unit_and_occupant_once) {
    for (const auto& [occupant, said] : {std::pair("Passports", "Passports"), std::pair("PASSPORTS", "PASSPORTS"),
                                         std::pair("Café", "Passports, Café")}) {
        std::map<std::string, std::string> files = venue();
        files["anchor.geojson"] =
            collection({feature("a", R"({"type":"Point","coordinates":)" + point(3, 3) + "}", R"("unit_id":"u2")")});
        files["occupant.geojson"] = collection({feature(
            "c", "null", R"("anchor_id":"a","category":"office","name":{"en":")" + std::string(occupant) + R"("})")});
        EXPECT_THAT(names_of(read(files)), Contains(said));
    }
}

TEST(ImdfVenue, that_is_damaged_gives_one_sentence) {
    const auto said = [](const std::string& bytes) {
        const Result<Scene> scene = read_imdf(bytes, "town.imdf.zip");
        return scene ? std::string("read") : scene.error().sentence();
    };
    std::map<std::string, std::string> files = venue();
    files["unit.geojson"].resize(files["unit.geojson"].size() / 2);
    EXPECT_THAT(said(test::zipped(files)), HasSubstr("unit.geojson in this archive is not complete GeoJSON"));
    files["unit.geojson"] = "[]";
    EXPECT_THAT(said(test::zipped(files)), HasSubstr("contains no rooms"));
    files["unit.geojson"] =
        R"({"features":[7,{"id":1,"geometry":[],"properties":3},{"properties":{"level_id":"l0"}}]})";
    EXPECT_THAT(said(test::zipped(files)), HasSubstr("contains no rooms"));
    std::string locked = test::zipped(venue());
    locked[locked.find("PK\x01\x02") + 8] = 1;
    EXPECT_THAT(said(locked), HasSubstr("password"));
    std::string swollen = test::zipped(venue(), true);  // the archive claims a larger size than it has
    for (std::size_t at = swollen.find("PK\x01\x02"); at != std::string::npos; at = swollen.find("PK\x01\x02", at + 1))
        swollen.replace(at + 24, 4, "\xff\xff\xff\x3f");
    EXPECT_THAT(said(swollen), HasSubstr("damaged"));
}

TEST(ImdfVenue, cut_at_any_byte_is_reported) {
    for (const bool deflated : {false, true}) {
        const std::string whole = test::zipped(venue(), deflated);
        for (std::size_t at = 0; at < whole.size(); ++at) {
            const Result<Scene> scene = read_imdf(whole.substr(0, at), "cut.imdf.zip");
            ASSERT_FALSE(scene.has_value()) << "cut at " << at;
            ASSERT_FALSE(scene.error().sentence().empty());
        }
    }
}

TEST(ImdfVenue, with_huge_numbers_loses_only_that_shape) {
    for (const char* number : {"1e308", "-1e308", "1e999", "180.0", "\"x\"", "null"}) {
        std::map<std::string, std::string> files = venue();
        std::string& units = files["unit.geojson"];
        const std::size_t at = units.find("[[[") + 3;
        units.replace(at, units.find(',', at) - at, number);
        const Result<Scene> scene = read_imdf(test::zipped(files), "far.imdf.zip");
        if (!scene) {
            EXPECT_FALSE(scene.error().sentence().empty());
            continue;
        }
        EXPECT_TRUE(validate(*scene).has_value()) << number;
        EXPECT_LT(glm::length(scene->bounds_m.size_m()), 1e5) << number;
    }
}

TEST(ImdfRealFiles, of_the_smallest_venue_can_be_opened) {
    const auto path = test::real_world("minimal.imdf.zip");
    if (!path) GTEST_SKIP() << test::needs_real_world("minimal.imdf.zip");
    const Result<Scene> scene = read_world(*path);
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_EQ(scene->name, "Tokyo Station Test Venue");
    EXPECT_THAT(names_of(*scene), Contains("Shop Unit, Station Shop"));
    EXPECT_EQ(scene->stated->storeys.size(), 3U);
    EXPECT_THAT(scene->report.left_out, Contains(HasSubstr("to a unit that does not exist")));
}

}  // namespace venue_test
}  // namespace handrail
