#include "app/main/world_files.h"

#include <cstdlib>

namespace handrail {

namespace fs = std::filesystem;

fs::path world_folder() {
    if (const char* set = std::getenv("HANDRAIL_WORLDS"); set && *set) return set;
    std::error_code ec;
    const fs::path program = fs::read_symlink("/proc/self/exe", ec);
    if (!ec) {
        const fs::path installed = program.parent_path().parent_path() / "share" / "handrail" / "worlds";
        if (fs::is_directory(installed, ec)) return installed;
    }
    return HANDRAIL_WORLD_FOLDER;
}

bool is_shipped(const fs::path& world) {
    std::error_code ec;
    return fs::equivalent(world.has_parent_path() ? world.parent_path() : fs::path("."), world_folder(), ec);
}

fs::path first_world() { return world_folder() / "first_room.map"; }

}  // namespace handrail
