// Tests that the guides match the code. Compares the tables of the guides with the tables in the code, row by row.
#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "settings/settings.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/unit/docs/table_rows.h"
#include "worlds/scene/effect.h"
#include "worlds/scene/material.h"

namespace handrail {
namespace docs_test {
using testing::UnorderedElementsAreArray;

using test::list_items;
using test::table_rows;

namespace fs = std::filesystem;

const fs::path kRoot = test::project_root();

// Returns the pages at the top and every page of docs, sorted by name.
std::vector<fs::path> pages() {
    std::vector<fs::path> all{kRoot / "README.md", kRoot / "CONTRIBUTING.md", kRoot / "NEWS.md"};
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / "docs"))
        if (entry.path().extension() == ".md") all.push_back(entry.path());
    std::sort(all.begin(), all.end());
    return all;
}

// Returns a page without its code blocks, in which a lambda looks like a link and a comment like a heading.
std::string prose_of(const fs::path& page) {
    std::string text = test::content_of(page);
    for (std::size_t open = text.find("```"); open != std::string::npos; open = text.find("```", open)) {
        const std::size_t close = text.find("```", open + 3);
        text.erase(open, close == std::string::npos ? close : close + 3 - open);
    }
    return text;
}

// Returns the anchors of a page's headings, to which links lead: lower-case letters, digits and hyphens.
std::set<std::string> anchors_of(const fs::path& page) {
    std::set<std::string> anchors;
    std::istringstream lines(prose_of(page));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t words = line.find_first_not_of('#');
        if (words == 0 || words == std::string::npos || line[words] != ' ') continue;
        std::string anchor;
        for (const char c : line.substr(words + 1)) {
            const auto byte = static_cast<unsigned char>(c);
            if (c == ' ') anchor += '-';
            else if (byte >= 0x80 || std::isalnum(byte) || c == '-' || c == '_')
                anchor += static_cast<char>(std::tolower(byte));
        }
        anchors.insert(anchor);
    }
    return anchors;
}

TEST(SettingsGuide, explains_every_setting_as_the_program_does) {
    std::map<std::string, std::vector<std::string>> expected;
    for (const SettingRow& row : SettingsStore{}.explain()) {
        const std::string range =
            row.range == "true or false" ? "" : " (" + row.range + (row.unit.empty() ? "" : " " + row.unit) + ")";
        expected[row.key.substr(0, row.key.find('.'))].push_back(
            fmt::format("- `{}` = {}{}: {}", row.key, row.value, range, row.meaning));
    }
    for (const auto& [topic, settings] : expected)
        EXPECT_THAT(list_items("settings.md", "### " + topic), UnorderedElementsAreArray(settings));
}

TEST(SettingsGuide, names_exactly_the_settings_that_a_world_may_set) {
    std::vector<std::string> expected;
    for (const SettingRow& row : SettingsStore{}.explain())
        if (world_may_set(row.key)) expected.emplace_back(row.key);
    const std::string page = test::content_of(kRoot / "docs" / "settings.md");
    const std::size_t from = page.find("A world may set only"), to = page.find("Only you set", from);
    ASSERT_NE(to, std::string::npos);
    const std::string sentence = page.substr(from, to - from);
    static const std::regex kKey("`([a-z_.]+)`");
    std::vector<std::string> named;
    for (auto it = std::sregex_iterator(sentence.begin(), sentence.end(), kKey); it != std::sregex_iterator(); ++it)
        named.push_back((*it)[1]);
    EXPECT_THAT(named, UnorderedElementsAreArray(expected));
}

TEST(MapAuthorsGuide, lists_every_material_and_how_it_feels) {
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
    EXPECT_THAT(table_rows("map-authors-guide/touch.md", "| Material | Stiffness |"),
                UnorderedElementsAreArray(expected));
}

TEST(MapAuthorsGuide, lists_every_effect_with_its_ranges) {
    std::vector<std::string> expected;
    for (const EffectSpec& effect : effect_table()) {
        const auto range = [](double value, double least, double most, std::string_view unit) {
            return most > 0.0 ? fmt::format("{}, {} to {} {}", value, least, most, unit) : std::string("-");
        };
        expected.push_back(fmt::format("| {} | {} | {}", effect.name,
                                       range(effect.strength_n, effect.least_n, effect.most_n, "N"),
                                       range(effect.width_hand_m, effect.least_hand_m, effect.most_hand_m, "m")));
    }
    std::vector<std::string> rows = table_rows("map-authors-guide/touch.md", "| Effect | Strength |");
    for (std::string& row : rows) {
        EXPECT_TRUE(row.ends_with(". |")) << "a sentence says what the effect does: " << row;
        row.resize(row.rfind(" | "));
    }
    EXPECT_THAT(rows, UnorderedElementsAreArray(expected));
}

// The map reader queries keys by name. Every name that the reader queries must have a line in the guide, and every line
// of the guide must be about such a name.
TEST(MapAuthorsGuide, lists_every_key_that_the_map_reader_reads) {
    static const std::regex kQuoted(
        R"re((?:(?:entity_?\.find|entity\.value|text_of|yes_no_of|number_of|side_of|vector_of|)re"
        R"re(name_of_key)\((?:entity_?,\s*)?|NumberKey k\w+\{)"([a-z_]+)")re");
    std::string source = test::content_of(kRoot / "worlds" / "readers" / "quake_map.cpp");
    for (const char* more :
         {"map_effects.cpp", "map_keys.cpp", "map_meaning.cpp", "map_movers.cpp", "map_soft.cpp", "map_surfaces.cpp"})
        source += test::content_of(kRoot / "worlds" / "readers" / more);
    std::set<std::string> requested;
    for (auto it = std::sregex_iterator(source.begin(), source.end(), kQuoted); it != std::sregex_iterator(); ++it)
        requested.insert((*it)[1]);
    // This key belongs to another program; the reader omits the map that it names and reports that.
    requested.erase("_external_map");
    EXPECT_GE(requested.size(), 10U) << "the reader's source was not understood";
    std::set<std::string> listed;
    static const std::regex kKey("`([a-z_]+)`");
    for (const std::string& item : list_items("map-authors-guide/keys.md", "## Keys")) {
        const std::string keys = item.substr(0, item.find('('));
        for (auto it = std::sregex_iterator(keys.begin(), keys.end(), kKey); it != std::sregex_iterator(); ++it)
            listed.insert((*it)[1]);
    }
    EXPECT_EQ(listed, requested);
}

TEST(DevelopersGuide, links_to_every_example) {
    const std::string guide = test::content_of(kRoot / "docs" / "developer" / "examples.md");
    std::size_t examples = 0;
    for (const auto& entry : fs::directory_iterator(kRoot / "tests" / "examples")) {
        if (entry.path().extension() != ".cpp") continue;
        ++examples;
        const std::string link = "](../../tests/examples/" + entry.path().filename().string() + ")";
        EXPECT_NE(guide.find(link), std::string::npos) << entry.path() << " is not linked from the examples' page";
    }
    EXPECT_GE(examples, 3U);
}

TEST(Documents, link_only_to_files_and_headings_that_exist) {
    static const std::regex kLink(R"re(\]\(([^)#:\s]*)(?:#([^)\s]*))?\))re");
    std::size_t headings = 0;
    EXPECT_GE(pages().size(), 30U);
    for (const fs::path& page : pages()) {
        const std::string text = prose_of(page);
        for (auto it = std::sregex_iterator(text.begin(), text.end(), kLink); it != std::sregex_iterator(); ++it) {
            const std::string file = (*it)[1], anchor = (*it)[2];
            const fs::path target = file.empty() ? page : page.parent_path() / file;
            EXPECT_TRUE(fs::exists(target)) << page << " links to " << file;
            if (anchor.empty() || target.extension() != ".md") continue;
            ++headings;
            EXPECT_TRUE(anchors_of(target).contains(anchor)) << page << " links to " << file << "#" << anchor;
        }
    }
    EXPECT_GE(headings, 20U) << "links to headings were not understood";
}

TEST(Documents, are_all_linked_from_the_index) {
    static const std::regex kLink(R"re(\]\(([^)#:\s]+\.md)(?:#[^)\s]*)?\))re");
    std::set<fs::path> reached;
    std::vector<fs::path> open{kRoot / "docs" / "README.md"};
    while (!open.empty()) {
        const fs::path page = open.back();
        open.pop_back();
        if (!reached.insert(page).second) continue;
        const std::string text = prose_of(page);
        for (auto it = std::sregex_iterator(text.begin(), text.end(), kLink); it != std::sregex_iterator(); ++it)
            open.push_back((page.parent_path() / (*it)[1].str()).lexically_normal());
    }
    for (const fs::path& page : pages())
        EXPECT_TRUE(reached.contains(page) || page == kRoot / "README.md") << page << " stands in no list";
    EXPECT_NE(prose_of(kRoot / "README.md").find("](docs/README.md)"), std::string::npos);
}

TEST(Documents, have_heading_levels_without_gaps_for_screen_readers) {
    for (const fs::path& page : pages()) {
        std::istringstream lines(prose_of(page));
        std::size_t before = 0;
        for (std::string line; std::getline(lines, line);) {
            const std::size_t level = line.find_first_not_of('#');
            if (level == 0 || level == std::string::npos || line[level] != ' ') continue;
            EXPECT_LE(level, before + 1) << page << ": " << line;
            before = level;
        }
    }
}

TEST(Documents, have_fewer_than_400_lines_and_one_title_each) {
    for (const fs::path& page : pages()) {
        const std::string text = test::content_of(page), prose = prose_of(page);
        EXPECT_LT(std::count(text.begin(), text.end(), '\n'), 400) << page;
        std::size_t titles = prose.starts_with("# ") ? 1 : 0;
        for (std::size_t at = prose.find("\n# "); at != std::string::npos; at = prose.find("\n# ", at + 1)) ++titles;
        EXPECT_EQ(titles, 1U) << page;
    }
}

// Checks the line that follows each table in docs/results, such as "Measured 2026-11-24, a machine, with a command."
TEST(Results, state_for_each_table_when_where_and_with_what_it_was_measured) {
    static const std::regex kMeasured(R"re(^Measured \d{4}-\d\d-\d\d, [^`]+, with ([^`]*`[^`]+`.*|the .*column)\.$)re");
    std::size_t tables = 0;
    for (const fs::path& page : pages()) {
        if (page.parent_path().filename() != "results") continue;
        std::istringstream lines(test::content_of(page));
        bool inside = false;
        std::string head;
        for (std::string line; std::getline(lines, line);) {
            const bool row = line.starts_with("|");
            if (row && !inside) head = line;
            if (!row && inside) {
                ++tables;
                EXPECT_TRUE(line.empty()) << page << ": an empty line ends the table " << head;
                line.clear();  // joins the lines, because the paragraph may be wrapped
                for (std::string part; std::getline(lines, part) && !part.empty();)
                    line += (line.empty() ? "" : " ") + part;
                EXPECT_TRUE(std::regex_match(line, kMeasured)) << page << ", after the table " << head << ": " << line;
            }
            inside = row;
        }
    }
    EXPECT_GE(tables, 15U);
    EXPECT_TRUE(std::regex_search(test::content_of(kRoot / "docs" / "bench.md"),
                                  std::regex(R"re(\nMeasured \d{4}-\d\d-\d\d[^\n]* on )re")));
}

}  // namespace docs_test
}  // namespace handrail
