// Tests every case that real editors, other games and accidents may leave in a .map file.
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/readers/reading.h"
#include "worlds/readers/map_syntax.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace map_edge_cases_test {

using test::box_brush;
using test::entity;
using test::key;
using test::Reading;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kCube = box_brush(0, 0, 0, 64, 64, 64), kOther = box_brush(128, 0, 0, 192, 64, 64),
                  kThird = box_brush(256, 0, 0, 320, 64, 64);

Reading read(const std::string& text) { return test::reading_of(read_quake_map(text, "test.map")); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

TEST(MapEdgeCases, both_kinds_of_comments_are_skipped_but_a_semicolon_in_a_texture_name_is_not_a_comment) {
    const std::string text = "// first\n; QuArK\n" + replaced(entity("worldspawn", "// between } {\n",
                                                                     box_brush(0, 0, 0, 64, 64, 64, "odd;name")),
                                                              "1 1\n", "1 1 //TX1\n; note\n");
    const Reading reading = read(text);
    EXPECT_THAT(reading.said, IsEmpty());
    EXPECT_EQ(reading.scene.solids.size(), 1U);
    Diagnostics diagnostics("test.map");
    EXPECT_EQ(parse_map(text, diagnostics).entities.at(0).brushes.at(0).faces.at(0).texture, "odd;name");
}

TEST(MapEdgeCases, any_line_endings_tabs_and_byte_order_marks_leave_line_numbers_correct) {
    const std::string text = replaced(entity("worldspawn", key("a", "1") + key("a", "2"), kCube), " ", "\t");
    for (const std::string end : {"\n", "\r\n", "\r"})
        for (const std::string mark : {"", "\xEF\xBB\xBF"}) {
            const Reading reading = read(mark + replaced(text, "\n", end));
            EXPECT_THAT(reading.said, ElementsAre("test.map, line 4, column 1: warning: the key \"a\" is "
                                                  "given twice. The last value was used."));
            EXPECT_EQ(reading.scene.solids.size(), 1U);
        }
    const Reading no_newline = read(text.substr(0, text.size() - 1));
    EXPECT_EQ(no_newline.scene.report.warnings_in_all, 1);
}

// The cost of cutting grows with the square of the number of faces. A brush with 12,000 faces once delayed the
// program's end by 18 s.
TEST(MapEdgeCases, a_brush_of_more_than_a_thousand_faces_is_omitted_and_reported) {
    const auto with_faces = [](int count) {
        std::string brush = kOther.substr(0, kOther.rfind('}'));
        for (int face = 6; face < count; ++face)
            brush += fmt::format("( {0} 0 0 ) ( {0} 0 1 ) ( {0} 1 0 ) wall 0 0 0 1 1\n", 300 + face);
        return brush + "}\n";
    };
    const Reading most = read(entity("worldspawn", {}, kCube + with_faces(1000)));
    EXPECT_EQ(most.scene.solids.size(), 2U);
    const Reading more = read(entity("worldspawn", {}, kCube + with_faces(1001)));
    EXPECT_EQ(more.scene.solids.size(), 1U);
    EXPECT_THAT(more.said, ElementsAre(HasSubstr("this brush has more than 1000 faces. It was left out.")));
}

TEST(MapEdgeCases, textures_may_have_any_name_up_to_white_space_or_in_quotes) {
    for (const std::string texture : {"{grille", "}odd", "*a", "+0slip", "#x", "a;b", "(paren", "!b", "a/b/c", "128",
                                      "__TB_empty", "//x", "\"with blanks\"", "\"say \\\"x\\\" y\"", "a)b", "[x"}) {
        const Reading reading = read(entity("worldspawn", {}, box_brush(0, 0, 0, 64, 64, 64, texture) + kOther));
        EXPECT_THAT(reading.said, IsEmpty()) << texture;
        EXPECT_EQ(reading.scene.solids.size(), 2U) << texture;
        EXPECT_EQ(reading.scene.report.polygons, 12) << texture;
    }
}

TEST(MapEdgeCases, escaped_quotes_and_trailing_backslashes_are_distinguished) {
    Diagnostics diagnostics("test.map");
    const MapFile file = parse_map(
        "{\n\"a\" \"say \\\"hi\\\"!\"\n\"wad\" \"c:\\a\\\"\n\"b\" "
        "\"x\\ny\"\n\"c\\\" \"d\\\" \"e\" \"f\"}",
        diagnostics);
    EXPECT_EQ(diagnostics.in_all(), 0);
    const MapEntity& only = file.entities.at(0);
    EXPECT_EQ(unquoted(only.value("a")), "say \"hi\"!");
    EXPECT_EQ(unquoted(only.value("wad")), "c:\\a\\");
    EXPECT_EQ(only.value("b"), "x\\ny");
    EXPECT_EQ(only.value("c\\"), "d\\");
    EXPECT_EQ(only.value("e"), "f");
}

TEST(MapEdgeCases, bytes_above_127_become_utf8_and_line_breaks_become_pauses) {
    EXPECT_EQ(read(entity("worldspawn", key("message", "Caf\xE9\\nB\xFCro"), kCube)).scene.name,
              "Caf\xC3\xA9, B\xC3\xBCro");
    EXPECT_EQ(read(entity("worldspawn", key("message", "Caf\xC3\xA9.\\n\\nOpen"), kCube)).scene.name,
              "Caf\xC3\xA9. Open");
    EXPECT_EQ(read(entity("worldspawn", {}, kCube)).scene.name, "test") << "without a message the file's name";
}

TEST(MapEdgeCases, numbers_may_have_signs_decimals_exponents_and_trailing_dots) {
    std::string brush = replaced(replaced(kCube, " 64 ", " +6.4e1 "), "( 0 ", "( -0. ");
    const Reading reading = read(entity("worldspawn", {}, brush));
    EXPECT_THAT(reading.said, IsEmpty());
    EXPECT_EQ(reading.scene.bounds_m.max_m, Vec3(2, 2, 2));
    const Reading off_grid =
        read(entity("worldspawn", {}, box_brush(0.1234567890123, 0.5, 1e-3, 63.9999999, 64.123, 64)));
    EXPECT_THAT(off_grid.said, IsEmpty());
    EXPECT_DOUBLE_EQ(off_grid.scene.bounds_m.min_m.x, 0.1234567890123 / 32);
    for (const std::string bad : {"nan", "inf", "-inf", "1e999", "0x10", "1,5", "--1"}) {
        const Reading damaged =
            read(entity("worldspawn", {}, kCube + replaced(kCube, "( 64 0 0 )", "( 64 " + bad + " 0 )")));
        EXPECT_EQ(damaged.scene.solids.size(), 1U) << bad;
        ASSERT_EQ(damaged.said.size(), 1U) << bad;
        EXPECT_THAT(damaged.said[0], testing::StartsWith("test.map, line 13, column 6: error: a face ends "
                                                         "early. Expected a number in point 1, found \"" +
                                                         bad + "\". This brush was left out; 1 brush was"))
            << bad;
    }
}

TEST(MapEdgeCases, a_face_with_collinear_points_costs_only_that_face) {
    const std::string line = "( 0 0 0 ) ( 1 1 1 ) ( 2 2 2 ) plain 0 0 0 1 1\n",
                      point = "( 5 5 5 ) ( 5 5 5 ) ( 5 5 5 ) plain 0 0 0 1 1\n";
    for (const std::string& bad : {line, point}) {
        const Reading reading = read(entity("worldspawn", {}, replaced(kCube, "}\n", bad + "}\n")));
        EXPECT_EQ(reading.scene.solids.size(), 1U);
        EXPECT_EQ(reading.scene.report.polygons, 6);
        EXPECT_THAT(reading.said, ElementsAre("test.map, line 10, column 1: warning: the three points of this "
                                              "face lie on one line. The brush was read without this face."));
    }
}

TEST(MapEdgeCases, open_empty_and_inside_out_brushes_are_reported_by_line_and_the_rest_loads) {
    std::string missing = kCube;
    missing.erase(missing.find("( 64 "), missing.find('\n', missing.find("( 64 ")) - missing.find("( 64 ") + 1);
    EXPECT_THAT(read(entity("worldspawn", {}, kCube + missing)).said,
                ElementsAre(HasSubstr("line 11, column 1: warning: this brush is not closed")));
    EXPECT_THAT(
        read(entity("worldspawn", {}, kCube + replaced(kCube, "}\n", "( 0 0 -9 ) ( 0 64 -9 ) ( 64 0 -9 ) t\n}\n")))
            .said,
        ElementsAre(HasSubstr("this brush has no volume. It was left out.")));
    EXPECT_THAT(read(entity("worldspawn", {}, kCube + "{\n}\n")).said,
                ElementsAre(HasSubstr("line 11, column 1: warning: this brush has no faces")));
    std::string turned;
    for (std::size_t at = 0; at < kCube.size();) {
        const std::size_t end = kCube.find('\n', at) + 1;
        std::string row = kCube.substr(at, end - at);
        if (row[0] == '(') {  // swaps the first two points
            const std::size_t first = row.find(')') + 2, second = row.find(')', first) + 2;
            row = row.substr(first, second - first) + row.substr(0, first) + row.substr(second);
        }
        turned += row;
        at = end;
    }
    const Reading inside_out = read(entity("worldspawn", {}, turned));
    EXPECT_THAT(inside_out.said, ElementsAre(HasSubstr("line 3, column 1: warning: this brush is "
                                                       "inside out. It was turned round.")));
    EXPECT_EQ(inside_out.scene.bounds_m.max_m, Vec3(2, 2, 2));
}

TEST(MapEdgeCases, faces_that_lose_their_area_are_dropped_and_counted_without_a_warning) {
    const std::string beyond = "( 0 0 90 ) ( 0 64 90 ) ( 64 0 90 ) plain 0 0 0 1 1\n";
    const Reading reading = read(entity("worldspawn", {}, replaced(kCube, "}\n", beyond + "}\n")));
    EXPECT_THAT(reading.said, IsEmpty());
    EXPECT_EQ(reading.scene.report.polygons, 6);
    EXPECT_THAT(reading.scene.report.simplified,
                ElementsAre("One face that repeats another or has no area was left out."));
    EXPECT_EQ(read(entity("worldspawn", {}, box_brush(0, 0, 0, 64, 64, 0.01))).scene.solids.size(), 1U)
        << "nearly flat";
}

TEST(MapEdgeCases, damaged_patches_of_other_games_are_skipped_to_their_brace_with_a_warning) {
    const std::string patch =
        "{\npatchDef2\n{\ncommon/{odd\n( 3 3 0 0 0 )\n(\n( "
        "( 0 0 0 0 0 ) ( 1 0 0 0 0 ) )\n)\n}\n}\n";
    const std::string primitive =
        "{\nbrushDef\n{\n( 0 0 0 ) ( 1 0 0 ) ( 0 1 0 ) "
        "( ( 1 0 0 ) ( 0 1 0 ) ) \"x\" 0 0 0\n}\n}\n";
    const Reading reading = read(entity("worldspawn", {}, patch + kCube + primitive + kOther));
    EXPECT_EQ(reading.scene.solids.size(), 2U);
    EXPECT_THAT(reading.said,
                ElementsAre(HasSubstr("more points in this row, according to the size of the curved patch"),
                            HasSubstr("is not closed")));
    EXPECT_EQ(reading.scene.report.brushes, 3);
    EXPECT_EQ(reading.scene.report.left_out.size(), 2U);
}

TEST(MapEdgeCases, standard_and_valve_faces_may_be_mixed_and_extra_numbers_are_not_errors) {
    std::string brush = kCube;
    brush.replace(brush.find("plain 0 0 0 1 1"), 15, "plain [ 0 1 0 -16 ] [ 0 0 -1 8.5e0 ] 45 1 1");
    brush.replace(brush.rfind("plain 0 0 0 1 1"), 15, "plain 0 0 0 1 1 134217728 0 0");
    const Reading reading = read(entity("worldspawn", {}, brush + replaced(kOther, "plain 0 0 0 1 1", "plain")));
    EXPECT_THAT(reading.said, IsEmpty());
    EXPECT_EQ(reading.scene.solids.size(), 2U);
}

TEST(MapEdgeCases, content_without_a_class_a_world_or_an_entity_is_accepted_and_reported) {
    EXPECT_THAT(read("{\n\"a\" \"b\"\n" + kCube + "}\n" + entity("worldspawn")).said,
                ElementsAre(HasSubstr("line 1, column 1: warning: this entity has no "
                                      "classname. Its brushes became part")));
    EXPECT_THAT(read(entity("func_wall", {}, kCube)).said, ElementsAre(HasSubstr("this map has no worldspawn")));
    EXPECT_THAT(read("{\n" + kCube + "\"classname\" \"worldspawn\"\n}\n").said, IsEmpty()) << "brushes before keys";
    const Reading bare = read(kCube + kOther);
    EXPECT_EQ(bare.scene.solids.size(), 2U);
    EXPECT_THAT(bare.said, testing::Contains(HasSubstr("brushes are outside any entity. They were "
                                                       "made part of the building itself.")));
}

TEST(MapEdgeCases, content_in_external_files_is_reported_as_missing) {
    EXPECT_THAT(read(entity("worldspawn", {}, kCube) + entity("misc_external_map", key("_external_map", "a.map"))).said,
                ElementsAre(HasSubstr("this entity stands for the contents of another "
                                      "file. That part is missing here.")));
}

TEST(MapEdgeCases, a_missing_brace_costs_at_most_one_brush) {
    const std::string whole = entity("worldspawn", {}, kCube + kOther + kThird);
    EXPECT_THAT(read(whole.substr(0, whole.rfind('}'))).said,
                ElementsAre(HasSubstr("the file ends inside the entity that begins in line 1. A "
                                      "closing brace is missing. Everything that was complete was kept.")));
    std::string open = whole;
    open.erase(open.find("}\n"), 2);  // removes the brace of the first brush
    const Reading reading = read(open);
    EXPECT_EQ(reading.scene.solids.size(), 3U);
    EXPECT_THAT(reading.said, ElementsAre(HasSubstr("the brush that begins in line 3 has no "
                                                    "closing brace. It was assumed to end here.")));
}

TEST(MapEdgeCases, the_report_lists_twenty_warnings_and_counts_all) {
    std::string brushes = kCube;
    for (int i = 0; i < 50; ++i) brushes += "{\n}\n";
    const Reading reading = read(entity("worldspawn", {}, brushes));
    EXPECT_EQ(reading.said.size(), 20U);
    EXPECT_EQ(reading.scene.report.warnings_in_all, 50);
}

TEST(MapEdgeCases, unknown_keys_are_kept_as_data_and_odd_values_are_moved_to_the_nearest_legal_one) {
    const auto with = [](const std::string& keys) {
        return read(entity("worldspawn", {}, kCube) + entity("thing", keys, kCube));
    };
    EXPECT_THAT(with(key("_tb_id", "3") + key("anything", "at all")).said, IsEmpty());
    const Reading low = with(key("friction", "-1") + key("landmark", "2") + key("hinge", "nort") +
                             key("cs_name", "liquid") + key("viscosity", "1e9"));
    EXPECT_EQ(low.said.size(), 4U);
    EXPECT_EQ(low.scene.solids.at(1).viscosity_ns_per_m, 100.0);
    const Feature& feature = *low.scene.find(low.scene.solids.at(1).feature);
    EXPECT_TRUE(feature.landmark);
    EXPECT_EQ(feature.hinge, "north");
    EXPECT_THAT(read(entity("worldspawn", {}, kCube) + entity("info_player_start", key("origin", "1 2"))).said,
                ElementsAre(HasSubstr("is not three numbers")));
}

TEST(MapEdgeCases, liquids_keep_their_viscosity_and_sounds_their_place) {
    const Reading reading =
        read(entity("worldspawn", {}, kCube) +
             entity("thing", key("cs_name", "liquid") + key("viscosity", "2.5") + key("name", "Basin"), kCube) +
             entity("ambient_comp_hum", key("origin", "32 64 96")) +
             entity("info_null", key("origin", "0 0 0") + key("sound", "clock_tick") + key("name", "Clock")));
    EXPECT_EQ(reading.scene.solids.at(1).viscosity_ns_per_m, 2.5);
    EXPECT_EQ(reading.scene.find(reading.scene.solids.at(1).feature)->name, "Basin");
    ASSERT_EQ(reading.scene.sounds.size(), 2U);
    EXPECT_EQ(spoken_name(reading.scene.sounds[0]), "computer hum");
    EXPECT_EQ(reading.scene.sounds[0].sound, "ambient_comp_hum");
    EXPECT_EQ(reading.scene.sounds[0].position_m, Vec3(1, 2, 3));
    EXPECT_EQ(spoken_name(reading.scene.sounds[1]), "Clock");
    EXPECT_EQ(reading.scene.sounds[1].sound, "clock_tick");
}

TEST(MapEdgeCases, texts_may_be_given_in_several_languages) {
    const Reading reading =
        read(entity("worldspawn", key("message", "Barn") + key("message_de", "Scheune"), kCube) +
             entity("thing",
                    key("name", "Plough") + key("name_de", "Pflug") + key("name_fr", "Charrue") +
                        key("name_", "no language") + key("names_de", "another key"),
                    kCube) +
             entity("trigger_once", key("message", "Mind the step.") + key("message_de", "Achtung, Stufe."), kCube) +
             entity("thing", key("name_de", "Kiste"), kCube) +
             entity("ambient_drip", key("origin", "0 0 0") + key("name", "Tap") + key("name_de", "Hahn")) +
             entity("ambient_comp_hum", key("origin", "32 64 96")) + entity("trigger_changelevel", {}, kCube));
    const Scene& scene = reading.scene;
    const auto feature = [&](const std::string& name) {
        return std::find_if(scene.features.begin(), scene.features.end(),
                            [&](const Feature& f) { return f.name == name; });
    };
    const auto trigger =
        std::find_if(scene.features.begin(), scene.features.end(), [](const Feature& f) { return !f.message.empty(); });
    const auto exit =
        std::find_if(scene.features.begin(), scene.features.end(), [](const Feature& f) { return f.made_message; });
    const auto unnamed = std::find_if(scene.features.begin(), scene.features.end(),
                                      [](const Feature& f) { return f.made_name && !f.name_in.empty(); });
    ASSERT_NE(feature("Plough"), scene.features.end());
    ASSERT_NE(trigger, scene.features.end());
    ASSERT_NE(exit, scene.features.end());
    ASSERT_NE(unnamed, scene.features.end());
    ASSERT_EQ(scene.sounds.size(), 2U);
    const auto all = [&] {
        return std::vector<std::string>{
            spoken_name(scene),    spoken_name(*feature("Plough")), spoken_message(*trigger),    spoken_name(*unnamed),
            spoken_message(*exit), spoken_name(scene.sounds[0]),    spoken_name(scene.sounds[1])};
    };
    const std::string exit_english = phrase("exit.reached"), box = spoken_kind(unnamed->name);
    EXPECT_THAT(all(), ElementsAre("Barn", "Plough", "Mind the step.", box, exit_english, "Tap", "computer hum"));
    EXPECT_EQ(feature("Plough")->name_in.size(), 2U);
    {
        const test::InLanguage german("de");
        EXPECT_THAT(all(), ElementsAre("Scheune", "Pflug", "Achtung, Stufe.", "Kiste", phrase("exit.reached"), "Hahn",
                                       phrase("map.sound_computer_hum")));
        EXPECT_NE(phrase("exit.reached"), exit_english);
        EXPECT_EQ(stored_name(scene, FeatureId{static_cast<std::uint32_t>(feature("Plough") - scene.features.begin())}),
                  "Plough");
    }
}

TEST(MapEdgeCases, particles_and_sounds_of_other_games_are_heard_at_their_place) {
    const Reading reading = read(
        entity("worldspawn", {}, kCube) + entity("particle_fountain", key("origin", "32 0 0") + key("volume", "0.5")) +
        entity("light_torch_small_walltorch", key("origin", "64 0 0")) +
        entity("ambient_generic", key("origin", "96 0 0") + key("message", "ambience/wind2.wav")) +
        entity("target_speaker", key("origin", "128 0 0") + key("noise", "world/clock") + key("volume", "7")));
    ASSERT_EQ(reading.scene.sounds.size(), 4U);
    EXPECT_EQ(spoken_name(reading.scene.sounds[0]), "fountain");
    EXPECT_EQ(reading.scene.sounds[0].loudness, 0.5);
    EXPECT_EQ(spoken_name(reading.scene.sounds[1]), "torch");
    EXPECT_EQ(reading.scene.sounds[1].loudness, 1.0);
    EXPECT_EQ(reading.scene.sounds[2].sound, "ambience/wind2.wav");
    EXPECT_EQ(reading.scene.sounds[3].sound, "world/clock");
    EXPECT_EQ(reading.scene.sounds[3].loudness, 1.0);
    EXPECT_THAT(reading.said, ElementsAre(HasSubstr("volume")));
}

TEST(MapEdgeCases, guessing_of_materials_can_be_switched_off_without_changing_the_walls) {
    const std::string text = entity(
        "worldspawn", {}, box_brush(0, 0, 0, 128, 16, 96, "brick1") + box_brush(128, 0, 0, 256, 16, 96, "wood1"));
    ReadOptions plain;
    plain.guess_materials = false;
    const Result<Scene> guessed = read_quake_map(text, "test.map"), unguessed = read_quake_map(text, "test.map", plain);
    ASSERT_TRUE(guessed && unguessed);
    EXPECT_EQ(guessed->features.size(), unguessed->features.size());
    EXPECT_EQ(guessed->materials.size(), 3U);
    EXPECT_EQ(unguessed->materials.size(), 1U);
    EXPECT_TRUE(unguessed->report.guessed.empty());
}

TEST(MapEdgeCases, coincident_duplicate_brushes_are_felt_once_and_reported) {
    const std::string wall = box_brush(0, 0, 0, 128, 16, 96, "brick1"),
                      other = box_brush(0, 0, 0, 128, 16, 97, "brick1");
    std::string turned = wall;  // a wall with the same faces in another order and with another texture
    const std::size_t first = turned.find('('), second = turned.find('\n', first) + 1;
    turned.insert(turned.rfind('}'), turned.substr(first, second - first));
    turned.erase(first, second - first);
    turned.replace(turned.find("brick1"), 6, "wood1 ");
    const std::string named = entity("func_wall", test::key("name", "panel"), wall);
    const Result<Scene> scene =
        read_quake_map(entity("worldspawn", {}, wall + other + wall + turned) + named + named, "test.map");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_EQ(scene->solids.size(), 4U) << "two of the building, and two panels, each a thing of its own";
    EXPECT_EQ(scene->report.warnings_in_all, 2);
    ASSERT_EQ(scene->report.warnings.size(), 2U);
    EXPECT_THAT(scene->report.warnings[0].sentence(), HasSubstr("the same as the one in line 3"));
    EXPECT_THAT(scene->report.left_out, testing::Contains("2 brushes that repeat others were left out."));
    EXPECT_EQ(scene->material(scene->solids[0].face_materials[0]).name, "brick") << "the first is the one that stays";
    const Result<Scene> once = read_quake_map(entity("worldspawn", {}, wall + other), "test.map");
    const Result<Scene> often = read_quake_map(entity("worldspawn", {}, wall + other + wall + turned), "test.map");
    ASSERT_TRUE(once && often);
    EXPECT_EQ(once->surfaces.size(), often->surfaces.size());
}

TEST(MapEdgeCases, reading_fails_only_if_nothing_is_left_and_then_gives_the_first_reason) {
    const auto sentence = [](const std::string& text) {
        const Result<Scene> scene = read_quake_map(text, "test.map");
        return scene ? std::string("read") : scene.error().sentence();
    };
    EXPECT_EQ(sentence(""), "test.map: Nothing to touch was found in this map. It contains no brushes.");
    EXPECT_EQ(sentence(entity("worldspawn")),
              "test.map: Nothing to touch was found in this map. It contains no brushes.");
    EXPECT_THAT(sentence("hello"), testing::StartsWith("test.map, line 1, column 1: Nothing to touch was found in "
                                                       "this map. The problem: expected an opening brace"));
    EXPECT_THAT(sentence(entity("worldspawn", {}, "{\n}\n{\n}\n")),
                HasSubstr("2 problems; the first: this brush has no faces."));
}

}  // namespace map_edge_cases_test
}  // namespace handrail
