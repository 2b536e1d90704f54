// Tests names, which the program stores in English and announces in the user's language. The program must announce a
// name that the map gives unchanged.
#include <filesystem>
#include <set>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/spoken_language.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/lint.h"
#include "worlds/scene/models.h"
#include "worlds/scene/surfaces.h"

namespace handrail {
namespace spoken_names_test {

std::string key_of(std::string section, std::string_view name) {
    for (const char c : name) section += c == ' ' || c == '-' ? '_' : c;
    return section;
}

std::set<std::string> keys_in(const std::string& section) {
    std::set<std::string> keys;
    for (const auto& [key, text] : bundled_texts("en"))
        if (key.starts_with(section)) keys.insert(key);
    return keys;
}

TEST(SpokenNames, exist_for_every_material_and_for_no_other) {
    std::set<std::string> materials;
    for (const MaterialSpec& spec : material_library()) {
        materials.insert(key_of("material.", spec.name));
        EXPECT_EQ(spoken_material(spec.name), spec.name) << "English says what maps write";
    }
    EXPECT_EQ(keys_in("material."), materials);
}

TEST(SpokenNames, of_kinds_are_keyed_by_their_names_in_files) {
    for (const auto& [key, text] : bundled_texts("en")) {
        const bool name = key.starts_with("kind.") && key != "kind.with_material" && key != "kind.stairs";
        EXPECT_TRUE(!name || key == key_of("kind.", text)) << key;
    }
    for (const char* bearing :
         {"north", "north-east", "east", "south-east", "south", "south-west", "west", "north-west"})
        for (const std::string& name : {std::string(bearing) + " wall", "slope rising " + std::string(bearing)})
            EXPECT_TRUE(has_phrase(key_of("kind.", name))) << name;
    for (const double wide : {0.1, 0.3, 1.0, 3.0})
        for (const double high : {0.05, 0.3, 1.1, 3.0}) {
            const std::string name = shape_name({{0, 0, 0}, {wide, wide, high}});
            EXPECT_TRUE(has_phrase(key_of("kind.", name))) << name;
            EXPECT_TRUE(has_phrase(key_of("kind.", "hanging " + name))) << name;
        }
    for (const std::string_view name : kPrimitiveNames) EXPECT_TRUE(has_phrase(key_of("kind.", name))) << name;
}

TEST(SpokenNames, exist_for_everything_that_the_readers_name_in_the_bundled_worlds) {
    const std::filesystem::path root(test::project_root());
    std::size_t made = 0;
    for (const char* folder : {"worlds/maps", "tests/scenarios/worlds"})
        for (const auto& entry : std::filesystem::directory_iterator(root / folder)) {
            if (entry.path().extension() != ".map") continue;
            const auto scene = read_world(entry.path());
            ASSERT_TRUE(scene) << entry.path();
            for (const Feature& feature : scene->features) {
                made += feature.made_name;
                EXPECT_TRUE(!feature.made_name || has_phrase(key_of("kind.", feature.name)))
                    << entry.path() << ": " << feature.name;
            }
        }
    EXPECT_GT(made, 100U);
}

TEST(SpokenNames, are_german_in_german_but_unchanged_in_files) {
    test::SceneBuilder b;
    const FeatureId wall =
        b.box({0, 0, 0}, {4, 0.2, 3}, "north-east wall", SolidRole::Solid, "steel grille", FeatureKind::Wall);
    const FeatureId named = b.box({0, 1, 0}, {4, 1.2, 3}, "north wall", SolidRole::Solid, "wood", FeatureKind::Wall);
    b.scene().features[wall.value].made_name = true;
    const test::InLanguage german("de");
    EXPECT_EQ(spoken_name(b.scene(), wall), "Nordostwand, Stahlgitter");
    EXPECT_EQ(stored_name(b.scene(), wall), "north-east wall, steel grille");
    EXPECT_EQ(spoken_name(b.scene(), named), "north wall, Holz") << "the map's own name";
    EXPECT_EQ(spoken_name(b.scene().features[wall.value]), "Nordostwand");
    EXPECT_EQ(spoken_kind("low block"), "niedriger Block");
    EXPECT_EQ(spoken_kind("frobnicator"), "frobnicator");
    EXPECT_EQ(compass_word(kPi / 4.0), "Nordosten");
    EXPECT_EQ(compass_point(kPi / 4.0), "north-east");
}

TEST(SpokenNames, appear_in_german_error_sentences) {
    const test::InLanguage german("de");
    Primitive ball;
    ball.kind = PrimitiveKind::Sphere;
    ball.size_m = {1, 2, 1};
    const auto stretched = primitive_model(ball);
    ASSERT_FALSE(stretched);
    EXPECT_EQ(stretched.error().message,
              "Kugel: muss rund bleiben und darum in jeder runden Richtung gleich stark gedehnt werden.");
    const auto unknown = with_placed(*test::SceneBuilder().share(), "Kiste", *box_model({1, 1, 1}), {}, "plastr");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().message, "Das Material „plastr“ gibt es nicht. Der ähnlichste Name ist plaster.");
}

}  // namespace spoken_names_test
}  // namespace handrail
