// Tests that the code of each folder is in the namespace of that folder, as docs/architecture/folders.md says.
#include <map>
#include <regex>
#include <sstream>

#include "tests/support/precompiled.h"
#include "tests/support/project_files.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace namespaces_test {

// Returns the namespace below handrail for a file of the program. For worlds/ifc/openings.h it is "ifc"; for folders
// that all others share it is "".
std::string namespace_for(const std::string& file) {
    static const std::map<std::string, std::string> kOther = {
        {"worlds/base", ""},         {"worlds/geometry", ""},     {"worlds/scene", ""},    {"haptic/c", ""},
        {"audio-cues/plan", "cues"}, {"app/import", "importing"}, {"app/main", "program"},
    };
    const std::string folder = file.substr(0, file.rfind('/'));
    if (folder.starts_with("app/core/")) return "core";
    if (const auto other = kOther.find(folder); other != kOther.end()) return other->second;
    return folder.substr(folder.rfind('/') + 1);
}

// Returns the lines that add something to a namespace of handrail other than the file's own. Forward declarations such
// as "class Servo;" are allowed. Relies on the line layout of clang-format.
std::vector<std::string> strangers_of(const std::string& file, const std::string& text) {
    static const std::regex opens("namespace (handrail[A-Za-z0-9_:]*) \\{"),
        declared("(struct|class|enum class|enum) .*;.*|//.*|");
    // This file defines the archive's functions for types of other folders. The functions must be in the archive's
    // namespace, because the archive looks them up there.
    const bool for_archive = file == "app/import/reader_answer.h";
    const std::string own = "handrail" + (namespace_for(file).empty() ? "" : "::" + namespace_for(file));
    std::vector<std::string> found;
    std::string within;
    std::istringstream lines(text);
    std::smatch part;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_match(line, part, opens)) within = part[1];
        else if (line.starts_with("}")) within.clear();
        else if (!within.empty() && within != own && !within.starts_with(own + "::") &&
                 !(for_archive && within == "handrail::stored") && !std::regex_match(line, declared))
            found.push_back(within + ": " + line);
    }
    return found;
}

TEST(Namespaces, of_files_follow_from_their_folders) {
    EXPECT_EQ(namespace_for("worlds/ifc/openings.h"), "ifc");
    EXPECT_EQ(namespace_for("settings/table.h"), "settings");
    EXPECT_EQ(namespace_for("app/core/world/rooms.h"), "core");
    EXPECT_EQ(namespace_for("app/main/main.cpp"), "program");
    EXPECT_EQ(namespace_for("worlds/scene/scene.h"), "");
}

TEST(Namespaces, that_are_not_those_of_the_folder_are_seen) {
    const std::string text =
        "namespace handrail::servo {\nclass Loop;\n}\n\nnamespace handrail::ifc {\n\nint doors();\n\n"
        "}  // namespace handrail::ifc\n";
    EXPECT_TRUE(strangers_of("worlds/ifc/doors.h", text).empty());
    EXPECT_EQ(strangers_of("haptic/servo/doors.h", text), std::vector<std::string>{"handrail::ifc: int doors();"});
    EXPECT_EQ(strangers_of("worlds/osm/doors.h", "namespace handrail {\nint doors();\n}\n").size(), 1U);
}

TEST(Namespaces, are_those_of_the_folders) {
    std::size_t looked_at = 0;
    for (const std::string& file : test::project_files()) {
        if (!file.ends_with(".h") && !file.ends_with(".cpp")) continue;
        if (file.starts_with("tests/")) continue;
        const std::string text = test::content_of(test::project_root() / file);
        looked_at += text.find("\nnamespace handrail") != std::string::npos ? 1 : 0;
        for (const std::string& stranger : strangers_of(file, text))
            ADD_FAILURE() << file << " is not to add to " << stranger;
    }
    EXPECT_GT(looked_at, 500U);
}

}  // namespace namespaces_test
}  // namespace handrail
