// Checks that the documents are readable: line and sentence lengths, odd turns of speech, spelling, and names that no
// longer exist. plain_pages.txt lists the pages that were rewritten for these rules; pages are only added to that list.
// The rules are in docs/developer/language.md.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/support/names.h"
#include "tests/support/project_files.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/docs/plain_english.h"
#include "tests/unit/docs/spelling.h"

namespace handrail {
namespace prose_test {
namespace fs = std::filesystem;

const fs::path kRoot = test::project_root();
const fs::path kHere = kRoot / "tests" / "unit" / "docs";

constexpr std::size_t kMostWords = 35, kMostColumns = 100;
constexpr double kMostWordsOnAverage = 20.0;

bool is_german(const std::string& page) { return page.starts_with("docs/de/"); }

struct ProseLine {
    std::size_t number = 0;
    std::string text;
};

// A paragraph, an item of a list, or a heading, with all its lines.
struct Block {
    std::vector<ProseLine> lines;
    bool heading = false, table = false;
};

bool begins_item(const std::string& line) {
    static const std::regex kItem(R"(^ {0,3}([-*]|\d+\.) .*)");
    return std::regex_match(line, kItem);
}

// Returns the text that people wrote on a page. Omits code, HTML, and quotations from the program between "<!-- ...
// -->" and "<!-- end -->".
std::vector<Block> read_blocks(const std::string& page) {
    std::istringstream lines(test::content_of(kRoot / page));
    std::vector<Block> blocks;
    bool code = false, quoted = false, open = false;
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.starts_with("```")) code = !code;
        if (line.starts_with("<!--")) quoted = line.find("end -->") == std::string::npos;
        const bool skipped = code || quoted || line.starts_with("```") || line.starts_with("<") ||
                             line.starts_with("    ") || line.find_first_not_of(' ') == std::string::npos;
        const bool table = line.starts_with("|"), heading = line.starts_with("#");
        if (skipped) {
            open = false;
            continue;
        }
        if (!open || table || heading || begins_item(line)) blocks.push_back({{}, heading, table});
        blocks.back().lines.push_back({number, line});
        open = !table && !heading;
    }
    return blocks;
}

// Returns the blocks of a page, and reads each page only once per process.
const std::vector<Block>& blocks_of(const std::string& page) {
    static std::map<std::string, std::vector<Block>> read;
    const auto at = read.find(page);
    return at != read.end() ? at->second : read.emplace(page, read_blocks(page)).first->second;
}

// Returns a block's text as one line. Replaces links by their words and code by `X`. Replaces the program's own texts,
// which have separate tests, by "X".
std::string words_of(const Block& block) {
    static const std::regex kIndent("^ +"), kQuoted("\"[^\"]*([.?!])\""), kSaid("\"[^\"]*[^\".?!]\"");
    static const std::regex kMark(R"(^ *([-*]|\d+\.|#+) +)"), kLink(R"(!?\[([^\]]*)\]\([^)]*\))"), kCode("`[^`]*`"),
        kAddress(R"(https?://\S+)");
    std::string text;
    for (const ProseLine& line : block.lines)
        text += (text.empty() ? "" : " ") + std::regex_replace(line.text, kIndent, "");
    text = std::regex_replace(text, kMark, "");
    text = std::regex_replace(text, kCode, "X");
    text = std::regex_replace(text, kLink, "$1");
    text = std::regex_replace(text, kQuoted, "\"X$1\"");
    text = std::regex_replace(text, kSaid, "\"X\"");
    return std::regex_replace(text, kAddress, "X");
}

std::vector<std::string> sentences_of(const std::string& text) {
    std::vector<std::string> sentences;
    static const std::set<std::string> kShort{"e.g.", "i.e.", "z. B.", "Nr.", "vs."};
    std::size_t from = 0;
    for (std::size_t i = 0; i + 2 < text.size(); ++i) {
        if (text[i] != '.' && text[i] != '?' && text[i] != '!') continue;
        std::size_t after = i + 1;
        while (after < text.size() && std::string_view("\")*_").find(text[after]) != std::string_view::npos) ++after;
        if (after + 1 >= text.size() || text[after] != ' ') continue;
        const auto next = static_cast<unsigned char>(text[after + 1]);
        if (!std::isupper(next) && !std::isdigit(next) && next < 0x80 && next != '"' && next != '*') continue;
        const std::size_t word = text.rfind(' ', i);
        if (kShort.contains(text.substr(word == std::string::npos ? 0 : word + 1, i - word))) continue;
        sentences.push_back(text.substr(from, after - from));
        from = after + 1;
    }
    if (from < text.size()) sentences.push_back(text.substr(from));
    return sentences;
}

std::size_t word_count(const std::string& sentence) {
    std::istringstream words(sentence);
    std::size_t count = 0;
    for (std::string word; words >> word;)
        count += std::any_of(word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c) || c >= 0x80; });
    return count;
}

std::string place_of(const std::string& page, const Block& block) {
    return page + ":" + std::to_string(block.lines.front().number);
}

TEST(Prose, list_of_plain_pages_names_only_existing_pages) {
    for (const std::string& page : test::listed_in("plain_pages.txt")) EXPECT_TRUE(fs::exists(kRoot / page)) << page;
}

TEST(Prose, has_sentences_of_20_words_on_average_and_35_at_most) {
    for (const std::string& page : test::listed_in("plain_pages.txt")) {
        std::size_t words = 0, sentences = 0;
        for (const Block& block : blocks_of(page)) {
            if (block.heading || block.table) continue;
            for (const std::string& sentence : sentences_of(words_of(block))) {
                const std::size_t count = word_count(sentence);
                EXPECT_LE(count, kMostWords) << place_of(page, block) << ": " << sentence;
                words += count;
                ++sentences;
            }
        }
        EXPECT_LE(static_cast<double>(words),
                  kMostWordsOnAverage * static_cast<double>(std::max<std::size_t>(sentences, 1)))
            << page << ": " << words << " words in " << sentences << " sentences";
    }
}

TEST(Prose, sentences_and_words_are_counted_correctly) {
    EXPECT_EQ(sentences_of("A door. See X. It is 1.5 m wide, e.g. here. \"Stop!\" He stops.").size(), 5U);
    EXPECT_EQ(word_count("A door - 0.9 m wide."), 5U);
}

// Tables and code cannot be wrapped, and neither can a link or a command that is longer than a line.
TEST(Prose, wraps_at_100_columns) {
    for (const std::string& page : test::listed_in("plain_pages.txt"))
        for (const Block& block : blocks_of(page)) {
            if (block.table) continue;
            for (const ProseLine& line : block.lines) {
                const auto columns = static_cast<std::size_t>(
                    std::count_if(line.text.begin(), line.text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
                if (columns <= kMostColumns) continue;
                const bool one_piece =
                    line.text.find(' ', line.text.find_first_not_of("- ")) == std::string::npos ||
                    std::regex_match(line.text,
                                     std::regex(R"re(^[- ]*[("]*(\[[^\]]*\]\([^)]*\)|`[^`]*`)[)".,:;]*$)re"));
                EXPECT_TRUE(one_piece) << page << ":" << line.number << ": " << columns << " columns";
            }
        }
}

// Returns whether a page may contain a pattern. The comments below give the reasons.
bool is_allowed(const std::string& page, const std::string& found) {
    static const std::set<std::pair<std::string, std::string>> kAllowed{
        // This page shows what not to write.
        {"docs/developer/language.md", "*"},
    };
    return kAllowed.contains({page, "*"}) || kAllowed.contains({page, found});
}

TEST(Prose, has_none_of_the_listed_patterns) {
    const std::vector<test::Search> english = test::searches(test::kEnglishPatterns),
                                    german = test::searches(test::kGermanPatterns);
    const std::regex any_english = test::any_of_them(test::kEnglishPatterns),
                     any_german = test::any_of_them(test::kGermanPatterns);
    for (const std::string& page : test::listed_in("plain_pages.txt"))
        for (const Block& block : blocks_of(page)) {
            if (block.table) continue;  // many tables are generated from the program's texts, which have separate tests
            const std::string text = words_of(block);
            if (!std::regex_search(text, is_german(page) ? any_german : any_english)) continue;
            for (const test::Search& search : is_german(page) ? german : english)
                EXPECT_TRUE(is_allowed(page, search.pattern->found) || !std::regex_search(text, search.searched))
                    << place_of(page, block) << ": \"" << search.pattern->found
                    << "\"; rather: " << search.pattern->instead << "\n"
                    << text;
        }
}

// Returns all files of the project except its documents, as one text.
const std::string& sources() {
    static const std::string kAll = [] {
        std::string all;
        for (const std::string& file : test::project_files())
            if (!file.ends_with(".md") && !file.ends_with(".svg") && !file.ends_with(".png") &&
                !file.starts_with("tests/fuzz/inputs/") && !file.starts_with("tests/golden/"))
                all += file + "\n" + test::content_of(kRoot / file) + "\n";
        return all;
    }();
    return kAll;
}

// A document names code such as `ServoLoop::open`, `force_n` or `haptic/servo/servo_loop.h`. Each part of the name must
// occur in the sources or be a file.
TEST(Prose, mentions_only_names_that_exist) {
    static const std::regex kCode("`([^`]+)`"),
        kName(R"(^(?:[A-Za-z_]\w*(?:::|\.|/))*[A-Za-z_]\w*(?:\.(?:h|cpp|sh|py|toml|md|txt|cmake))?(?:\(\))?$)");
    std::set<std::string> looked_up;
    for (const std::string& page : test::listed_in("plain_pages.txt"))
        for (const Block& block : blocks_of(page))
            for (const ProseLine& line : block.lines)
                for (auto it = std::sregex_iterator(line.text.begin(), line.text.end(), kCode);
                     it != std::sregex_iterator(); ++it) {
                    std::string name = (*it)[1];
                    const bool of_code = name.find('_') != std::string::npos || name.find("::") != std::string::npos ||
                                         name.find('/') != std::string::npos || name.ends_with("()") ||
                                         std::regex_match(name, std::regex("[A-Z][a-z]+[A-Z][A-Za-z]*"));
                    if (!of_code || !std::regex_match(name, kName) || !looked_up.insert(name).second) continue;
                    if (name.ends_with("()")) name.resize(name.size() - 2);
                    // Looks up the last part of a name within a class or a test suite.
                    const std::size_t scope = name.find_last_of(":.");
                    const bool file = name.find('/') != std::string::npos;
                    const std::string last = scope == std::string::npos || file ? name : name.substr(scope + 1);
                    // Another preset builds into another folder.
                    static const std::string kPrograms = "build/release/bin/";
                    const fs::path programs = fs::read_symlink("/proc/self/exe").parent_path();
                    const bool there =
                        fs::exists(kRoot / name) ||
                        (name.starts_with(kPrograms) && fs::exists(programs / name.substr(kPrograms.size()))) ||
                        sources().find(last) != std::string::npos ||
                        test::content_of(kHere / "names.txt").find("\n" + name + "\n") != std::string::npos;
                    EXPECT_TRUE(there) << page << ":" << line.number << " names `" << name << "`, which does not exist";
                }
    EXPECT_TRUE(looked_up.size() > 3 || test::listed_in("plain_pages.txt").size() < 5) << "names were not understood";
}

TEST(Prose, is_spelled_as_in_the_dictionaries_or_the_word_list) {
    if (!test::has_dictionary("en_GB") || !test::has_dictionary("de_DE"))
        GTEST_SKIP() << "needs hunspell, hunspell-en-gb and hunspell-de-de: the spelling of the documents";
    // A word consists of letters, with apostrophes and hyphens inside.
    static const std::regex kWord(R"((?:[A-Za-z]|[\xC3\xC5][\x80-\xBF])+(?:'[a-z]+)?)");
    for (const bool german : {false, true}) {
        std::map<std::string, std::string> places;
        std::set<std::string> words;
        for (const std::string& page : test::listed_in("plain_pages.txt")) {
            if (is_german(page) != german) continue;
            for (const Block& block : blocks_of(page)) {
                // Removes words with digits, file names and addresses, because a dictionary does not contain them.
                const std::string text =
                    std::regex_replace(words_of(block), std::regex(R"(\S*[\d_/\\]\S*|\S+\.\w+)"), " ");
                for (auto it = std::sregex_iterator(text.begin(), text.end(), kWord); it != std::sregex_iterator();
                     ++it)
                    if (words.insert(it->str()).second) places[it->str()] = place_of(page, block);
            }
        }
        const auto known = test::listed_in(german ? "words_de.txt" : "words_en.txt");
        const std::set<std::string> own(known.begin(), known.end());
        EXPECT_TRUE(std::is_sorted(known.begin(), known.end())) << "the word list is in the order of `LC_ALL=C sort`";
        for (const std::string& word : test::unknown_words(words, german ? "de_DE" : "en_GB"))
            EXPECT_TRUE(own.contains(word)) << places[word] << ": " << word;
        if (!german) {
            EXPECT_TRUE(test::unknown_words({"colour", "color"}, "en_GB") == std::set<std::string>{"color"});
        }
    }
}

}  // namespace prose_test
}  // namespace handrail
