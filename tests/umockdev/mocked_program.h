// Makes a copy of the program whose guard can reach the devices that umockdev emulates.
#pragma once

#include <filesystem>

#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {

// Returns the path of the copied program, which is in a folder laid out like a build. The copy is deleted when this
// process ends.
inline const std::filesystem::path& mocked_program() {
    namespace fs = std::filesystem;
    static const TemporaryFolder folder;
    static const fs::path program = [] {
        const fs::path bin = folder.path() / "bin";
        fs::create_directories(bin);
        fs::create_directories(folder.path() / "share" / "handrail");
        fs::create_symlink(project_root() / "worlds" / "maps", folder.path() / "share" / "handrail" / "worlds");
        fs::copy_file(built_program("handrail"), bin / "handrail");
        fs::create_symlink(built_program("handrail-reader"), bin / "handrail-reader");
        fs::create_symlink(built_program("standin_umockdev_guard"), bin / "handrail-guard");
        return bin / "handrail";
    }();
    return program;
}

}  // namespace handrail::test
