// Checks that the comments of the code are readable: no odd turns of speech, and correct spelling. The rules are in
// docs/developer/language.md.
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_files.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/docs/plain_english.h"
#include "tests/unit/docs/spelling.h"

namespace handrail {
namespace comments_test {

struct Comment {
    std::size_t line = 0;
    std::string text;
};

// Returns the comments of a source file: what follows "//" on each line. Joins a comment that continues on the next
// line without code. Ignores "//" in strings.
std::vector<Comment> comments_of(const std::string& source) {
    std::vector<Comment> found;
    std::size_t line = 1;
    // `code`: this line has code. `continues`: the previous line ended with a comment.
    bool code = false, continues = false;
    for (std::size_t i = 0; i < source.size(); ++i) {
        const char c = source[i];
        if (c == '\n') {
            ++line;
            continues = continues && !code && !found.empty() && found.back().line + 1 >= line;
            code = false;
        } else if (source.compare(i, 3, "R\"(") == 0 || source.compare(i, 5, "R\"re(") == 0) {
            const std::string end = source[i + 2] == '(' ? ")\"" : ")re\"";
            const std::size_t at = std::min(source.find(end, i), source.size() - 1);
            line += static_cast<std::size_t>(std::count(source.begin() + static_cast<std::ptrdiff_t>(i),
                                                        source.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
            i = at + end.size() - 1;
            code = true;
        } else if (c == '"' || (c == '\'' && (i == 0 || !std::isalnum(static_cast<unsigned char>(source[i - 1]))))) {
            for (++i; i < source.size() && source[i] != c && source[i] != '\n'; ++i)
                if (source[i] == '\\') ++i;
            code = true;
        } else if (source.compare(i, 2, "//") == 0) {
            const std::size_t end = std::min(source.find('\n', i), source.size());
            const std::string text = source.substr(i + 2, end - i - 2);
            if (!code && !found.empty() && continues) found.back().text += text;
            else found.push_back({line, text});
            found.back().line = line;
            continues = true;
            i = end - 1;
        } else if (c != ' ') {
            code = true;
        }
    }
    return found;
}

TEST(Comments, are_found_outside_strings_and_joined_over_lines) {
    const auto found = comments_of(
        "// One\n// goes on.\nint a = 1'000;  // Two\nauto s = \"// no\";\nchar c = '\"';  // Three\n\n// Four\n"
        "auto r = R\"(// no\n// no)\";  // Five\n");
    std::string all;
    for (const Comment& comment : found) all += comment.text + "|";
    EXPECT_EQ(all, " One goes on.| Two| Three| Four| Five|");
    EXPECT_EQ(found.back().line, 9U);
}

template <class Look>
void look_at_all(const Look& look) {
    for (const std::string& file : test::project_files()) {
        if (!file.ends_with(".h") && !file.ends_with(".cpp")) continue;
        if (file == "tests/unit/docs/plain_english.h") continue;  // this file shows what not to write
        for (const Comment& comment : comments_of(test::content_of(test::project_root() / file))) look(file, comment);
    }
}

TEST(Comments, have_none_of_the_listed_patterns) {
    const std::vector<test::Search> searches = test::searches(test::kEnglishPatterns);
    const std::regex any = test::any_of_them(test::kEnglishPatterns);
    look_at_all([&](const std::string& file, const Comment& comment) {
        static const std::regex code("`[^`]*`");
        const std::string text = std::regex_replace(comment.text, code, "");
        if (!std::regex_search(text, any)) return;
        for (const test::Search& search : searches)
            EXPECT_FALSE(search.pattern->in_comments && std::regex_search(text, search.searched))
                << file << ":" << comment.line << ": \"" << search.pattern->found
                << "\"; rather: " << search.pattern->instead << "\n"
                << comment.text;
    });
}

// The names of people, programs and code are in words_code.txt. Other permitted words are in words_en.txt, which the
// tests of the documents use, too.
TEST(Comments, are_spelled_as_the_dictionary_or_the_word_lists_have_it) {
    if (!test::has_dictionary("en_GB")) GTEST_SKIP() << "needs hunspell and hunspell-en-gb: the spelling of comments";
    // The test skips code and quoted texts. It also skips words with digits, underscores or inner capitals, and words
    // that are part of a name.
    static const std::regex quoted(R"(`[^`]*`|"[^"]*")"), word(R"(^\(?([A-Za-z]?[a-z]{2,}('[a-z]+)?)[.,;:?!)]*$)");
    std::map<std::string, std::string> places;
    std::set<std::string> words;
    look_at_all([&](const std::string& file, const Comment& comment) {
        std::istringstream parts(std::regex_replace(comment.text, quoted, " "));
        std::smatch found;
        for (std::string part; parts >> part;)
            if (std::regex_match(part, found, word) && words.insert(found[1]).second)
                places[found[1]] = file + ":" + std::to_string(comment.line);
    });
    std::set<std::string> own;
    for (const char* list : {"words_en.txt", "words_code.txt"})
        for (const std::string& known : test::listed_in(list)) own.insert(known);
    for (const std::string& unknown : test::unknown_words(words, "en_GB"))
        EXPECT_TRUE(own.contains(unknown)) << places[unknown] << ": " << unknown;
    EXPECT_GT(words.size(), 4000U);
}

}  // namespace comments_test
}  // namespace handrail
