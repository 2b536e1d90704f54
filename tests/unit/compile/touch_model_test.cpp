// Tests the counts and descriptions of what the hand can touch in a world, in every language.
#include "haptic/compile/touch_model.h"

#include <set>

#include "haptic/compile/prepare_mesh.h"
#include "haptic/compile/round_edges.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/spoken_language.h"

namespace handrail::test {
namespace touch_model_test {
using testing::ElementsAre;

TEST(TouchModelWords, exist_in_every_language_and_for_nothing_else) {
    const TouchModel model = touch_model(HapticScene{});
    std::set<std::string> known;
    for (const TouchModel::Part& part : model.parts) known.insert("touch_part." + std::string(part.key));
    for (const auto* stages : {&model.stages_on, &model.stages_off})
        for (std::string stage : std::vector<std::string>(stages->begin(), stages->end())) {
            std::replace(stage.begin(), stage.end(), ' ', '_');
            known.insert("touch_stage." + stage);
        }
    EXPECT_GT(known.size(), 20U);
    for (const LanguageName& language : bundled_languages()) {
        std::set<std::string> listed;
        for (const auto& [key, text] : bundled_texts(language.code))
            if (key.starts_with("touch_part.") || key.starts_with("touch_stage.")) listed.insert(key);
        EXPECT_EQ(listed, known) << language.code;
    }
}

TEST(TouchModelWords, have_correct_singular_and_plural) {
    EXPECT_EQ(spoken_part({"liquids_with_drag", 1}), "1 liquid with drag");
    EXPECT_EQ(spoken_part({"triangles", 12345}), "12345 triangles");
    const InLanguage german("de");
    EXPECT_EQ(spoken_part({"bodies", 1}), "1 beweglicher Körper");
    EXPECT_EQ(spoken_part({"triangles", 12345}), "12345 Dreiecke");
    EXPECT_EQ(spoken_stage("liquid surfaces"), "Oberflächen von Flüssigkeiten");
}

TEST(CompileReports, are_whole_sentences_in_german) {
    const InLanguage german("de");
    MeshReport mesh;
    mesh.points_welded = 1;
    mesh.farthest_weld_m = 0.000123;
    mesh.merged = 1200;
    mesh.polygons = 1;
    mesh.flat_measured_m = 1e-15;
    mesh.flat_bound_m = 0.00125;
    EXPECT_THAT(mesh.sentences(),
                ElementsAre("Ein Punkt wurde um höchstens 0,12 Millimeter auf einen anderen verschoben.",
                            "1200 Dreiecke wurden zu einem ebenen Vieleck verbunden, höchstens 0 Millimeter aus der "
                            "Ebene (Grenze 1,25 Millimeter)."));
    RoundingReport rounding;
    rounding.radius_m = 0.05;
    rounding.rounded = 2;
    rounding.less = 1;
    rounding.too_thin = 3;
    rounding.thin_names = {"Tisch", "Stuhl"};
    EXPECT_THAT(rounding.sentences(),
                ElementsAre("Kanten von 2 Körpern fühlen sich rund an, mit einem Radius von 0,05 Metern in der Welt; "
                            "einer davon ist dünn und "
                            "weniger rund.",
                            "3 Körper behalten scharfe Kanten: zu dünn zum Runden (Tisch, Stuhl und andere)."));
}

}  // namespace touch_model_test
}  // namespace handrail::test
