// Tests worlds that are written as room descriptions and read again. The numbers of rooms, doors, windows, stairs and
// pieces of furniture must be the same.
#include <gmock/gmock.h>

#include <map>
#include <set>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/unit/words/words_text.h"
#include "worlds/exports/as_words.h"
#include "worlds/navigation/navigation.h"

namespace handrail {
namespace words_counts_test {

struct Counts {
    std::size_t rooms = 0, doors = 0, windows = 0, stairs = 0, furniture = 0;
    bool operator==(const Counts&) const = default;
    friend void PrintTo(const Counts& counts, std::ostream* out) {
        *out << counts.rooms << " rooms, " << counts.doors << " doors, " << counts.windows << " windows, "
             << counts.stairs << " stairs, " << counts.furniture << " pieces of furniture";
    }
};

Counts counts_of(const Scene& scene) {
    const StatedBuilding& stated = *scene.stated;
    return {stated.rooms.size(), static_cast<std::size_t>(scene.report.doors), stated.windows.size(),
            static_cast<std::size_t>(stated.stairs), stated.furnishings.size()};
}

// Counts the parts of a map, which states no counts. The rooms are those that the program finds. Stairs are one room on
// each of their storeys. Things are recognised by their names.
Counts counts_of_map(const Scene& scene, const WordsHouse& house) {
    Counts counts;
    for (const WordsHouse::Room& room : house.rooms) {
        counts.rooms += room.to_storey - room.storey + 1;
        counts.stairs += room.kind == WordsHouse::Kind::Stairs ? 1 : 0;
    }
    counts.doors = static_cast<std::size_t>(scene.report.doors);
    for (const Feature& feature : scene.features) {
        const bool window = feature.name.ends_with("indow");
        const bool of_stairs = feature.name.starts_with("Stair");  // the rooms above already include the stairs
        if (feature.kind != FeatureKind::Object || feature.made_name || feature.name.empty() || of_stairs) continue;
        ++(window ? counts.windows : counts.furniture);
    }
    return counts;
}

void expect_warned_of_nothing(const Scene& again, const std::string& text) {
    for (const Diagnostic& warning : again.report.warnings)
        if (warning.line > 0) ADD_FAILURE() << warning.sentence() << "\n" << text;
}

void expect_counts_come_back(const std::filesystem::path& path) {
    const Result<Scene> scene = read_world(path);
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    for (const WordLanguage language : {WordLanguage::English, WordLanguage::German}) {
        Counts before;
        std::string written;
        if (scene->stated && !scene->stated->rooms.empty()) {
            before = counts_of(*scene);
            written = text_of(stated_house(*scene, language), *scene, language);
        } else {
            const Result<WalkSpace> space = make_walk_space(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
            ASSERT_TRUE(space.has_value()) << space.error().sentence();
            const WordsHouse house = found_house(*scene, make_rooms(*scene, *space), *space, language);
            before = counts_of_map(*scene, house);
            written = text_of(house, *scene, language);
        }
        const Scene again = test::read_rooms(written);
        expect_warned_of_nothing(again, written);
        EXPECT_EQ(counts_of(again), before) << written;
    }
}

void expect_real_counts_come_back(const std::string& file) {
    if (test::kSanitizerScale != 1.0) GTEST_SKIP() << "the two worlds of ours are enough under a sanitizer";
    const auto path = test::real_world(file);
    if (!path) GTEST_SKIP() << test::needs_real_world(file);
    expect_counts_come_back(*path);
}

TEST(CountsInWords, are_kept_for_our_house) { expect_counts_come_back(test::project_root() / "worlds/maps/house.map"); }
TEST(CountsInWords, are_kept_for_our_school) {
    expect_counts_come_back(test::project_root() / "worlds/maps/school.map");
}
TEST(CountsInWords, are_kept_for_the_duplex) { expect_real_counts_come_back("duplex-apartment.ifc"); }
TEST(CountsInWords, are_kept_for_the_institute) { expect_real_counts_come_back("institute.ifczip"); }
TEST(CountsInWords, are_kept_for_the_fzk_house) { expect_real_counts_come_back("fzk-haus.ifc"); }

// Windows in a rectangular room, and in one with more corners, must keep their width, height and place.
TEST(WindowsInWords, are_unchanged_after_export_and_import_in_both_languages) {
    const std::string text =
        "Building: House.\n\nRoom: Hall, 6 by 4 metres. Door outside in the south wall.\n"
        "Window in the west wall, 1.5 metres along, 0.8 metres wide, 1.4 metres high, 0.7 metres above the floor.\n"
        "Window in the north wall, called \"Bay window, large\", landmark.\n\n"
        "Room: Corner, corners 6 0, 10 0, 10 2, 8 2, 8 4, 6 4. Door to Hall.\n"
        "Window, at 8 metres east and 3 metres north, 0.5 metres wide.\n";
    const Scene scene = test::read_rooms(text);
    ASSERT_EQ(scene.stated->windows.size(), 3U);
    for (const WordLanguage language : {WordLanguage::English, WordLanguage::German}) {
        const std::string written = text_of(stated_house(scene, language), scene, language);
        const Scene again = test::read_rooms(written);
        expect_warned_of_nothing(again, written);
        ASSERT_EQ(again.stated->windows.size(), 3U) << written;
        EXPECT_TRUE(again.stated->furnishings.empty()) << written;
        for (std::size_t w = 0; w < 3; ++w) {
            const StatedThing &one = scene.stated->windows[w], &other = again.stated->windows[w];
            EXPECT_LT(glm::length(one.bounds_m.min_m - other.bounds_m.min_m), 1e-3) << written;
            EXPECT_LT(glm::length(one.bounds_m.max_m - other.bounds_m.max_m), 1e-3) << written;
        }
        EXPECT_TRUE(test::thing_of(again, "Bay window, large")->landmark);
    }
}

// The descriptions state the material of each room's floor, of things, and of the walls. The reader gives all walls the
// most frequent wall material.
TEST(MaterialsInWords, are_unchanged_after_export_and_import_in_both_languages) {
    const Scene scene = test::read_rooms(
        "Building: House.\nWalls: 0.2 metres thick, made of brick.\n\n"
        "Room: Hall, 6 by 4 metres, floor of stone. Door outside in the south wall. Table in the north-east corner, "
        "made of metal.\n\nRoom: Study, 4 by 4 metres, east of Hall, wooden floor. Door to Hall. Shelf, made of "
        "wood.\n");
    const auto materials_of = [](const Scene& of) {
        std::map<std::string, std::set<std::string>> names;
        for (const Feature& feature : of.features) {
            const std::string what = feature.kind == FeatureKind::Floor  ? "floor"
                                     : feature.kind == FeatureKind::Wall ? "wall"
                                                                         : feature.name;
            names[what].insert(of.material(feature.material).name);
        }
        return names;
    };
    const auto before = materials_of(scene);
    EXPECT_EQ(before.at("Table"), std::set<std::string>{"metal"});
    for (const WordLanguage language : {WordLanguage::English, WordLanguage::German}) {
        const std::string written = text_of(stated_house(scene, language), scene, language);
        const auto after = materials_of(test::read_rooms(written));
        for (const char* what : {"Table", "Shelf", "floor", "wall"}) {
            ASSERT_TRUE(after.contains(what)) << written;
            EXPECT_EQ(after.at(what), before.at(what)) << what << "\n" << written;
        }
    }
}

}  // namespace words_counts_test
}  // namespace handrail
