#include "app/main/world_files.h"

#include <cstdlib>

#include "app/core/kept/kept_unit.h"
#include "app/main/commands.h"

namespace handrail {

namespace fs = std::filesystem;

fs::path world_folder() {
    if (const char* set = std::getenv("HANDRAIL_WORLDS"); set && *set) return set;
    std::error_code ec;
    const fs::path program = fs::read_symlink("/proc/self/exe", ec);
    if (!ec) {
        fs::path installed = program.parent_path().parent_path() / "share" / "handrail" / "worlds";
        if (fs::is_directory(installed, ec)) return installed;
    }
    return HANDRAIL_WORLD_FOLDER;
}

bool is_shipped(const fs::path& world) {
    std::error_code ec;
    return fs::equivalent(world.has_parent_path() ? world.parent_path() : fs::path("."), world_folder(), ec);
}

fs::path first_world() { return world_folder() / "first_room.map"; }

ReadOptions CommonArguments::read_options(const fs::path& world) const {
    CommonArguments said = *this;
    if (!unit_m && !map_scale_m_per_unit) said.unit_m = kept_unit(world, user_data_folder(), is_shipped(world));
    return said.read_options();
}

}  // namespace handrail
