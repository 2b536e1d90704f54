// Names the folders of the project and of its build. No other test source contains these folders, so all others compile
// to the same objects in any folder.
#pragma once

#include <filesystem>
#include <string>

#include "tests/support/names.h"

namespace handrail::test {

// Return absolute paths. The build is the build to which these tests belong.
const std::filesystem::path& project_root();
const std::filesystem::path& build_root();

// Returns the path of a world that comes with the program, such as "house.map".
std::string bundled_world(const std::string& file);
// Returns the path of a program of this build, such as "handrail".
std::string built_program(const std::string& name);
// Returns the path of a library that replaces a device maker's library, such as "standin_hd".
std::string built_standin(const std::string& name);

}  // namespace handrail::test
