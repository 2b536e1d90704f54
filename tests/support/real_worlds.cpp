#include "tests/support/real_worlds.h"

#include <cstdlib>

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

}  // namespace handrail::test
