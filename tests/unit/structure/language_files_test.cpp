// Tests that settings/languages contains all texts that Handrail announces or prints, and that each bundled language is
// complete.
#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "tests/support/names.h"
#include "tests/support/project_files.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/language.h"

namespace handrail {
namespace language_files_test {
namespace fs = std::filesystem;

bool is_program_source(const std::string& file) {
    return (file.ends_with(".h") || file.ends_with(".cpp")) && !file.starts_with("tests/");
}

std::map<std::string, std::string> texts_of(const std::string& code) {
    const auto all = bundled_texts(code);
    return {all.begin(), all.end()};
}

struct Literal {
    int line = 0;
    std::string content;  // the literal as it is written in the source, with escapes
};

// Returns the string literals of a C++ source. Omits comments, #include lines and contract_pre, whose texts only
// developers see.
std::vector<Literal> literals_of(const std::string& source) {
    std::vector<Literal> found;
    const auto before = [&](char end, std::size_t from) { return std::min(source.find(end, from), source.size()) - 1; };
    int line = 1;
    for (std::size_t i = 0; i < source.size(); ++i) {
        const char c = source[i];
        if (c == '\n') ++line;
        else if (source.compare(i, 2, "//") == 0) i = before('\n', i);
        else if (source.compare(i, 2, "/*") == 0) {
            const std::size_t end = std::min(source.find("*/", i), source.size());
            line += static_cast<int>(
                std::count(source.begin() + static_cast<long>(i), source.begin() + static_cast<long>(end), '\n'));
            i = end + 1;
        } else if (source.compare(i, 8, "#include") == 0) i = before('\n', i);
        else if (source.compare(i, 13, "static_assert") == 0) i = before(';', i);
        else if (source.compare(i, 12, "contract_pre") == 0) i = before(';', i);
        else if (c == '\'') {
            for (++i; i < source.size() && source[i] != '\''; ++i)
                if (source[i] == '\\') ++i;
        } else if (source.compare(i, 2, "R\"") == 0) {
            const std::size_t open = source.find('(', i);
            const std::string close = ")" + source.substr(i + 2, open - i - 2) + "\"";
            const std::size_t end = source.find(close, open);
            found.push_back({line, source.substr(open + 1, end - open - 1)});
            line += static_cast<int>(
                std::count(source.begin() + static_cast<long>(i), source.begin() + static_cast<long>(end), '\n'));
            i = end + close.size() - 1;
        } else if (c == '"') {
            const std::size_t from = ++i;
            for (; i < source.size() && source[i] != '"'; ++i)
                if (source[i] == '\\') ++i;
            found.push_back({line, source.substr(from, i - from)});
        } else if (std::isdigit(static_cast<unsigned char>(c)) && i + 1 < source.size() && source[i + 1] == '\'')
            ++i;  // the apostrophe is a digit separator, as in 1'000
    }
    return found;
}

// Returns true if a literal looks like text for people: it has two adjacent words or the end of a sentence. Keys,
// formats, file names and shader code have neither.
bool reads_like_words(const std::string& literal) {
    static const std::regex kWords(R"([A-Za-z]{2,}[,;:.]? [a-z]{2,}|^[A-Z][a-z]+[.!?]$)");
    return std::regex_search(literal, kWords);
}

// Returns literals, by file, that look like text but that no user hears, such as parts of file formats and protocols.
const std::map<std::string, std::vector<std::string>>& not_said() {
    static const std::map<std::string, std::vector<std::string>> kNotSaid{
        {"worlds/base/contract.cpp",
         // The program prints this text when it crashes. The program must not load languages then, because it must not
         // allocate memory.
         {"Handrail has a fault of its own"}},
        // Only developers see these texts, in the preset debug and in tests.
        {"haptic/render/validate_scene.cpp", {"a ", "an ", "no ", "HapticScene has"}},
        {"worlds/navigation/validate_ways.cpp",
         {"a ", "an ", "another ", "spans ", "columns ", "floors ", "WalkSpace has", "RoomGraph has"}},
        // Files use these names to refer to things. The program announces them as phrase("kind." + name) and
        // phrase("material." + name).
        {"worlds/scene/surfaces.cpp", {"sloping ceiling", "slope rising", "low block", "large block"}},
        {"worlds/scene/material.cpp", {"steel grille"}},
        {"worlds/scene/outer_ground.h", {"ground outside"}},
        {"worlds/floorplan/plan_scene.cpp", {"about this place"}},
        {"worlds/osm/osm_things.cpp", {"tactile paving"}},
        {"app/report/report_page.cpp", {"<", "content=", "initial-scale", "class=", "{"}},  // HTML and CSS
        {"app/report/plan_part.cpp", {"<", "class=", "{"}},
        {"app/report/page_parts.cpp", {"<", "content=", "initial-scale", "class=", "{", ":root"}},
        {"worlds/exports/sheet.cpp",
         {"svg", "aria-", "<title", "<rect", "<circle", "<<", "0 R", " n\\n", " f\\n"}},  // SVG and PDF
        {"app/core/kept/side_file.cpp", {"# What was added to this world"}},              // first line of a side file
        {"app/main/scenario_command.cpp", {"<testsuite", "<testcase", "<failure"}},       // XML in JUnit's format
        {"worlds/readers/map_words.cpp",
         {"moving platform", "turning part", "secret place", "marked place"}},  // files refer to things by these names
        // Some of these names are also in files.
        {"worlds/readers/quake_map.cpp", {"marked place", "sliding floor", "curved surface"}},
        // Scenario files use these names to refer to sounds. The program announces them as phrase("sound." + name).
        {"audio-cues/plan/sound_table.cpp",
         {"wall tone", "door moves", "door shuts", "stairs up", "stairs down", "door near", "beacon ahead",
          "beacon behind", "forces on", "forces off", "frame switch", "hidden clock", "rim back", "let go",
          "guide start", "guide stop"}},
        {"worlds/ifc/step_file.cpp", {"version https://git-lfs"}},            // first line of a Git LFS pointer file
        {"worlds/readers/foreign_formats.cpp", {"version https://git-lfs"}},  // beginning of a Git LFS pointer file
        {"worlds/exports/as_words.cpp", {" "}},                // the words of room descriptions, as they are written
        {"worlds/exports/found_house.cpp", {" "}},             // also for room descriptions
        {"worlds/exports/house_things.cpp", {" "}},            // also for room descriptions
        {"worlds/exports/stated_house.cpp", {" "}},            // also for room descriptions
        {"worlds/words/word_patterns.cpp", {" "}},             // patterns for reading texts in both languages
        {"worlds/readers/height_picture.cpp", {"cut short"}},  // libpng receives this message and does not print it
        {"haptic/compile/touch_model.cpp",
         {"sheets of one side", "liquid surfaces", "textures and shading"}},               // keys of info --json
        {"haptic/drivers/found_device.cpp", {"needs calibration", "cannot be used yet"}},  // values of devices --json
        {"app/window/renderer.cpp", {"#version"}},
        {"app/window/first_person.cpp", {"gl_", "uniform ", "#version"}},
        {"app/window/draw_mesh.cpp", {"gl_", "uniform ", "#version"}},
    };
    return kNotSaid;
}

TEST(LanguageFiles, are_complete_and_use_the_same_placeholders) {
    const auto english = texts_of("en");
    ASSERT_GT(english.size(), 10U);
    for (const LanguageName& language : bundled_languages()) {
        const auto texts = texts_of(language.code);
        for (const auto& [key, pattern] : english) {
            ASSERT_TRUE(texts.contains(key)) << language.code << ".toml lacks " << key;
            std::vector<std::string> named, offered;
            EXPECT_EQ(pattern_fault(pattern, &offered), "") << key;
            EXPECT_EQ(pattern_fault(texts.at(key), &named), "") << language.code << ": " << key;
            EXPECT_TRUE(std::includes(offered.begin(), offered.end(), named.begin(), named.end()))
                << language.code << ": " << key << " asks for other values";
            EXPECT_EQ(texts.at(key).empty(), pattern.empty()) << language.code << ": " << key;
        }
        for (const auto& [key, pattern] : texts)
            EXPECT_TRUE(english.contains(key)) << language.code << ".toml has " << key << ", English has not";
    }
}

// Sections whose keys the code composes with a name, as in phrase("material." + name). No literal contains such a key
// in full.
const std::vector<std::string> kMadeOfNames{
    "kind.",
    "material.",
    "page_label.",  // Test: LanguageFiles.contain_the_labels_of_the_page
    // Keys that contain the values of OpenStreetMap's tags and of IMDF's categories.
    "osm_kind.",
    "osm_fact.",
    "imdf_kind.",
    "imdf_fact.",
    // Other tests check the keys of the following sections, each next to the table with the names. The next two
    // sections are checked in tests/unit/core/command_texts_test.cpp.
    "command.",
    "key_name.",
    // Test: tests/unit/terminal/command_words_test.cpp
    "command_word.",
    "list_word.",
    "wizard_word.",
    "replay_word.",
    // Test: tests/unit/terminal/typed_sentences_test.cpp
    "typed_sentence.",
    // Source: app/core/dialogue/question.cpp
    "question_word.",
    // Test: tests/unit/settings/setting_texts_test.cpp
    "setting.",
    "setting_name.",
    "setting_topic.",
    "setting_choice.",
    "setting_range.",
    "unit.",
    // Test: tests/unit/cue_plan/sound_texts_test.cpp
    "sound.",
    "sound_contact.",
    // Tests: tests/unit/device/device_spec_test.cpp, tests/unit/readers/german_test.cpp,
    // tests/unit/compile/touch_model_test.cpp
    "device_name.",
    "effect_name.",
    "touch_part.",
    "touch_stage.",
    // Test: tests/unit/wizard/wizard_test.cpp
    "wizard_part.",
    // Test: tests/unit/check/planted_faults_test.cpp
    "world_fault.",
    "world_fault_do.",
    // Test: tests/unit/report/report_page_test.cpp
    "report.measure_",
    "report.means_",
    "report.strategy_",
    "report.mostly_",
    "report.csv_",
    // Test: below in this file
    "side.",
};

TEST(LanguageFiles, contain_every_key_that_the_code_uses_and_no_other) {
    static const std::regex kCall("\\bphrase\\(\\s*\"([^\"]*)\"\\s*[,)]");
    static const std::regex kKey("^[a-z_]+(\\.[a-z0-9_-]+)+$");
    const auto english = texts_of("en");
    std::set<std::string> named;
    for (const std::string& file : test::project_files()) {
        if (!is_program_source(file)) continue;
        const std::string source = test::content_of(test::project_root() / file);
        for (auto it = std::sregex_iterator(source.begin(), source.end(), kCall); it != std::sregex_iterator(); ++it)
            EXPECT_TRUE(english.contains((*it)[1]))
                << file << " says " << (*it)[1] << ", which settings/languages/en.toml lacks";
        for (const Literal& literal : literals_of(source))
            if (std::regex_match(literal.content, kKey)) named.insert(literal.content);
    }
    for (const auto& [key, pattern] : english) {
        const bool made =
            std::any_of(kMadeOfNames.begin(), kMadeOfNames.end(),
                        [&, &name = key](const std::string& section) { return name.starts_with(section); });
        // A text for users who type words is stored next to the text for users who press keys. Its key is the other key
        // with "_typed" after it (typist.h).
        const std::string for_keys = key.ends_with("_typed") ? key.substr(0, key.size() - 6) : key;
        const std::string& said = english.contains(for_keys) ? for_keys : key;
        EXPECT_TRUE(made || named.contains(said)) << "nothing says " << key << "; take it out of settings/languages";
    }
}

TEST(LanguageFiles, contain_exactly_the_sides_that_maps_can_name) {
    const std::string reader = test::content_of((test::project_root() / "worlds/readers/map_keys.cpp").string());
    std::size_t sides = 0;
    for (const auto& [key, pattern] : texts_of("en"))
        if (key.starts_with("side.")) {
            ++sides;
            EXPECT_NE(reader.find("\"" + key.substr(5) + "\""), std::string::npos) << "no map says " << key;
        }
    EXPECT_EQ(sides, 12U);
}

TEST(LanguageFiles, contain_every_text_that_a_person_hears) {
    std::size_t looked_at = 0;
    for (const std::string& file : test::project_files()) {
        if (!is_program_source(file)) continue;
        const auto& allowed = not_said();
        const auto excused = allowed.find(file);
        for (const Literal& literal : literals_of(test::content_of(test::project_root() / file))) {
            ++looked_at;
            const bool fine = excused != allowed.end() &&
                              std::any_of(excused->second.begin(), excused->second.end(), [&](const std::string& part) {
                                  return literal.content.find(part) != std::string::npos;
                              });
            EXPECT_TRUE(fine || !reads_like_words(literal.content))
                << file << ":" << literal.line << " says \"" << literal.content << "\" by itself";
        }
    }
    EXPECT_GT(looked_at, 100U);
}

TEST(LanguageFiles, violations_are_detected_by_this_test) {
    const auto found = literals_of(
        "// \"a comment\"\n#include \"x.h\"\nsay(\"Two words\"); f('\"', \"key.one\", 1'000); R\"(raw text)\";");
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].line, 3);
    EXPECT_TRUE(reads_like_words(found[0].content));
    EXPECT_FALSE(reads_like_words(found[1].content));
    EXPECT_TRUE(reads_like_words(found[2].content));
    EXPECT_TRUE(reads_like_words("Done."));
    EXPECT_FALSE(reads_like_words("{} {}"));
}

// page.js shows the labels, as labels.NAME or by the name of the element that gets the label.
TEST(LanguageFiles, contain_the_labels_of_the_page) {
    const std::string page = test::content_of(test::project_root() / "app" / "page" / "page.js");
    const auto& english = bundled_texts("en");
    std::set<std::string> shown;
    for (const auto& [key, pattern] : english) {
        constexpr std::string_view kSection = "page_label.";
        if (!key.starts_with(kSection)) continue;
        const std::string name = key.substr(kSection.size());
        shown.insert(name);
        EXPECT_TRUE(
            std::regex_search(page, std::regex("labels\\." + name + "\\b|'" + name + "'|text\\." + name + "\\b")))
            << "the page does not show " << key;
    }
    EXPECT_GE(shown.size(), 10U);
    static const std::regex used("labels\\.(\\w+)");
    for (auto it = std::sregex_iterator(page.begin(), page.end(), used); it != std::sregex_iterator(); ++it)
        EXPECT_TRUE(shown.contains((*it)[1])) << (*it)[1];
}

}  // namespace language_files_test
}  // namespace handrail
