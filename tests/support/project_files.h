// Lists the project's own files, for tests of its structure.
#pragma once

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/names.h"
#include "tests/support/project_root.h"

namespace handrail::test {

// Lists the files in the git repository. In an unpacked archive, which has no repository, it lists all files except
// build output. Paths are relative to the project's root.
inline std::vector<std::string> project_files() {
    const std::filesystem::path root = test::project_root();
    std::vector<std::string> files;
    const std::string command = "git -c safe.directory='*' -C '" + root.string() +
                                "' ls-files --cached --others --exclude-standard 2>/dev/null";
    if (FILE* pipe = ::popen(command.c_str(), "r")) {
        std::array<char, 4096> line{};
        while (std::fgets(line.data(), line.size(), pipe))
            files.push_back(std::string(line.data(), std::string_view(line.data()).find('\n')));
        ::pclose(pipe);
    }
    if (!files.empty()) return files;
    for (auto it = std::filesystem::recursive_directory_iterator(root);
         it != std::filesystem::recursive_directory_iterator(); ++it) {
        const std::string name = it->path().lexically_relative(root).string();
        if (name == "build" || name == ".git" || name == ".cache") it.disable_recursion_pending();
        else if (it->is_regular_file()) files.push_back(name);
    }
    return files;
}

}  // namespace handrail::test
