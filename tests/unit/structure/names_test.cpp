// Tests that no two types have the same full name. If two libraries of one program each have such a type, the linker
// keeps one copy of a function for both, such as the growth of a vector. That function then writes past the end of the
// other type. Linkers do not report this (ISO C++20, 6.3, the one-definition rule: no diagnostic required).
#include <map>
#include <regex>
#include <sstream>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_files.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace names_test {

// Returns the type names of a text with their namespaces. Omits unnamed namespaces, because their types belong to one
// file only. Relies on the line layout of clang-format.
std::vector<std::string> types_of(const std::string& text) {
    static const std::regex opens("(?:inline )?namespace(?: ([A-Za-z0-9_:]+))? \\{"), closes("\\}  // namespace.*"),
        type("(?:template <.*> )?(?:struct|class|union|enum class|enum) (\\w+)(?: final)?(?: : [^;]*)? ?\\{.*");
    std::vector<std::string> within, found;
    std::istringstream lines(text);
    std::smatch part;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_match(line, part, opens)) within.push_back(part[1].str());
        else if (!within.empty() && std::regex_match(line, closes)) within.pop_back();
        else if (std::regex_match(line, part, type) &&
                 std::none_of(within.begin(), within.end(), [](const std::string& name) { return name.empty(); })) {
            std::string whole;
            for (const std::string& name : within) whole += name + "::";
            found.push_back(whole + part[1].str());
        }
    }
    return found;
}

TEST(Types, are_found_as_they_are_declared) {
    EXPECT_EQ(
        types_of("namespace a {\n\nstruct B {\n    struct Inner {};\n};\nclass C;\nclass C final : public B {\n"
                 "enum class D : std::uint8_t { E };\ntemplate <class T> struct F {\n"
                 "namespace {\nstruct Own {};\n}  // namespace\nnamespace b::c {\nstruct B {};\n}  // namespace b::c\n"
                 "struct G {};\n}  // namespace a\nstruct B {};\nstruct H made{1};\n"),
        (std::vector<std::string>{"a::B", "a::C", "a::D", "a::F", "a::b::c::B", "a::G", "B"}));
}

TEST(Types, with_the_same_full_name_are_in_only_one_file) {
    std::map<std::string, std::string> first;
    for (const std::string& file : test::project_files()) {
        if (!file.ends_with(".h") && !file.ends_with(".cpp")) continue;
        // Each folder of tests is a separate program, so its types may have the same names as types of other tests.
        const std::string program =
            file.starts_with("tests/") && !file.starts_with("tests/support/") ? file.substr(0, file.rfind('/')) : "";
        for (const std::string& name : types_of(test::content_of(test::project_root() / file))) {
            const auto [known, is_new] = first.try_emplace(program + " " + name, file);
            EXPECT_TRUE(is_new) << name << " is in " << known->second << " and in " << file
                                << "; give one of them another name.";
        }
    }
    EXPECT_GT(first.size(), 1000U);
}

}  // namespace names_test
}  // namespace handrail
