// Tests that the printed plates of all storeys of the bundled worlds are closed solids. Checks the plates with code of
// its own, and with admesh if that program is installed.
#include "worlds/exports/storey_stl.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <map>
#include <random>

#include "tests/support/lay_floor.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/exports/plans.h"
#include "worlds/base/files.h"

namespace handrail::test {
namespace storey_stl_test {

PlateRing box(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1, bool hole = false) {
    PlateRing ring{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    if (hole) std::reverse(ring.begin(), ring.end());
    return ring;
}

double area_of(const std::vector<std::array<PlatePoint, 3>>& faces) {
    double sum = 0.0;
    for (const auto& f : faces)
        sum += 0.5 * (static_cast<double>(f[1].x_um - f[0].x_um) * (f[2].y_um - f[0].y_um) -
                      static_cast<double>(f[1].y_um - f[0].y_um) * (f[2].x_um - f[0].x_um));
    return sum;
}

TEST(Triangulated, covers_an_area_with_holes_exactly) {
    const PlateArea area{
        box(0, 0, 100, 100),
        {box(10, 10, 20, 20, true), box(10, 30, 90, 40, true), box(50, 60, 60, 90, true), box(70, 10, 80, 20, true)}};
    const auto faces = triangulated(area);
    ASSERT_TRUE(faces);
    EXPECT_EQ(area_of(*faces), 10000.0 - 100.0 - 800.0 - 300.0 - 100.0);
    for (const auto& face : *faces) EXPECT_GT(area_of({face}), 0.0);
    EXPECT_EQ(faces->size(), 4U + 4U * 4U + 2U * 4U - 2U) << "corners and two for each hole, less two";
}

TEST(Triangulated, covers_random_areas_with_many_holes) {
    for (unsigned seed = 1; seed <= 40; ++seed) {
        std::mt19937 random(seed);
        PlateArea area{box(0, 0, 1000, 1000), {}};
        double free = 1e6;
        for (int x = 0; x < 10; ++x)
            for (int y = 0; y < 10; ++y) {
                if (random() % 3 == 0) continue;
                const int x0 = 100 * x + 2 + static_cast<int>(random() % 40),
                          y0 = 100 * y + 2 + static_cast<int>(random() % 40);
                const int wide = 1 + static_cast<int>(random() % 50), high = 1 + static_cast<int>(random() % 50);
                area.holes.push_back(box(x0, y0, x0 + wide, y0 + high, true));
                free -= static_cast<double>(wide) * high;
            }
        const auto faces = triangulated(area);
        ASSERT_TRUE(faces) << seed;
        EXPECT_EQ(area_of(*faces), free) << seed;
    }
}

TEST(PlateWith, is_closed_round_rooms_within_walls_and_its_volume_is_the_sum_of_its_parts) {
    std::vector<RaisedArea> raised;
    raised.push_back({{box(1000, 1000, 9000, 9000), {box(2000, 2000, 8000, 8000, true)}}, 4000});  // a closed room
    raised.push_back({{box(3000, 3000, 4000, 4000), {}}, 1000});  // a thing in the room
    raised.push_back({{box(9300, 9300, 9600, 9600), {}}, 500});   // a thing outside
    const auto solid = plate_with(10000, 10000, 2000, raised);
    ASSERT_TRUE(solid);
    const SolidCheck check = check_solid(*solid);
    EXPECT_TRUE(check.closed());
    EXPECT_NEAR(check.volume_mm3, 200.0 + (64.0 - 36.0) * 4.0 + 1.0 + 0.045, 1e-9);
}

TEST(CheckSolid, finds_open_crowded_and_flat_solids) {
    auto solid = *plate_with(10000, 10000, 2000, {});
    EXPECT_TRUE(check_solid(solid).closed());
    auto open = solid;
    open.pop_back();
    EXPECT_EQ(check_solid(open).open_edges, 3U);
    auto crowded = solid;
    crowded.insert(crowded.end(), solid.begin(), solid.end());
    EXPECT_GT(check_solid(crowded).crowded_edges, 0U);
    auto flat = solid;
    flat.push_back({{{{0, 0, 0}, {5, 0, 0}, {10, 0, 0}}}});
    EXPECT_EQ(check_solid(flat).flat, 1U);
    for (SolidTriangle& triangle : solid) std::swap(triangle.corners_um[0], triangle.corners_um[1]);
    EXPECT_FALSE(check_solid(solid).closed()) << "inside out";
}

float real_at(const std::string& bytes, std::size_t at) {
    float value = 0.0F;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
}

TEST(StlOfSolid, contains_every_triangle_in_millimetres_with_its_normal) {
    const auto solid = *plate_with(10000, 20000, 2000, {});
    const std::string stl = stl_of(solid);
    ASSERT_EQ(stl.size(), 84U + 50U * 12U);
    std::uint32_t count = 0;
    std::memcpy(&count, stl.data() + 80, 4);
    EXPECT_EQ(count, 12U);
    EXPECT_EQ(real_at(stl, 84 + 8), -1.0F) << "the bottom looks down";
    float highest = 0.0F;
    for (std::size_t i = 0; i < 12; ++i)
        for (std::size_t k = 0; k < 3; ++k) highest = std::max(highest, real_at(stl, 84 + 50 * i + 12 + 12 * k + 4));
    EXPECT_EQ(highest, 20.0F);
}

// Returns the faults that admesh finds in a file; empty if it finds none or is not installed.
std::string faults_by_admesh(const std::string& stl) {
    if (std::system("command -v admesh >/dev/null 2>&1") != 0) {
        std::cout << "admesh is not installed, so only our own check was made\n";
        return {};
    }
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "plate.stl").string(), report = (folder.path() / "report").string();
    if (!write_file_atomically(file, stl)) return "not written";
    if (std::system(("admesh " + file + " >" + report + " 2>&1").c_str()) != 0) return "admesh failed";
    const std::string text = *read_whole_file(report);
    for (const char* line :
         {"Total disconnected facets        :     0                   0", "Degenerate facets     :     0",
          "Edges fixed           :     0", "Facets added          :     0", "Backwards edges       :     0",
          "Number of parts       :     1"})
        if (text.find(line) == std::string::npos) return text;
    return {};
}

void all_plates_are_closed(const std::string& file) {
    if (test::kSanitizerScale < 1.0 && file != "house.map") GTEST_SKIP() << "the same code as for our house";
    const NamedStoreys* world = storeys_of(file);
    if (!world) GTEST_SKIP() << needs_real_world(file);
    for (const Storey& storey : world->storeys) {
        const std::string what = file + " " + std::to_string(storey.number);
        const Result<StoreyPlate> plate = storey_plate(storey, BrailleTable::EnUebG1);
        ASSERT_TRUE(plate) << what << ": " << plate.error().sentence();
        EXPECT_TRUE(check_solid(plate->triangles).closed()) << what;
        EXPECT_LE(std::max(plate->wide_mm, plate->deep_mm), 200.001) << what;
        EXPECT_GE(std::max(plate->wide_mm, plate->deep_mm), 190.0) << what;
        EXPECT_EQ(faults_by_admesh(stl_of(plate->triangles)), "") << what;
        std::cout << what << ": 1:" << plate->one_to << ", " << plate->triangles.size() << " triangles\n";
    }
}

TEST(StoreyPlate, of_every_storey_of_our_house_is_closed) { all_plates_are_closed("house.map"); }
TEST(StoreyPlate, of_a_generated_architects_house_is_closed) { all_plates_are_closed("small_house.ifc"); }
TEST(StoreyPlate, of_every_storey_of_our_school_is_closed) { all_plates_are_closed("school.map"); }
TEST(StoreyPlate, of_a_game_map_is_closed) { all_plates_are_closed("agdm01.map"); }
TEST(StoreyPlate, of_every_storey_of_a_real_building_is_closed) { all_plates_are_closed("duplex-apartment.ifc"); }

TEST(StoreyPlate, has_walls_things_signs_and_an_open_door_at_their_heights) {
    const Result<StoreyPlate> plate = storey_plate(two_rooms(), BrailleTable::EnUebG1);
    ASSERT_TRUE(plate) << plate.error().sentence();
    std::map<std::int32_t, std::size_t> corners_at;
    for (const SolidTriangle& triangle : plate->triangles)
        for (const auto& corner : triangle.corners_um) ++corners_at[corner[2]];
    EXPECT_EQ(corners_at.size(), 5U) << "bottom, plate, dots, things and base, walls";
    for (const std::int32_t high : {0, 2000, 2800, 3500, 6000}) EXPECT_GT(corners_at[high], 0U) << high;
    EXPECT_EQ(plate->drawn, std::vector<std::string>{"Table"});
    EXPECT_TRUE(plate->simplified.empty()) << plate->simplified[0];
    EXPECT_TRUE(plate->signs[0].on_sheet && plate->signs[1].on_sheet);
}

// Returns whether a face at wall height covers a place of the plate.
bool is_wall_at(const StoreyPlate& plate, const Vec2& at_um) {
    return std::any_of(plate.triangles.begin(), plate.triangles.end(), [&](const SolidTriangle& triangle) {
        std::vector<Vec2> corners;
        for (const auto& corner : triangle.corners_um)
            if (corner[2] == 6000) corners.emplace_back(corner[0], corner[1]);
        return corners.size() == 3 && within_loop(corners, at_um);
    });
}

TEST(StoreyPlate, is_solid_between_the_two_layers_of_a_wall) {
    // The wall between the rooms has two layers. Up to the doorway, a cavity of 0.3 m separates them.
    Storey storey = two_rooms();
    storey.walls_m.push_back({{6.5, 0.0}, {6.7, 0.0}, {6.7, 1.5}, {6.5, 1.5}});
    storey.walls_m.push_back({{6.2, 1.4}, {6.5, 1.4}, {6.5, 1.5}, {6.2, 1.5}});
    storey.rooms[1].loops_m = {{{6.95, 0.25}, {8.95, 0.25}, {8.95, 3.75}, {6.95, 3.75}}};
    lay_floor(storey);
    const Result<StoreyPlate> plate = storey_plate(storey, BrailleTable::EnUebG1);
    ASSERT_TRUE(plate);
    const auto on_plate = [&](double x, double y) {
        return (Vec2(x, y) - storey.min_m) * (1e6 / plate->one_to) + Vec2(5000.0);
    };
    EXPECT_TRUE(is_wall_at(*plate, on_plate(6.1, 0.7)));
    EXPECT_TRUE(is_wall_at(*plate, on_plate(6.35, 0.7)));
    EXPECT_FALSE(is_wall_at(*plate, on_plate(7.5, 0.7)));
}

TEST(StoreyPlate, reports_an_excessive_size_in_one_sentence) {
    Storey storey = two_rooms();
    storey.max_m = {3000.0, 40.0};
    const Result<StoreyPlate> plate = storey_plate(storey, BrailleTable::EnUebG1);
    ASSERT_FALSE(plate);
    EXPECT_NE(plate.error().message.find("too large"), std::string::npos);
}

}  // namespace storey_stl_test
}  // namespace handrail::test
