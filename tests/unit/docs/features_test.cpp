// Tests that docs/features.md names only tests, commands, settings and options that exist.
#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/docs/table_rows.h"

namespace handrail {
namespace features_test {

namespace fs = std::filesystem;

struct Row {
    int number = 0;
    std::string feature, reached, tests;
};

std::vector<Row> rows() {
    static const std::regex kRow(R"(\| (\d+) \| ([^|]+) \| ([^|]+) \| ([^|]*)\|)");
    std::vector<Row> all;
    for (const std::string& line : test::table_rows("features.md", "| Row |")) {
        if (line.starts_with("| Row |")) continue;
        std::smatch cells;
        if (!std::regex_match(line, cells, kRow)) {
            ADD_FAILURE() << line;
            continue;
        }
        all.push_back({std::stoi(cells[1]), cells[2], cells[3], cells[4]});
    }
    return all;
}

std::vector<std::string> quoted(const std::string& text) {
    static const std::regex kQuoted("`([^`]+)`");
    std::vector<std::string> all;
    for (std::sregex_iterator it(text.begin(), text.end(), kQuoted), end; it != end; ++it) all.push_back((*it)[1]);
    return all;
}

// Returns the names of all tests, as `Suite.test`.
std::set<std::string> tests_of_the_project() {
    static const std::regex kTest(R"(\bTEST(?:_F|_P)?\((\w+),\s*(\w+)\))");
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(test::project_root() / "tests")) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string text = test::content_of(entry.path());
        for (std::sregex_iterator it(text.begin(), text.end(), kTest), end; it != end; ++it)
            names.insert((*it)[1].str() + "." + (*it)[2].str());
    }
    return names;
}

// Returns the text of README.md and of all other pages.
std::string other_pages() {
    std::string all = test::content_of(test::project_root() / "README.md");
    for (const auto& entry : fs::recursive_directory_iterator(test::project_root() / "docs"))
        if (entry.path().extension() == ".md" && entry.path().filename() != "features.md")
            all += test::content_of(entry.path());
    return all;
}

TEST(FeatureTable, has_rows_in_order_with_a_test_for_each_feature_that_exists) {
    const std::vector<Row> all = rows();
    EXPECT_GT(all.size(), 90U);
    int before = 0;
    for (const Row& row : all) {
        EXPECT_GT(row.number, before);
        before = row.number;
        const bool missing = row.reached.starts_with("not yet");
        EXPECT_EQ(quoted(row.tests).empty(), missing && quoted(row.reached).empty()) << row.number;
    }
}

TEST(FeatureTable, names_only_tests_that_exist) {
    const std::set<std::string> known = tests_of_the_project();
    ASSERT_GT(known.size(), 2000U);
    for (const Row& row : rows())
        for (const std::string& name : quoted(row.tests))
            EXPECT_TRUE(known.contains(name)) << row.number << ": " << name;
}

// The other pages are tested against the program, so what is quoted here must be there.
TEST(FeatureTable, names_only_commands_keys_and_options_that_the_guides_have) {
    static const std::regex kCommand("`([a-z-]+)` \\(([^)]+)\\)");
    const std::string pages = other_pages(), keys = test::content_of(test::project_root() / "docs/user-guide/keys.md");
    for (const Row& row : rows()) {
        for (std::sregex_iterator it(row.reached.begin(), row.reached.end(), kCommand), end; it != end; ++it) {
            const std::string line = "- `" + (*it)[1].str() + "` (";
            const std::size_t at = keys.find(line);
            ASSERT_NE(at, std::string::npos) << row.number << ": " << line;
            EXPECT_NE(keys.substr(at, keys.find(')', at) - at).find((*it)[2]), std::string::npos) << line << (*it)[2];
        }
        for (const std::string& quote : quoted(row.reached)) {
            std::istringstream words(quote);
            std::string first;
            words >> first;
            EXPECT_NE(pages.find(first), std::string::npos) << row.number << ": " << first;
            for (std::string word; words >> word;) {
                const bool command = first == "handrail" && std::islower(static_cast<unsigned char>(word[0]));
                if (!command && !word.starts_with("--")) continue;
                EXPECT_NE(pages.find(word), std::string::npos) << row.number << ": " << word;
            }
        }
    }
}

}  // namespace features_test
}  // namespace handrail
