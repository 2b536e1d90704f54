// Tests that in each folder, the name of a constant stands for only one number. For measures of people, the name must
// stand for only one number in the whole program.
#include <map>
#include <regex>
#include <set>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_files.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace constants_test {

std::string without_comments(const std::string& text) {
    static const std::regex comment("//[^\n]*");
    return std::regex_replace(text, comment, "");
}

// Returns the names that a text declares as constants. If `of_namespaces` is true, returns only constants outside
// classes and functions, which clang-format does not indent.
std::set<std::string> constants_of(const std::string& text, bool of_namespaces) {
    static const std::regex free("(?:^|\n)(?:inline |static )*constexpr [^;({]*?\\bk[A-Z]\\w*[^;]*;"),
        any("\\bconstexpr [^;({]*?\\bk[A-Z]\\w*[^;]*;"), name("\\b(k[A-Z]\\w*)(?:\\[\\w*\\])? ?[={]");
    const std::string bare = without_comments(text);
    std::set<std::string> names;
    const std::regex& declaration = of_namespaces ? free : any;
    for (std::sregex_iterator at(bare.begin(), bare.end(), declaration), end; at != end; ++at) {
        const std::string one = at->str();
        for (std::sregex_iterator n(one.begin(), one.end(), name); n != end; ++n) names.insert((*n)[1]);
    }
    return names;
}

bool is_of_the_program(const std::string& file) {
    return (file.ends_with(".h") || file.ends_with(".cpp")) && !file.starts_with("tests/");
}

TEST(Constants, are_found_in_every_form_of_declaration) {
    const std::string text =
        "constexpr double kOne_m = 1.0, kTwo_m = 2.0;  // kNone = 3\ninline constexpr int kThree = 3;\n"
        "struct S {\n    static constexpr int kFour = 4;\n};\nconstexpr std::size_t kFive{5};\nint a = kSix;\n"
        "void f() {\n    constexpr double kSeven = kOne_m + 7.0;\n}\n";
    EXPECT_EQ(constants_of(text, true), (std::set<std::string>{"kOne_m", "kTwo_m", "kThree", "kFive"}));
    EXPECT_EQ(constants_of(text, false),
              (std::set<std::string>{"kOne_m", "kTwo_m", "kThree", "kFour", "kFive", "kSeven"}));
}

TEST(Constants, with_the_same_name_are_in_only_one_file_of_a_folder) {
    std::map<std::string, std::string> first;
    for (const std::string& file : test::project_files()) {
        if (!is_of_the_program(file)) continue;
        for (const std::string& name : constants_of(test::content_of(test::project_root() / file), true)) {
            const auto [known, is_new] = first.try_emplace(file.substr(0, file.rfind('/')) + " " + name, file);
            EXPECT_TRUE(is_new) << name << " is in " << known->second << " and in " << file
                                << "; give one of them a name that says what differs.";
        }
    }
    EXPECT_GT(first.size(), 1000U);
}

TEST(Constants, that_describe_human_measures_have_one_value) {
    const std::string header = "worlds/base/human_measures.h";
    const std::set<std::string> measures = constants_of(test::content_of(test::project_root() / header), true);
    EXPECT_GE(measures.size(), 15U);
    for (const std::string& file : test::project_files()) {
        if (!is_of_the_program(file) || file == header) continue;
        for (const std::string& name : constants_of(test::content_of(test::project_root() / file), false))
            EXPECT_FALSE(measures.contains(name)) << file << " has a " << name << " of its own; include " << header;
    }
}

}  // namespace constants_test
}  // namespace handrail
