// The folders of the project and its build. This is the only test source that contains them, so all others compile to
// the same objects in any folder.
#pragma once

#include <filesystem>
#include <string>

#include "tests/support/names.h"

namespace handrail::test {

// Absolute paths; the build is the one to which these tests belong.
const std::filesystem::path& project_root();
const std::filesystem::path& build_root();

// The path of a world that comes with the program, such as "house.map".
std::string bundled_world(const std::string& file);
// The path of a program of this build, such as "handrail".
std::string built_program(const std::string& name);
// The path of a library that replaces a device maker's, such as "standin_hd".
std::string built_standin(const std::string& name);

}  // namespace handrail::test
