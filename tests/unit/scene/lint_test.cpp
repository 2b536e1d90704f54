// Tests the material library, and the check that a hand can distinguish the materials of a world.
#include "worlds/scene/lint.h"

#include <set>

#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace lint_test {

using test::box_brush;
using test::entity;
using test::key;

Scene read(const std::string& text) {
    Result<Scene> scene = read_quake_map(text, "test.map");
    EXPECT_TRUE(scene.has_value());
    return scene ? std::move(*scene) : Scene{};
}

// Returns panel number `place` of a row. Panels are 0.6 m wide and 1 m apart.
std::string panel(int place, const std::string& material, const std::string& keys = {}) {
    const int x = 32 * place;
    return entity("func_wall", key("material", material) + key("name", material + " panel") + keys,
                  box_brush(x, 0, 0, x + 20, 4, 20));
}

TEST(MaterialLibrary, any_two_can_be_distinguished_by_touch) {
    const auto library = material_library();
    for (std::size_t a = 0; a < library.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            EXPECT_TRUE(are_distinguishable(finish_of(library[a]), finish_of(library[b])))
                << library[a].name << " and " << library[b].name;
}

TEST(MaterialLibrary, has_four_steps_of_stiffness_with_one_sound_each_and_no_stick_slip) {
    std::set<double> steps;
    std::set<SoundClass> sounds;
    for (const MaterialSpec& spec : material_library()) {
        steps.insert(spec.stiffness_fraction);
        sounds.insert(spec.sound);
        EXPECT_GE(spec.friction_static, spec.friction_mu) << spec.name;
        EXPECT_LE(spec.friction_static, kMostStaticOverKinetic * spec.friction_mu * (1 + 1e-9)) << spec.name;
        EXPECT_NE(spec.sound, SoundClass::Generic) << spec.name;
        EXPECT_NE(spec.sound, SoundClass::Water) << spec.name;
        EXPECT_LE(spec.stiffness_fraction, 1.0);
    }
    EXPECT_LE(steps.size(), 4U);
    double last = 0.0;
    for (const double step : steps) {
        EXPECT_GE(step, kStiffnessApart * last) << step;
        last = step;
    }
    EXPECT_EQ(sounds.size(), material_library().size());
    for (const std::string_view name : {"concrete", "wood", "carpet", "rubber", "steel grille", "glass", "plaster",
                                        "brick", "tile", "ice", "sand", "stone", "plastic"})
        EXPECT_NE(find_material(name), nullptr) << name;
}

TEST(Lint, accepts_five_materials_of_the_library) {
    const LintReport report = lint_materials(read(panel(0, "concrete") + panel(1, "wood") + panel(2, "carpet") +
                                                  panel(3, "rubber") + panel(4, "steel grille")));
    EXPECT_TRUE(report.problems.empty()) << report.problems.front();
    EXPECT_TRUE(report.warnings.empty());
}

TEST(Lint, names_the_pair_of_materials_that_a_changed_stiffness_makes_alike) {
    // The stiffness of rubber is 0.3. The wood's 0.32 is within 10 % of that.
    const LintReport report = lint_materials(read(panel(0, "concrete") + panel(1, "wood", key("stiffness", "0.32")) +
                                                  panel(2, "carpet") + panel(3, "rubber")));
    ASSERT_EQ(report.problems.size(), 1U);
    EXPECT_EQ(report.problems[0],
              "Wood and rubber cannot be told apart by touch: stiffness 0.32 and 0.3, friction 0.45 and 0.6. Give "
              "rubber a stiffness of 0.24 or less, give rubber a "
              "friction of 0.68 or more, or give one of them a texture.");
    // If the author follows the advice, the warning must disappear.
    EXPECT_TRUE(
        lint_materials(read(panel(1, "wood", key("stiffness", "0.32")) + panel(3, "rubber", key("stiffness", "0.24"))))
            .problems.empty());
    EXPECT_TRUE(
        lint_materials(read(panel(1, "wood", key("stiffness", "0.32")) + panel(3, "rubber", key("friction", "0.68"))))
            .problems.empty());
}

TEST(Lint, ignores_materials_of_intangible_or_unnamed_things) {
    EXPECT_TRUE(lint_materials(read(panel(0, "rubber") + entity("func_illusionary",
                                                                key("material", "wood") + key("stiffness", "0.3"),
                                                                box_brush(50, 0, 0, 60, 9, 9))))
                    .problems.empty());
    EXPECT_TRUE(
        lint_materials(read(panel(0, "rubber") + entity("func_wall", key("stiffness", "0.3") + key("friction", "0.6"),
                                                        box_brush(50, 0, 0, 60, 9, 9))))
            .problems.empty());
    Scene nothing;
    nothing.materials.resize(1);
    EXPECT_TRUE(lint_materials(nothing).problems.empty());
}

TEST(Lint, warns_above_five_materials_in_one_view_but_not_if_they_are_far_apart) {
    const std::vector<std::string> six{"concrete", "wood", "carpet", "rubber", "steel grille", "glass"};
    std::string near, apart;
    for (int i = 0; i < 6; ++i) {
        near += panel(i, six[static_cast<std::size_t>(i)]);
        apart += panel(12 * i, six[static_cast<std::size_t>(i)]);
    }
    const LintReport report = lint_materials(read(near));
    EXPECT_TRUE(report.problems.empty());
    ASSERT_EQ(report.warnings.size(), 1U);
    EXPECT_NE(report.warnings[0].find("6 materials"), std::string::npos);
    EXPECT_TRUE(lint_materials(read(apart)).warnings.empty());
}

}  // namespace lint_test
}  // namespace handrail
