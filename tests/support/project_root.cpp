#include "tests/support/project_root.h"

namespace handrail::test {

const std::filesystem::path& project_root() {
    static const std::filesystem::path root = HANDRAIL_SOURCE_DIR;
    return root;
}

const std::filesystem::path& build_root() {
    static const std::filesystem::path root = HANDRAIL_BUILD_DIR;
    return root;
}

std::string bundled_world(const std::string& file) { return (project_root() / "worlds/maps" / file).string(); }

std::string built_program(const std::string& name) { return (build_root() / "bin" / name).string(); }

std::string built_standin(const std::string& name) {
    return (build_root() / "standins" / ("lib" + name + ".so")).string();
}

}  // namespace handrail::test
