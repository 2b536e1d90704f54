// What a unit is long where the file does not say.
#include "worlds/readers/units.h"

#include <gmock/gmock.h>

#include "tests/support/temporary_folder.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace units_test {

using testing::HasSubstr;

// A single floor of that many units.
std::string floor_of(double wide, double deep) {
    return fmt::format("v 0 0 0\nv {0} 0 0\nv {0} {1} 0\nv 0 {1} 0\nf 1 2 3 4\n", wide, deep);
}

TEST(Units, are_named_as_people_write_them) {
    EXPECT_EQ(unit_named("mm"), 0.001);
    EXPECT_EQ(unit_named("m"), 1.0);
    EXPECT_EQ(unit_named("inch"), 0.0254);
    EXPECT_EQ(unit_named("feet"), 0.3048);
    EXPECT_EQ(unit_named("0.5"), 0.5);
    for (const char* word : {"", "0", "-1", "nan", "inf", "parsec", "1 m"}) EXPECT_FALSE(unit_named(word)) << word;
}

TEST(Units, are_asked_about_where_the_world_would_be_wider_than_two_kilometres_or_narrower_than_two_metres) {
    const test::TemporaryFolder folder;
    const auto first_warning = [&](double wide, double deep, const ReadOptions& options = {}) -> std::string {
        const auto scene = read_world(folder.write("flat.obj", floor_of(wide, deep)), options);
        if (!scene) return scene.error().sentence();
        return scene->report.warnings.empty() ? "" : scene->report.warnings.front().sentence();
    };
    const std::string large = first_warning(60'000, 40'000);
    EXPECT_THAT(large, HasSubstr("Read as it is, the world is 60000 metres wide; in millimetres it would be 60 metres, "
                                 "in inches 1520, in feet 18300."));
    EXPECT_THAT(large, HasSubstr("--unit"));
    EXPECT_THAT(first_warning(1.5, 1.0), HasSubstr("the world is 1.5 metres wide"));
    EXPECT_EQ(first_warning(2.0, 1.0), "");
    EXPECT_EQ(first_warning(2000.0, 1.0), "");
    ReadOptions known;
    known.unit_is_known = true;
    EXPECT_EQ(first_warning(60'000, 40'000, known), "");
}

TEST(Units, of_a_mesh_are_what_a_person_says) {
    ReadOptions options;
    options.obj_metres_per_unit = 0.001;
    options.unit_is_known = true;
    const test::TemporaryFolder folder;
    const auto scene = read_world(folder.write("flat.obj", floor_of(60'000, 40'000)), options);
    ASSERT_TRUE(scene);
    EXPECT_NEAR(scene->bounds_m.size_m().x, 60.0, 1e-9);
    EXPECT_NEAR(scene->bounds_m.size_m().y, 40.0, 1e-9);
    EXPECT_EQ(scene->metres_per_unit, 0.001);
}

}  // namespace units_test
}  // namespace handrail
