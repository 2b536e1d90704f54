#include "tests/support/real_worlds.h"

#include <cstdlib>
#include <iostream>

#include "tests/support/names.h"
#include "tests/support/project_root.h"

namespace handrail::test {

std::optional<std::filesystem::path> real_world(const std::string& file_name) {
    namespace fs = std::filesystem;
    const char* set = std::getenv("HANDRAIL_REAL_WORLDS");
    const fs::path folder = set ? fs::path(set) : test::project_root().parent_path() / "shared" / "worlds";
    const fs::path path = folder / file_name;
    if (!fs::exists(path)) return std::nullopt;
    return path;
}

std::string needs_real_world(const std::string& file_name) {
    return "needs " + file_name + "; HANDRAIL_REAL_WORLDS names the folder that has it";
}

std::vector<std::filesystem::path> with_real_worlds(std::vector<std::filesystem::path> ours,
                                                    const std::vector<std::string>& real) {
    for (const std::string& name : real) {
        if (const auto path = real_world(name)) ours.push_back(*path);
        else std::cout << "Skipped: " << needs_real_world(name) << "\n";
    }
    return ours;
}

}  // namespace handrail::test
