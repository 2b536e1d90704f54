// Tests the readers' messages in another language. They must be whole sentences with that language's numbers and word
// order.
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/readers/reading.h"

namespace handrail::test {
namespace german_test {
using testing::ElementsAre;
using testing::HasSubstr;

TEST(ReadersInGerman, report_what_is_wrong_with_a_key_and_how_it_is_handled) {
    const InLanguage german("de");
    const Reading reading = reading_of(read_quake_map(
        entity("worldspawn", {}, box_brush(0, 0, -8, 320, 320, 0)) +
            entity("func_wall", key("friction", "2.5") + key("material", "wod"), box_brush(0, 0, 0, 16, 16, 64)),
        "haus.map", {}));
    ASSERT_EQ(reading.said.size(), 2U);
    EXPECT_THAT(
        reading.said[0],
        HasSubstr("Warnung: Der Wert 2,5 des Schlüssels friction liegt außerhalb. Möglich: 0 bis 2. Es gilt 2."));
    EXPECT_THAT(reading.said[1],
                HasSubstr("Warnung: Das Material „wod“ gibt es nicht. Am ähnlichsten ist wood. Es gilt die Vorgabe."));
}

TEST(ReadersInGerman, report_where_a_file_ends_too_early) {
    const InLanguage german("de");
    const Result<Scene> scene = read_quake_map("{\n\"classname\" \"worldspawn\"\n{\n( 0 0 0 ) ( 1 0 ", "haus.map", {});
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().sentence(),
              "haus.map, Zeile 4, Spalte 17: In dieser Karte ist nichts zu berühren. 3 Probleme; das erste: Eine "
              "Fläche endet zu früh. Erwartet: eine Zahl in "
              "Punkt 2; gefunden: das Ende der Datei.");
}

TEST(ReadersInGerman, report_on_meshes_and_on_files_that_are_not_worlds) {
    const InLanguage german("de");
    const Reading reading = reading_of(read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n", "lampe.obj", {}));
    EXPECT_THAT(reading.said, ElementsAre("lampe.obj, Zeile 5, Spalte 7: Warnung: Punkt 9 gibt es nicht; bisher wurden "
                                          "3 gelesen. Die Fläche wurde ausgelassen."));
    EXPECT_THAT(reading.scene.report.left_out, ElementsAre("Eine beschädigte Fläche wurde ausgelassen."));
    const Result<Scene> none = read_obj("# leer\n", "lampe.obj", {});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().sentence(), "lampe.obj: In diesem Netz ist nichts zu berühren. Es enthält keine Flächen.");
}

TEST(EffectNames, exist_in_every_language_and_for_no_other_effect) {
    for (const LanguageName& language : bundled_languages()) {
        const InLanguage spoken(language.code);
        for (const EffectSpec& row : effect_table())
            EXPECT_TRUE(has_phrase("effect_name." + std::string(row.name))) << language.code << ": " << row.name;
        for (const auto& [key, text] : bundled_texts(language.code)) {
            if (!key.starts_with("effect_name.")) continue;
            EXPECT_NE(find_effect(key.substr(12)), nullptr) << language.code << ": " << key;
        }
    }
}

}  // namespace german_test
}  // namespace handrail::test
