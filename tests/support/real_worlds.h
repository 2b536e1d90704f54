// Finds real buildings and maps that do not come with the program. They are in the folder that HANDRAIL_REAL_WORLDS
// names. Its default is shared/worlds next to the project.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/names.h"

namespace handrail::test {

// Returns the file's path, or nothing if the file is absent.
std::optional<std::filesystem::path> real_world(const std::string& file_name);

// Returns the text for GTEST_SKIP() if a test needs a real world that is absent.
std::string needs_real_world(const std::string& file_name);

// Returns the bundled worlds, then the real worlds that are present. For each absent world it prints a line that starts
// with "Skipped: ". `./run tests` repeats such lines after the summary.
std::vector<std::filesystem::path> with_real_worlds(std::vector<std::filesystem::path> ours,
                                                    const std::vector<std::string>& real);

}  // namespace handrail::test
