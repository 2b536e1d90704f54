// Tests furniture for which a file states the kind and the place but no shape.
#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/unit/ifc/ifc_text.h"
#include "worlds/ifc/ifc_scene.h"
#include "worlds/scene/honest_report.h"

namespace handrail {
namespace prefabs_test {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

// Returns a placement at (x, y). The ids of the instances begin at `id`. #13 is the placement of the building, at zero.
std::string placed(int id, double x, double y) {
    return fmt::format(
        "#{0}=IFCCARTESIANPOINT(({2},{3},0.));\n#{1}=IFCAXIS2PLACEMENT3D(#{0},$,$);\n"
        "#{4}=IFCLOCALPLACEMENT(#13,#{1});\n",
        id, id + 1, x, y, id + 2);
}

Scene scene_of(const std::string& more) {
    const std::string text = test::with_instances(
        test::replaced(test::small_house(), "FILE_SCHEMA(('IFC2X3'))", "FILE_SCHEMA(('IFC4'))"), more);
    Result<Scene> scene = read_ifc(text, "house.ifc");
    EXPECT_TRUE(scene.has_value()) << scene.error().sentence();
    if (!scene) return {};
    EXPECT_TRUE(validate(*scene).has_value());
    return std::move(*scene);
}

const Feature* called(const Scene& scene, const std::string& name) {
    const auto found = std::find_if(scene.features.begin(), scene.features.end(),
                                    [&](const Feature& feature) { return feature.name == name; });
    return found == scene.features.end() ? nullptr : &*found;
}

TEST(IfcPrefabs, appear_if_a_file_gives_a_kind_and_a_place_but_no_shape) {
    const Scene scene = scene_of(
        placed(1000, 2.0, 2.0) + "#1003=IFCSANITARYTERMINAL('p1',$,'fixture 12',$,$,#1002,$,$,.TOILETPAN.);\n" +
        placed(1010, 5.0, 1.0) +
        "#1013=IFCFURNISHINGELEMENT('p2',$,'B-7',$,$,#1012,$,$);\n"
        "#1014=IFCFURNITURETYPE('t1',$,'Schreibtisch 140',$,$,$,$,$,$,.NOTDEFINED.,.NOTDEFINED.);\n"
        "#1015=IFCRELDEFINESBYTYPE('r1',$,$,$,(#1013),#1014);\n" +
        placed(1020, 1.0, 3.0) + "#1023=IFCTRANSPORTELEMENT('p3',$,'L1',$,$,#1022,$,$,.ELEVATOR.);\n");
    // A toilet at (2, 2): its pan in front, its cistern behind.
    EXPECT_TRUE(test::in_a_solid(scene, {2.0, 2.1, 0.2}));
    EXPECT_TRUE(test::in_a_solid(scene, {2.0, 1.75, 0.7}));
    EXPECT_FALSE(test::in_a_solid(scene, {2.0, 2.1, 0.6}));
    // A desk at (5, 1): its top, and free space below.
    EXPECT_TRUE(test::in_a_solid(scene, {5.3, 1.1, 0.72}));
    EXPECT_FALSE(test::in_a_solid(scene, {5.0, 1.1, 0.4}));
    // A lift's cabin at (1, 3): its back, and free space inside.
    EXPECT_TRUE(test::in_a_solid(scene, {1.0, 3.0 - 0.725, 1.0}));
    EXPECT_FALSE(test::in_a_solid(scene, {1.0, 3.0, 1.0}));
    EXPECT_EQ(scene.stated->furnishings.size(), 2U);
    EXPECT_EQ(scene.stated->lifts, 1);
    const Feature* desk = called(scene, "B-7");
    ASSERT_NE(desk, nullptr) << "as the file calls it";
    EXPECT_EQ(scene.material(desk->material).name, "wood");
    EXPECT_THAT(scene.report.guessed, Contains(HasSubstr("3 pieces of furniture")));
    EXPECT_THAT(scene.report.guessed, Contains(HasSubstr("desk, lift cabin, toilet")));
    EXPECT_EQ(honest_report(scene).guessed, static_cast<int>(scene.report.guessed.size()));
    const auto lift = std::find_if(scene.stated->portals.begin(), scene.stated->portals.end(),
                                   [](const StatedPortal& portal) { return portal.kind == StatedPortalKind::Lift; });
    ASSERT_NE(lift, scene.stated->portals.end());
    EXPECT_EQ(lift->rooms.size(), 1U) << "how far up it goes is not known";
}

TEST(IfcPrefabs, are_omitted_without_a_place_or_a_kind_and_if_the_file_gives_a_shape) {
    const Scene plain = scene_of("");
    const Scene scene =
        scene_of("#1003=IFCFURNISHINGELEMENT('p1',$,'a chair of no place',$,$,$,$,$);\n" + placed(1010, 5.0, 1.0) +
                 "#1013=IFCFURNISHINGELEMENT('p2',$,'Model 7',$,$,#1012,$,$);\n" + placed(1020, 5.0, 3.0) +
                 "#1023=IFCFURNISHINGELEMENT('p3',$,'Table lamp',$,$,#1022,$,$);\n" + placed(1030, 5.0, 3.0) +
                 "#1033=IFCWALL('p4',$,'chair rail',$,$,#1032,$,$);\n" + placed(1040, 2e9, 3.0) +
                 "#1043=IFCFURNISHINGELEMENT('p5',$,'far chair',$,$,#1042,$,$);\n");
    EXPECT_EQ(scene.solids.size(), plain.solids.size());
    EXPECT_THAT(scene.report.guessed, Not(Contains(HasSubstr("of furniture"))));
    EXPECT_TRUE(called(plain, "Table") != nullptr) << "which has a form of its own";
}

TEST(IfcPrefabs, are_recognised_by_words_of_two_languages) {
    const auto kind = [](const std::vector<std::string>& words) {
        const Prefab* prefab = prefab_for(words);
        return prefab ? std::string(prefab->name) : std::string();
    };
    EXPECT_EQ(kind({"WASHHANDBASIN"}), "basin");
    EXPECT_EQ(kind({"NOTDEFINED", "Bürostuhl drehbar"}), "chair");
    EXPECT_EQ(kind({"", "M_Sofa-Pensi:1650mm"}), "sofa");
    EXPECT_EQ(kind({"Herd"}), "stove");
    EXPECT_EQ(kind({"Schafherde"}), "");
    EXPECT_EQ(kind({"BATH"}), "bathtub");
    EXPECT_EQ(kind({"bathroom cabinet"}), "");
    EXPECT_EQ(kind({"Wheelchair place"}), "");
    EXPECT_EQ(kind({"ELEVATOR"}), "lift_cabin");
    EXPECT_EQ(kind({}), "");
}

}  // namespace prefabs_test
}  // namespace handrail
