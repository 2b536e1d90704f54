#include <random>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/readers/reading.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace obj_test {

using test::Reading;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Reading read(const std::string& text, const ReadOptions& options = {}) {
    return test::reading_of(read_obj(text, "test.obj", options));
}

double area(const Scene& scene) {
    double sum = 0.0;
    for (const MeshTriangle& t : scene.triangles) sum += 0.5 * glm::length(glm::cross(t.b_m - t.a_m, t.c_m - t.a_m));
    return sum;
}

const std::string kSquare = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n";

TEST(ReadObj, splits_polygons_keeps_coordinates_and_counts_faces) {
    const Reading reading = read(kSquare + "f 1 2 3 4\nf 1/1 2/2/2 3//3\n");
    EXPECT_THAT(reading.said, IsEmpty());
    EXPECT_EQ(reading.scene.triangles.size(), 3U);
    EXPECT_EQ(reading.scene.report.polygons, 2);
    EXPECT_EQ(reading.scene.report.triangles, 3);
    EXPECT_EQ(reading.scene.bounds_m.max_m, Vec3(2, 2, 0));
    EXPECT_EQ(reading.scene.metres_per_unit, 1.0);
    EXPECT_EQ(reading.scene.features.at(0).name, "test") << "without names the file's";
}

TEST(ReadObj, reads_the_touchable_side_of_faces_from_a_comment) {
    const Reading reading = read(kSquare +
                                 "f 1 2 3\n#touch_side front\nf 1 3 4\n# touch_side back\nf 1 2 4\n#touch_side "
                                 "back\r\nf 2 3 4\n#touch_side BOTH\nf 1 2 3 4\n#touch_side up\n");
    ASSERT_EQ(reading.scene.triangles.size(), 6U);
    const std::vector<TouchSide> expected{TouchSide::Both, TouchSide::Front, TouchSide::Front,
                                          TouchSide::Back, TouchSide::Both,  TouchSide::Both};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(reading.scene.triangles[i].side, expected[i]) << i;
    ASSERT_EQ(reading.said.size(), 1U);
    EXPECT_THAT(reading.said[0], HasSubstr("\"up\" is not one of these: both, front, back"));
}

TEST(ReadObj, cuts_concave_polygons_into_triangles_by_ear_clipping) {
    // An arrow head with an area of 3 units. No triangle may cover the notch around (1, 0.5).
    const Reading reading = read("v 0 0 0\nv 1 1 0\nv 2 0 0\nv 1 4 0\nf 1 2 3 4\n");
    EXPECT_EQ(reading.scene.triangles.size(), 2U);
    EXPECT_DOUBLE_EQ(area(reading.scene), 3.0);
}

TEST(ReadObj, covers_random_star_shaped_polygons_exactly_in_both_orientations) {
    for (int seed = 0; seed < test::scaled(200); ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(static_cast<unsigned>(seed));
        std::uniform_real_distribution<double> radius(0.2, 2.0);
        const int corners = 3 + seed % 20, plane = seed % 3;
        std::string text, face = "f";
        double expected = 0.0;
        Vec2 first{0.0}, last{0.0};
        for (int i = 0; i < corners; ++i) {
            const double r = radius(random), turn = 2.0 * kPi * i / corners * (seed % 2 ? 1.0 : -1.0);
            const Vec2 p{r * std::cos(turn), r * std::sin(turn)};
            text += plane == 0   ? fmt::format("v {} {} 1\n", p.x, p.y)
                    : plane == 1 ? fmt::format("v 1 {} {}\n", p.x, p.y)
                                 : fmt::format("v {} 1 {}\n", p.x, p.y);
            face += fmt::format(" {}", i + 1);
            if (i == 0) first = p;
            else expected += 0.5 * (last.x * p.y - last.y * p.x);
            last = p;
        }
        expected = std::abs(expected + 0.5 * (last.x * first.y - last.y * first.x));
        const Reading reading = read(text + face + "\n");
        EXPECT_EQ(reading.scene.triangles.size(), static_cast<std::size_t>(corners - 2));
        EXPECT_NEAR(area(reading.scene), expected, 1e-9);
    }
}

TEST(ReadObj, accepts_negative_indices_all_line_endings_and_continued_lines) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        std::string text =
            "v 0 0 0" + end + "v 1 0 0" + end + "v 0 1 0 # corner" + end + "f -3 \\" + end + "-2 -1" + end + "f 1 2 9";
        const Reading reading = read(text);
        EXPECT_EQ(reading.scene.triangles.size(), 1U);
        EXPECT_THAT(reading.said, ElementsAre("test.obj, line 6, column 7: warning: there is no point 9; "
                                              "points read so far: 3. The face was left out."));
    }
}

TEST(ReadObj, reports_bad_indices_and_numbers_by_line_and_loads_the_rest) {
    const Reading reading = read(kSquare +
                                 "v nan 0 0\nv 1 2\nv 1e7 0 0\nf 1 2 3\nf 1 2 5\nf 0 1 2\nf 1 2 "
                                 "-9\nf 1 2\nf 1 x 3\nf 1 2 99999999999999999999\nf 1 3 4\n");
    EXPECT_EQ(reading.scene.triangles.size(), 2U);
    EXPECT_THAT(reading.said,
                ElementsAre(HasSubstr("line 5, column 3: warning: expected a number of at most a "
                                      "million, found \"nan\""),
                            HasSubstr("line 6, column 1: warning: this point has fewer"), HasSubstr("line 7, column 3"),
                            HasSubstr("line 9, column 7: warning: point 5 is damaged"),
                            HasSubstr("line 10, column 3: warning: there is no point 0"),
                            HasSubstr("line 11, column 7: warning: there is no point -9"),
                            HasSubstr("line 12, column 1: warning: this face has 2 corners"),
                            HasSubstr("line 13, column 5: warning: expected the number of a "
                                      "point, found \"x\""),
                            HasSubstr("line 14, column 7")));
    EXPECT_THAT(reading.scene.report.left_out, ElementsAre("6 damaged faces were left out."));
}

TEST(ReadObj, keeps_degenerate_duplicate_and_crossing_faces) {
    const Reading reading = read(kSquare + "f 1 1 2\nf 1 2 3\nf 1 2 3\nf 3 2 1\n");
    EXPECT_THAT(reading.said, IsEmpty());
    EXPECT_EQ(reading.scene.triangles.size(), 4U);
}

TEST(ReadObj, names_features_by_object_and_group_and_surfaces_by_material) {
    const Reading reading = read(kSquare +
                                 "o Kitchen_Table.001\nusemtl Wood\nf 1 2 3\nusemtl "
                                 "t_brick_2\nf 1 3 4\ng Lamp\nusemtl none\nf 1 2 4\n");
    ASSERT_EQ(reading.scene.features.size(), 2U);
    EXPECT_EQ(reading.scene.features[0].name, "Kitchen Table");
    EXPECT_EQ(spoken_name(reading.scene, reading.scene.triangles[2].feature), "Lamp");
    EXPECT_EQ(reading.scene.material(reading.scene.triangles[0].material).name, "wood");
    EXPECT_FALSE(reading.scene.material(reading.scene.triangles[0].material).guessed);
    EXPECT_EQ(reading.scene.material(reading.scene.triangles[1].material).name, "brick");
    EXPECT_TRUE(reading.scene.material(reading.scene.triangles[1].material).guessed);
    EXPECT_EQ(reading.scene.triangles[2].material, kDefaultMaterial);
    ReadOptions plain;
    plain.guess_materials = false;
    EXPECT_EQ(read(kSquare + "usemtl t_brick_2\nf 1 2 3\n", plain).scene.materials.size(), 1U);
}

// Expects a valid Scene, or an error with a sentence.
void expect_whole(const Result<Scene>& scene) {
    EXPECT_TRUE(scene ? validate(*scene).has_value() : !scene.error().message.empty());
}

TEST(ReadObj, survives_damage_at_any_place) {
    const std::string whole = kSquare + "o A\nusemtl wood\nf 1 2 3 4\nf -1 -2 \\\n-3\n";
    for (std::size_t length = 0; length <= whole.size(); ++length)
        expect_whole(read_obj(std::string_view(whole).substr(0, length), "cut.obj"));
}

}  // namespace obj_test
}  // namespace handrail
