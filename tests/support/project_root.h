// Where the project and its build lie: the only test source that knows, so that all others compile to the same objects
// in any folder.
#pragma once

#include <filesystem>
#include <string>

namespace handrail::test {

// Absolute, and of the build that these tests are of.
const std::filesystem::path& project_root();
const std::filesystem::path& build_root();

// "house.map": a world that ships with the program.
std::string bundled_world(const std::string& file);
// "handrail": a program of this build.
std::string built_program(const std::string& name);
// "standin_hd": the library that stands in for a maker's.
std::string built_standin(const std::string& name);

}  // namespace handrail::test
