// Real buildings and maps that do not ship with the program: in the folder HANDRAIL_REAL_WORLDS, by default
// shared/worlds beside the project.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace handrail::test {

// The file's path, or nothing where it is absent: the test then skips and says so with GTEST_SKIP().
std::optional<std::filesystem::path> real_world(const std::string& file_name);

}  // namespace handrail::test
