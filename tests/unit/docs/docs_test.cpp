// The guides say what the code does: their tables are compared with the tables in the code, row by row.
#include <regex>
#include <set>

#include "settings/settings.h"
#include "tests/unit/docs/table_rows.h"
#include "worlds/scene/effect.h"
#include "worlds/scene/material.h"

namespace handrail {
namespace docs_test {
using testing::UnorderedElementsAreArray;

using test::table_rows;

const std::filesystem::path kRoot = HANDRAIL_SOURCE_DIR;

TEST(SettingsGuide, lists_every_setting_as_the_program_explains_it) {
    std::vector<std::string> expected;
    for (const SettingRow& row : SettingsStore{}.explain())
        expected.push_back(fmt::format("| {} | {} | {} | {} | {} | {} |", row.key, row.value, row.range,
                                       row.unit.empty() ? "-" : row.unit, world_may_set(row.key) ? "yes" : "no",
                                       row.meaning));
    EXPECT_THAT(table_rows("settings.md", "| Key | Default |"), UnorderedElementsAreArray(expected));
}

TEST(MapAuthorsGuide, lists_every_material_with_what_it_feels_like) {
    std::vector<std::string> expected;
    for (const MaterialSpec& material : material_library()) {
        const TextureWave& wave = material.wave;
        std::string texture = "none";
        if (wave.shape != WaveShape::Level)
            texture = fmt::format("{}, {:g} mm deep, every {:g} mm", wave.shape == WaveShape::Sine ? "sine" : "square",
                                  1e3 * wave.depth_hand_m, 1e3 * wave.period_hand_m);
        else if (wave.friction_share > 0.0)
            texture =
                fmt::format("friction varies by {:g} every {:g} mm", wave.friction_share, 1e3 * wave.period_hand_m);
        expected.push_back(fmt::format(
            "| {} | {} | {} | {} | {} | {} |", material.name, material.stiffness_fraction, material.friction_static,
            material.friction_mu,
            material.damping_ns_per_m < 0.0 ? "as set" : fmt::format("{}", material.damping_ns_per_m), texture));
    }
    EXPECT_THAT(table_rows("map-authors-guide.md", "| Material | Stiffness |"), UnorderedElementsAreArray(expected));
}

TEST(MapAuthorsGuide, lists_every_effect_with_its_ranges) {
    std::vector<std::string> expected;
    for (const EffectSpec& effect : effect_table()) {
        const auto range = [](double value, double least, double most, std::string_view unit) {
            return most > 0.0 ? fmt::format("{}, {} to {} {}", value, least, most, unit) : std::string("-");
        };
        expected.push_back(fmt::format(
            "| {} | {} | {} | {} |", effect.name, range(effect.strength_n, effect.least_n, effect.most_n, "N"),
            range(effect.width_hand_m, effect.least_hand_m, effect.most_hand_m, "m"), effect_meaning(effect)));
    }
    EXPECT_THAT(table_rows("map-authors-guide.md", "| Effect | Strength |"), UnorderedElementsAreArray(expected));
}

// The reader asks for its keys by name; every name it asks for must have a row, and every row must be asked for.
TEST(MapAuthorsGuide, lists_every_key_that_the_map_reader_looks_at) {
    static const std::regex kAsked(
        R"re((?:(?:entity_?\.find|entity\.value|text_of|yes_no_of|number_of|side_of|vector_of|)re"
        R"re(name_of_key)\((?:entity_?,\s*)?|NumberKey k\w+\{)"([a-z_]+)")re");
    std::string source = test::content_of(kRoot / "worlds" / "readers" / "quake_map.cpp");
    for (const char* more :
         {"map_effects.cpp", "map_keys.cpp", "map_meaning.cpp", "map_movers.cpp", "map_soft.cpp", "map_surfaces.cpp"})
        source += test::content_of(kRoot / "worlds" / "readers" / more);
    std::set<std::string> asked;
    for (auto it = std::sregex_iterator(source.begin(), source.end(), kAsked); it != std::sregex_iterator(); ++it)
        asked.insert((*it)[1]);
    asked.erase("_external_map");  // content of another program, left out and said
    EXPECT_GE(asked.size(), 10U) << "the reader's source was not understood";
    std::set<std::string> listed;
    for (const std::string& row : table_rows("map-authors-guide.md", "| Key | On |"))
        listed.insert(row.substr(2, row.find(' ', 2) - 2));
    EXPECT_EQ(listed, asked);
}

// "From [file](...):" and a block of code after it: the block stands in that file, which the tests compile and run.
TEST(DevelopersGuide, quotes_its_examples_from_files_that_are_compiled_and_run) {
    static const std::regex kQuotation(
        R"re(From \[`(tests/examples/[a-z_]+\.cpp)`\]\([^)]*\):\n\n```cpp\n([^`]*)```)re");
    const std::string guide = test::content_of(kRoot / "docs" / "developer.md");
    std::set<std::string> quoted;
    for (auto it = std::sregex_iterator(guide.begin(), guide.end(), kQuotation); it != std::sregex_iterator(); ++it) {
        const std::string file = (*it)[1], code = (*it)[2];
        quoted.insert(file);
        EXPECT_NE(test::content_of(kRoot / file).find(code), std::string::npos)
            << file << " does not hold what the guide quotes:\n"
            << code;
    }
    std::set<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(kRoot / "tests" / "examples"))
        if (entry.path().extension() == ".cpp") all.insert("tests/examples/" + entry.path().filename().string());
    EXPECT_EQ(quoted, all);
    EXPECT_GE(all.size(), 3U);
    std::size_t blocks = 0;
    for (std::size_t at = guide.find("```cpp"); at != std::string::npos; at = guide.find("```cpp", at + 1)) ++blocks;
    EXPECT_EQ(blocks, static_cast<std::size_t>(std::distance(
                          std::sregex_iterator(guide.begin(), guide.end(), kQuotation), std::sregex_iterator())))
        << "every block of code in the guide is a quotation";
}

TEST(Documents, link_only_to_files_that_exist) {
    static const std::regex kLink(R"re(\]\(([^)#:]+)(#[^)]*)?\))re");
    std::vector<std::filesystem::path> documents{kRoot / "README.md"};
    for (const auto& entry : std::filesystem::directory_iterator(kRoot / "docs"))
        if (entry.path().extension() == ".md") documents.push_back(entry.path());
    EXPECT_GE(documents.size(), 8U);
    for (const auto& document : documents) {
        // A lambda in a block of code looks like a link and is none.
        std::string text = test::content_of(document);
        for (std::size_t open = text.find("```"); open != std::string::npos; open = text.find("```", open)) {
            const std::size_t close = text.find("```", open + 3);
            text.erase(open, close == std::string::npos ? close : close + 3 - open);
        }
        for (auto it = std::sregex_iterator(text.begin(), text.end(), kLink); it != std::sregex_iterator(); ++it)
            EXPECT_TRUE(std::filesystem::exists(document.parent_path() / (*it)[1].str()))
                << document << " links to " << (*it)[1];
    }
}

}  // namespace docs_test
}  // namespace handrail
