// Limits the size of classes and files.
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_files.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace size_test {

constexpr int kMostPublicFunctions = 40, kMostMembers = 25, kMostLinesOfApp = 500, kMostBranches = 40;

struct ClassSize {
    int public_functions = 0, members = 0;
};

using ClassSizes = std::map<std::string, ClassSize>;

// Returns the text without the contents of comments, literals and preprocessor lines. Line ends stay.
std::string bare(const std::string& text) {
    std::string out;
    bool at_line_start = true;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '#' && at_line_start) {
            while (i < text.size() && (text[i] != '\n' || text[i - 1] == '\\')) ++i;
        } else if (text.compare(i, 2, "//") == 0) {
            i = std::min(text.find('\n', i), text.size());
        } else if (text.compare(i, 2, "/*") == 0) {
            i = std::min(text.find("*/", i + 2), text.size() - 2) + 1;
            continue;
        } else if (text.compare(i, 3, "R\"(") == 0) {
            i = std::min(text.find(")\"", i), text.size() - 2) + 1;
            continue;
        } else if (c == '"' || (c == '\'' && (i == 0 || std::isalnum(static_cast<unsigned char>(text[i - 1])) == 0))) {
            for (++i; i < text.size() && text[i] != c; ++i)
                if (text[i] == '\\') ++i;
            out += '0';
            continue;
        }
        if (i < text.size()) out += text[i];
        if (i < text.size() && text[i] == '\n') at_line_start = true;
        else if (c != ' ' && c != '\t') at_line_start = false;
    }
    return out;
}

std::size_t behind_braces(const std::string& text, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
        depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
        if (depth == 0) return i + 1;
    }
    return text.size();
}

bool begins_with_word(const std::string& text, std::string_view word) {
    return text.starts_with(word) &&
           (text.size() == word.size() || std::isalnum(static_cast<unsigned char>(text[word.size()])) == 0);
}

// Adds one declaration to the size of its class. The caller has reduced bodies and initialisers in braces to {}.
void count(std::string declaration, bool is_public, ClassSize& size) {
    for (const char* word : {"using", "friend", "enum", "static_assert", "typedef", "static", "class", "struct"})
        if (begins_with_word(declaration, word) &&
            !(std::string_view(word) == "static" && declaration.find('(') != std::string::npos))
            return;
    if (declaration.find("= delete") != std::string::npos) return;
    int angle = 0, bracket = 0, names = 1;
    bool function = declaration.find("operator") != std::string::npos;
    bool initialised = false;
    for (const char c : declaration) {
        if (function) break;
        angle += c == '<' ? 1 : c == '>' ? -1 : 0;
        if (c == '=' || c == '{') initialised = true;
        if (c == '(' && angle == 0 && !initialised) function = true;
        bracket += c == '(' || c == '[' || c == '{' ? 1 : c == ')' || c == ']' || c == '}' ? -1 : 0;
        names += c == ',' && angle == 0 && bracket == 0;
    }
    if (!function) size.members += names;
    else size.public_functions += is_public;
}

void read_classes(const std::string& text, std::size_t begin, std::size_t end, const std::string& within,
                  ClassSizes& found);

// Counts the declarations between the braces of a class.
void read_class(const std::string& text, std::size_t begin, std::size_t end, const std::string& name, bool is_public,
                ClassSizes& found) {
    ClassSize& size = found[name];
    std::string declaration;
    for (std::size_t i = begin; i < end; ++i) {
        const char c = text[i];
        if (c == '{') {
            const std::size_t behind = std::min(behind_braces(text, i), end);
            const std::size_t next = text.find_first_not_of(" \t\n", behind);
            // A nested type counts as a class. If a name follows its braces, it also declares a member.
            if (begins_with_word(declaration, "class") || begins_with_word(declaration, "struct")) {
                read_classes(text, i - declaration.size(), behind, name, found);
                declaration = next < end && text[next] != ';' ? "type " : "";
                i = behind - 1;
                continue;
            }
            declaration += "{}";
            i = behind - 1;
            // After the body of a function, no semicolon follows.
            const bool body =
                declaration.find('(') != std::string::npos && (next >= end || (text[next] != ';' && text[next] != ','));
            if (!body) continue;
            count(declaration, is_public, size);
            declaration.clear();
        } else if (c == ';') {
            if (!declaration.empty()) count(declaration, is_public, size);
            declaration.clear();
        } else if (c == ':' && (declaration == "public" || declaration == "private" || declaration == "protected")) {
            is_public = declaration == "public";
            declaration.clear();
        } else if (!declaration.empty() || std::isspace(static_cast<unsigned char>(c)) == 0) {
            declaration += c;
        }
    }
}

// Finds every class and struct with a body. Names nested ones "Outer::Inner".
void read_classes(const std::string& text, std::size_t begin, std::size_t end, const std::string& within,
                  ClassSizes& found) {
    for (std::size_t i = begin; i < end; ++i) {
        if (i > 0 && (std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0 || text[i - 1] == '_')) continue;
        const std::string rest = text.substr(i, 7);
        const bool is_class = begins_with_word(rest, "class"), is_struct = begins_with_word(rest, "struct");
        if (!is_class && !is_struct) continue;
        // If one of these other characters comes before the brace, the keyword begins a declaration, or a parameter of
        // a template or function.
        const std::size_t stop = text.find_first_of("{;()=>,", i);
        if (stop == std::string::npos || stop >= end || text[stop] != '{') continue;
        if (i >= 5 && text.compare(i - 5, 5, "enum ") == 0) continue;
        std::istringstream words(text.substr(i, stop - i));
        std::string word, name;
        words >> word >> name;
        if (name.empty() || name.front() == ':') name = "(without a name)";
        while (!name.empty() && name.back() == ':') name.pop_back();
        const std::size_t behind = behind_braces(text, stop);
        read_class(text, stop + 1, behind - 1, within.empty() ? name : within + "::" + name, is_struct, found);
        i = behind - 1;
    }
}

ClassSizes classes_of(const std::string& source) {
    ClassSizes found;
    const std::string text = bare(source);
    read_classes(text, 0, text.size(), "", found);
    return found;
}

TEST(Classes, are_found_as_they_are_declared) {
    const ClassSizes found = classes_of(R"(
#define SOME class Nothing { int a; };
class Ahead;
template <class T> struct Held { T one, two = T{1, 2}; };
// class Commented { int a; };
class House : public Wall {
public:
    House(int a, double b = 3.0) : a_(a) { if (a) { b_ = {b}; } }
    ~House() override = default;
    House(const House&) = delete;
    [[nodiscard]] int rooms() const { return a_; }
    std::vector<int> doors(const std::map<int, int>& by, char c = '"') const;
    bool operator<(const House&) const = default;
    static House built();
    static constexpr int kMost = 3;
    enum class Side { Left, Right };
    struct Room { double width_m = 1.0; int number() const; };
    std::function<void(int, int)> on_enter;
    using Number = int;
protected:
    void hidden();
private:
    struct Part { int x; } part_;
    std::map<std::string, int> names_{{"a", 1}};
    int a_ = f(1), b_[2], c_{};
    friend class Other;
};
)");
    ASSERT_TRUE(found.contains("House"));
    EXPECT_EQ(found.at("House").public_functions, 6);
    EXPECT_EQ(found.at("House").members, 6);
    EXPECT_EQ(found.at("House::Room").public_functions, 1);
    EXPECT_EQ(found.at("House::Room").members, 1);
    EXPECT_EQ(found.at("House::Part").members, 1);
    EXPECT_EQ(found.at("Held").members, 2);
    EXPECT_EQ(found.size(), 4U);
}

bool is_app(const std::string& file) {
    return file.starts_with("app/") && (file.ends_with(".h") || file.ends_with(".cpp"));
}

TEST(Classes, of_the_app_are_small) {
    std::size_t looked_at = 0;
    for (const std::string& file : test::project_files()) {
        if (!is_app(file)) continue;
        for (const auto& [name, size] : classes_of(test::content_of(test::project_root() / file))) {
            ++looked_at;
            EXPECT_LE(size.public_functions, kMostPublicFunctions) << name << " in " << file << ": public functions";
            EXPECT_LE(size.members, kMostMembers) << name << " in " << file << ": members";
        }
    }
    EXPECT_GT(looked_at, 100U);
}

TEST(Files, of_the_app_are_short) {
    std::size_t looked_at = 0;
    for (const std::string& file : test::project_files()) {
        if (!is_app(file)) continue;
        const std::string text = test::content_of(test::project_root() / file);
        ++looked_at;
        EXPECT_LE(std::count(text.begin(), text.end(), '\n'), kMostLinesOfApp) << file;
    }
    EXPECT_GT(looked_at, 50U);
}

TEST(Lines, of_sources_have_at_most_120_columns) {
    for (const std::string& file : test::project_files()) {
        if (!file.ends_with(".h") && !file.ends_with(".cpp") && !file.ends_with(".c")) continue;
        std::istringstream text(test::content_of(test::project_root() / file));
        int number = 0;
        for (std::string line; std::getline(text, line);) {
            ++number;
            const auto columns = std::count_if(line.begin(), line.end(),
                                               [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
            EXPECT_LE(columns, 120) << file << ":" << number;
        }
    }
}

// pmccabe computes McCabe's cyclomatic number, in which a whole switch adds one. The tool does not understand nested
// namespace names such as a::b and counts words in comments. So it reads copies with simple names and no comments.
TEST(Functions, have_few_branches) {
    if (std::system("command -v pmccabe >/dev/null") != 0) GTEST_SKIP() << "pmccabe is not installed";
    const test::TemporaryFolder copies;
    std::string command = "cd '" + copies.path().string() + "' && pmccabe";
    static const std::regex comment("\\n *//[^\\n]*"), several("\\nnamespace handrail::\\w+ \\{");
    for (const std::string& file : test::project_files()) {
        if (!file.ends_with(".cpp") || file.starts_with("tests/")) continue;
        const std::filesystem::path copy = copies.path() / file;
        std::filesystem::create_directories(copy.parent_path());
        const std::string text = std::regex_replace(test::content_of(test::project_root() / file), comment, "\n");
        std::ofstream(copy) << std::regex_replace(text, several, "\nnamespace handrail {");
        command += " '" + file + "'";
    }
    FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    std::size_t looked_at = 0;
    std::array<char, 4096> line{};
    while (std::fgets(line.data(), line.size(), pipe)) {
        // The columns are: branches, branches with each case counted, statements, first line, lines, file(line): name.
        std::istringstream fields(line.data());
        int branches = 0;
        fields >> branches;
        ++looked_at;
        EXPECT_LE(branches, kMostBranches) << line.data() << "Divide it into stages.";
    }
    ::pclose(pipe);
    EXPECT_GT(looked_at, 5000U);
}

}  // namespace size_test
}  // namespace handrail
