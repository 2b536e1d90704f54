// Tests that the page on portability lists each file that includes a system header, and no other file.
#include <algorithm>
#include <array>
#include <regex>
#include <set>

#include "tests/support/names.h"
#include "tests/support/project_files.h"
#include "tests/support/project_root.h"
#include "tests/unit/docs/table_rows.h"

namespace handrail {
namespace portability_test {

const std::filesystem::path kRoot = test::project_root();

constexpr std::array kProgram{"app/", "haptic/", "worlds/", "settings/", "audio-cues/"};

bool of_the_system(const std::string& header) {
    static const std::set<std::string> kNames{"unistd.h", "fcntl.h",  "signal.h",   "csignal", "termios.h",
                                              "poll.h",   "dirent.h", "pthread.h",  "pwd.h",   "sched.h",
                                              "dlfcn.h",  "spawn.h",  "execinfo.h", "pty.h",   "langinfo.h"};
    static const std::array<std::string, 4> kFolders{"sys/", "linux/", "netinet/", "arpa/"};
    return kNames.contains(header) || std::any_of(kFolders.begin(), kFolders.end(),
                                                  [&](const auto& folder) { return header.starts_with(folder); });
}

std::set<std::string> required_by(const std::string& text) {
    static const std::regex kInclude(R"re(#[ \t]*include[ \t]*<([^>]+)>)re");
    std::set<std::string> headers;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), kInclude); it != std::sregex_iterator(); ++it)
        if (of_the_system((*it)[1])) headers.insert((*it)[1]);
    return headers;
}

// Returns true if `file` is in a folder that must not call the system. A few folders in worlds and app/core may call
// it.
bool needs_no_system(const std::string& file) {
    for (const char* folder : {"settings/", "haptic/render/", "haptic/compile/", "haptic/dynamics/", "haptic/device/",
                               "haptic/loop/", "haptic/c/", "audio-cues/plan/"})
        if (file.starts_with(folder)) return true;
    return (file.starts_with("worlds/") && !file.starts_with("worlds/base/") && !file.starts_with("worlds/cache/") &&
            !file.starts_with("worlds/confine/")) ||
           (file.starts_with("app/core/") && !file.starts_with("app/core/kept/"));
}

TEST(Portability, documentation_lists_every_file_with_system_calls_and_the_core_has_none) {
    std::set<std::string> requiring;
    for (const std::string& file : test::project_files()) {
        const bool program =
            std::any_of(kProgram.begin(), kProgram.end(), [&](const char* folder) { return file.starts_with(folder); });
        if (!program || !(file.ends_with(".h") || file.ends_with(".cpp"))) continue;
        const std::set<std::string> headers = required_by(test::content_of(kRoot / file));
        if (headers.empty()) continue;
        EXPECT_FALSE(needs_no_system(file)) << file << " includes " << *headers.begin();
        requiring.insert(file);
    }
    EXPECT_GT(requiring.size(), 20U);
    static const std::regex kFile(R"re(`([a-z][\w./-]+\.(?:h|cpp))`)re");
    std::set<std::string> listed;
    for (const std::string& item : test::list_items("portability.md", "## What depends on the system"))
        for (auto it = std::sregex_iterator(item.begin(), item.end(), kFile); it != std::sregex_iterator(); ++it)
            listed.insert((*it)[1]);
    EXPECT_EQ(listed, requiring);
}

}  // namespace portability_test
}  // namespace handrail
