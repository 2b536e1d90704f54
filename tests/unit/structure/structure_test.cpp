// Checks the structure of the project in its own files: which folder may include which, what is at the top level, and
// what no file may contain.
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

#include "tests/support/names.h"
#include "tests/support/project_files.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace structure_test {
namespace fs = std::filesystem;

const fs::path kRoot = test::project_root();

constexpr const char* kProgram[] = {"app/", "audio-cues/", "haptic/", "settings/", "worlds/"};

bool is_source(const std::string& file) { return file.ends_with(".h") || file.ends_with(".cpp"); }

// The folders that each folder may include in addition to itself. The list contains the dependencies of everything that
// the folder links. docs/architecture/folders.md has the same list.
const std::map<std::string, std::vector<std::string>> kMayLink{
    {"worlds/base", {}},
    {"worlds/confine", {"worlds/base"}},
    {"worlds/geometry", {"worlds/base"}},
    {"settings", {"worlds/base"}},
    {"worlds/scene", {"worlds/base", "worlds/geometry"}},
    {"worlds/ifc", {"worlds/scene"}},
    {"worlds/floorplan", {"worlds/scene"}},
    {"worlds/osm", {"worlds/floorplan"}},
    {"worlds/imdf", {"worlds/floorplan"}},
    {"worlds/words", {"worlds/floorplan"}},
    {"worlds/readers", {"worlds/scene", "worlds/ifc", "worlds/osm", "worlds/imdf", "worlds/words"}},
    {"worlds/navigation", {"worlds/scene"}},
    {"worlds/cache", {"worlds/base"}},
    {"worlds/stored", {"worlds/scene", "worlds/navigation", "worlds/cache"}},
    {"worlds/plan", {"worlds/scene", "worlds/navigation"}},
    {"worlds/exports", {"worlds/plan", "worlds/navigation", "worlds/words"}},
    {"worlds/check", {"worlds/navigation"}},
    {"haptic/render", {"worlds/geometry", "settings"}},
    {"haptic/compile", {"haptic/render", "worlds/scene"}},
    {"haptic/c", {"haptic/compile", "worlds/readers"}},
    {"haptic/dynamics", {"haptic/render"}},
    {"haptic/device", {"worlds/base", "settings"}},
    {"haptic/loop", {"haptic/device"}},
    {"haptic/drivers", {"haptic/device", "worlds/confine"}},
    {"haptic/servo", {"haptic/render", "haptic/device"}},
    {"audio-cues/plan", {"worlds/scene", "settings", "haptic/servo"}},
    {"audio-cues/sinks", {"audio-cues/plan"}},
    {"app/core/dialogue", {"worlds/scene", "settings"}},
    {"app/core/kept", {"app/core/dialogue", "worlds/navigation"}},
    {"app/core/world", {"app/core/kept", "haptic/compile", "haptic/servo"}},
    {"app/core/context", {"app/core/world", "audio-cues/plan"}},
    {"app/core/hand", {"app/core/context"}},
    {"app/core/walking", {"app/core/context"}},
    {"app/core/whereabouts", {"app/core/context", "worlds/stored"}},
    {"app/core/movers", {"app/core/context"}},
    {"app/core/bodies", {"app/core/context", "haptic/dynamics"}},
    {"app/core/desk", {"app/core/context"}},
    {"app/core/lessons", {"app/core/context"}},
    {"app/core/wayfinding", {"app/core/hand", "app/core/whereabouts", "app/core/movers"}},
    {"app/core/learning", {"app/core/wayfinding", "app/results"}},
    {"app/core/labyrinth", {"app/core/bodies", "app/core/learning"}},
    {"app/core/menu", {"app/core/wayfinding"}},
    {"app/core/places", {"app/core/wayfinding", "worlds/check"}},
    {"app/core/session",
     {"app/core/bodies", "app/core/desk", "app/core/labyrinth", "app/core/lessons", "app/core/walking",
      "app/core/learning", "app/core/menu", "app/core/places"}},
    {"app/core/scenario", {"app/core/session", "worlds/readers"}},
    {"app/page", {"app/core/session"}},
    {"app/page/browser", {"app/page"}},
    {"app/import", {"worlds/readers", "worlds/stored", "worlds/confine", "settings"}},
    {"app/reader", {"app/import"}},
    {"app/record", {"app/core/scenario", "audio-cues/sinks"}},
    {"app/learners", {"app/record"}},
    {"app/teaching", {"app/core/scenario", "app/results"}},
    {"app/report", {"worlds/plan"}},
    {"app/results", {"worlds/base"}},
    {"app/terminal", {"worlds/base"}},
    {"app/wizard", {"app/core/session"}},
    {"app/window", {"app/core/context", "worlds/plan"}},
    {"app/accessible", {"app/window", "audio-cues/sinks"}},
    {"app/companions", {"app/core/session", "haptic/drivers"}},
    {"app/guard", {"haptic/drivers"}},
    {"app/main",
     {"app/core/scenario", "app/import", "app/record", "app/learners", "app/report", "app/results", "app/teaching",
      "app/companions", "app/terminal", "app/wizard", "app/window", "app/accessible", "audio-cues/sinks",
      "haptic/drivers", "worlds/confine", "worlds/exports", "worlds/check"}},
};

void reach(const std::string& folder, std::set<std::string>& reached) {
    if (!reached.insert(folder).second) return;
    for (const std::string& next : kMayLink.at(folder)) reach(next, reached);
}

// Returns "worlds/base" for "worlds/base/text.h" and "settings" for "settings/table.h".
std::string folder_of(const std::string& path) { return fs::path(path).parent_path().string(); }

// Returns the quoted includes in a source text.
std::vector<std::string> includes_of(const std::string& text) {
    static const std::regex kInclude(R"re(^[ \t]*#[ \t]*include[ \t]*"([^"]+)")re", std::regex::multiline);
    std::vector<std::string> found;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), kInclude); it != std::sregex_iterator(); ++it)
        found.push_back((*it)[1]);
    return found;
}

// Returns true for files of the program itself, which are those outside tests.
bool is_program(const std::string& file) { return !file.starts_with("tests/"); }

// Returns why `file` may not include `included`; empty if it may.
std::string refusal(const std::string& file, const std::string& included) {
    const std::string from = folder_of(file), to = folder_of(included);
    if (!kMayLink.contains(from)) return file + " lies in a folder that the table does not list: " + from;
    if (!kMayLink.contains(to))
        return file + " includes \"" + included +
               "\", which is in no listed folder; write the path from the project's root";
    std::set<std::string> reached;
    reach(from, reached);
    return reached.contains(to) ? "" : file + " includes " + included + ", but " + from + " may not know " + to;
}

TEST(IncludeDirection, is_respected_by_every_source_file_of_the_program) {
    std::size_t looked_at = 0;
    for (const std::string& file : test::project_files()) {
        if (!is_source(file) || !is_program(file)) continue;
        const std::string text = test::content_of(kRoot / file);
        if (text.empty()) continue;  // the file was deleted, but the deletion is not committed yet
        ++looked_at;
        EXPECT_TRUE(kMayLink.contains(folder_of(file))) << file << " lies in a folder that the table does not list";
        for (const std::string& included : includes_of(text)) EXPECT_EQ(refusal(file, included), "");
    }
    EXPECT_GT(looked_at, 40U) << "the project's files were not found";
}

TEST(IncludeDirection, violations_are_detected_by_this_test) {
    EXPECT_EQ(includes_of("#pragma once\n  #  include \"a/b.h\"\n#include <vector>\n// #include \"c.h\"\n"),
              std::vector<std::string>{"a/b.h"});
    EXPECT_NE(refusal("haptic/render/touch.cpp", "worlds/scene/scene.h"), "");
    EXPECT_NE(refusal("app/core/session/core.cpp", "app/window/window.h"), "");
    EXPECT_NE(refusal("app/core/walking/steps.cpp", "app/core/session/core.h"), "");
    EXPECT_NE(refusal("app/core/hand/hand.cpp", "app/core/desk/desk.h"), "");
    EXPECT_NE(refusal("haptic/render/touch.cpp", "tests/bench/compare/bench.h"), "");
    EXPECT_NE(refusal("app/main/main.cpp", "tests/support/touch_worlds.h"), "");
    EXPECT_NE(refusal("app/core/session/core.cpp", "audio-cues/sinks/openal_sink.h"), "");
    EXPECT_NE(refusal("worlds/new/file.cpp", "worlds/base/text.h"), "");
    EXPECT_NE(refusal("worlds/base/text.cpp", "text.h"), "");
    EXPECT_EQ(refusal("app/core/session/core.cpp", "worlds/base/text.h"), "");
}

// Checks the calls of handrail_library(NAME FOLDER LINK ... PRIVATE ...) in the CMake lists. No folder may link a
// library of a folder that it may not include.
TEST(IncludeDirection, is_respected_by_the_link_lines_too) {
    static const std::regex kLibrary(R"(handrail_library\(\s*(handrail_\w+)\s+([\w/-]+)([^)]*)\))");
    std::map<std::string, std::string> folder_by_library;
    std::vector<std::pair<std::string, std::string>> links;  // pairs of folder and library
    for (const std::string& file : test::project_files()) {
        if (!file.ends_with("CMakeLists.txt") || file == "CMakeLists.txt" || !is_program(file)) continue;
        const std::string text = test::content_of(kRoot / file);
        for (auto it = std::sregex_iterator(text.begin(), text.end(), kLibrary); it != std::sregex_iterator(); ++it) {
            folder_by_library[(*it)[1]] = (*it)[2];
            std::istringstream words((*it)[3]);
            for (std::string word; words >> word;)
                if (word.starts_with("handrail_")) links.emplace_back((*it)[2], word);
        }
    }
    EXPECT_GE(folder_by_library.size(), 10U) << "the CMake lists were not understood";
    for (const auto& [folder, library] : links) {
        ASSERT_TRUE(folder_by_library.contains(library)) << library;
        EXPECT_EQ(refusal(folder + "/CMakeLists.txt", folder_by_library[library] + "/x.h"), "");
    }
}

TEST(IncludeDirection, is_listed_correctly_in_the_architecture_document) {
    std::istringstream lines(test::content_of(kRoot / "docs" / "architecture" / "folders.md"));
    std::set<std::string> items;
    std::string item;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("  ") || item.empty()) items.insert(std::exchange(item, line));
        else item += line.substr(1);
    }
    items.insert(item);
    for (const auto& [folder, links] : kMayLink) {
        std::string wanted = "- " + folder + ": " + (links.empty() ? "nothing of ours" : "");
        for (std::size_t i = 0; i < links.size(); ++i) wanted += (i ? ", " : "") + links[i];
        EXPECT_TRUE(items.contains(wanted)) << "docs/architecture/folders.md lacks: " << wanted;
    }
}

// `docs/architecture_picture.py` draws the picture from the include lines alone.
TEST(IncludeDirection, is_drawn_correctly_in_the_architecture_document) {
    if (std::system("command -v python3 >/dev/null 2>&1") != 0) GTEST_SKIP() << "python3 is not installed";
    EXPECT_EQ(std::system(("python3 '" + (kRoot / "docs" / "architecture_picture.py").string() + "' --check").c_str()),
              0);
    EXPECT_NE(test::content_of(kRoot / "docs" / "architecture.md").find("](architecture.svg)"), std::string::npos)
        << "the document does not show it";
}

TEST(TopLevel, contains_only_the_names_that_belong_there) {
    const std::set<std::string> allowed{".ci",
                                        ".clang-format",
                                        ".clang-tidy",
                                        ".clangd",
                                        ".gitignore",
                                        "CMakeLists.txt",
                                        "CMakePresets.json",
                                        "CONTRIBUTING.md",
                                        "NEWS.md",
                                        "LICENSE",
                                        "README.md",
                                        "app",
                                        "audio-cues",
                                        "docs",
                                        "haptic",
                                        "run",
                                        "settings",
                                        "tests",
                                        "worlds"};
    for (const std::string& file : test::project_files())
        EXPECT_TRUE(allowed.contains(file.substr(0, file.find('/')))) << file;
}

// A path of a developer's machine is private and does not exist on other machines, so no file may contain one. System
// folders that Debian guarantees are allowed.
const std::regex& machine_path() {
    static const std::regex kPath(R"((^|[\s"'=(:`])/(home|root|work|mnt|media|Users|workspace)/[A-Za-z0-9_.-])",
                                  std::regex::multiline);
    return kPath;
}

TEST(Files, mention_no_absolute_folder_of_a_single_machine) {
    for (const std::string& file : test::project_files()) {
        std::error_code ec;
        if (!fs::is_regular_file(kRoot / file, ec) || fs::file_size(kRoot / file, ec) > 2'000'000 ||
            file.ends_with(".png"))
            continue;
        std::smatch found;
        std::istringstream lines(test::content_of(kRoot / file));
        int number = 0;
        for (std::string line; std::getline(lines, line);) {
            ++number;
            EXPECT_FALSE(line.size() < 2000 && std::regex_search(line, found, machine_path()))
                << file << ":" << number << ": " << line;
        }
    }
    EXPECT_TRUE(std::regex_search(std::string("see \"/ho") + "me/ann/x\"", machine_path()));
    EXPECT_FALSE(std::regex_search(std::string("/usr/share/fonts and worlds/maps"), machine_path()));
}

// A path from a user may name a pipe, a device or a folder. Only worlds/base/files knows how to open those safely.
TEST(Files, that_a_person_names_are_opened_in_only_one_place) {
    const std::regex by_itself(R"(\b(std::ifstream|std::fstream|fopen|parse_file)\b)");
    for (const std::string& file : test::project_files()) {
        const bool program = std::any_of(std::begin(kProgram), std::end(kProgram),
                                         [&](const char* folder) { return file.starts_with(folder); });
        if (!is_source(file) || !program) continue;
        EXPECT_FALSE(std::regex_search(test::content_of(kRoot / file), by_itself))
            << file << ": read_whole_file opens ordinary files only";
    }
    EXPECT_TRUE(std::regex_search(std::string("std::ifstream in(path);"), by_itself));
}

// A world may come from somebody else, so every command must parse it in a confined process.
TEST(Files, of_worlds_are_read_only_by_the_confined_process) {
    const std::regex in_this_process(R"(\b(read_world|read_world_bytes)\(|\bread_requested\b)");
    for (const std::string& file : test::project_files()) {
        if (!is_source(file) || !file.starts_with("app/") || file.starts_with("app/import/") ||
            file.starts_with("app/core/scenario/read_request."))
            continue;
        EXPECT_FALSE(std::regex_search(test::content_of(kRoot / file), in_this_process))
            << file << ": app/import or a WorldReader reads worlds";
    }
    EXPECT_TRUE(std::regex_search(std::string("auto scene = read_world(file);"), in_this_process));
}

// The macros of GoogleTest contain an if. Without braces, g++ therefore warns of an ambiguous else.
TEST(Sources, use_braces_around_a_check_under_an_if_without_else) {
    const std::regex bare(R"(\n *if \([^\n]*\)\s+(EXPECT|ASSERT)_[^;]*;[^\n]*\n(?! *else\b))");
    for (const std::string& file : test::project_files()) {
        if (!is_source(file) || !file.starts_with("tests/")) continue;
        const std::string text = test::content_of(kRoot / file);
        std::smatch found;
        EXPECT_FALSE(std::regex_search(text, found, bare)) << file << ":" << found.str();
    }
    EXPECT_TRUE(std::regex_search(std::string("{\n    if (a) EXPECT_TRUE(b);\n}\n"), bare));
    EXPECT_FALSE(std::regex_search(std::string("{\n    if (a) EXPECT_TRUE(b);\n    else EXPECT_TRUE(c);\n}\n"), bare));
}

// The precompiled header includes fmt, but some builds have no precompiled headers. So each file that uses fmt must
// include it.
TEST(Sources, include_fmt_if_they_use_it) {
    const auto lacks_it = [](const std::string& text) {
        return text.find("fmt::") != std::string::npos && text.find("#include <fmt/") == std::string::npos;
    };
    for (const std::string& file : test::project_files())
        if (is_source(file) && !file.starts_with("tests/")) {
            EXPECT_FALSE(lacks_it(test::content_of(kRoot / file))) << file;
        }
    EXPECT_TRUE(lacks_it("std::string a = fmt::format(\"{}\", 1);"));
    EXPECT_FALSE(lacks_it("#include <fmt/format.h>\nstd::string a = fmt::format(\"{}\", 1);"));
}

}  // namespace structure_test
}  // namespace handrail
