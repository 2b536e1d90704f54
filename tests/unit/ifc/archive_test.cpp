// Tests models in a ZIP archive.
#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/support/real_worlds.h"
#include "tests/support/zip_text.h"
#include "tests/unit/ifc/ifc_text.h"

namespace handrail {
namespace archive_test {

using ::testing::HasSubstr;

TEST(IfcArchive, is_read_like_the_building_that_it_contains) {
    const test::TemporaryFolder folder;
    const std::string zip = test::zipped({{"model/House.IFC", test::small_house()}, {"model/.ifc", "x"}}, true);
    for (const char* name : {"house.ifczip", "HOUSE.IFCZIP"}) {
        const Result<Scene> scene = read_world(folder.write(name, zip));
        ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
        EXPECT_EQ(scene->report.format, "ifc");
        EXPECT_EQ(scene->source_file, name);
        EXPECT_EQ(scene->stated->rooms.size(), 2U);
    }
    const Result<Scene> by_content =
        read_world(folder.write("house.zip", test::zipped({{"house.ifc", test::small_house()}}, true)));
    ASSERT_TRUE(by_content.has_value()) << by_content.error().sentence();
}

TEST(IfcArchive, that_is_not_a_single_model_is_reported_in_one_sentence) {
    const auto reported = [](const std::string& bytes) {
        const Result<Scene> scene = read_ifczip(bytes, "a.ifczip");
        return scene ? std::string("a world") : scene.error().sentence();
    };
    EXPECT_THAT(reported(test::zipped({{"house.ifcxml", "<ifc/>"}})), HasSubstr("no .ifc file"));
    EXPECT_THAT(reported(test::zipped({{"a.ifc", "x"}, {"b.ifc", "y"}})), HasSubstr("contains 2 .ifc files"));
    EXPECT_THAT(reported(test::zipped({{"a.ifc", "no model"}})), HasSubstr("a.ifczip"));
    const std::string whole = test::zipped({{"a.ifc", test::small_house()}}, true);
    for (std::size_t at = 0; at < whole.size(); at += 7)
        EXPECT_THAT(reported(whole.substr(0, at)), HasSubstr("damaged")) << "cut at " << at;
}

TEST(IfcArchive, is_read_for_the_institute_without_unpacking) {
    const auto path = test::real_world("institute.ifczip");
    if (!path) GTEST_SKIP() << test::needs_real_world("institute.ifczip");
    const Result<Scene> scene = read_world(*path);
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_EQ(scene->stated->rooms.size(), 82U);
    EXPECT_EQ(scene->stated->openings, 287);
    EXPECT_EQ(scene->stated->openings_cut, 287);
    for (const StatedPortal& portal : scene->stated->portals) EXPECT_TRUE(portal.passable) << portal.name;
}

}  // namespace archive_test
}  // namespace handrail
