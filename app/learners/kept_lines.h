// Reads files of a learner that contain one entry on each line. Any thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::learners {

// Calls `take` for each line of the file, with the line's number counted from 1. Does nothing if the file does not
// exist. If the file cannot be read, or is longer than `longest_bytes`, adds a fault.
void each_kept_line(const std::filesystem::path& file, std::size_t longest_bytes, std::vector<Error>& faults,
                    const std::function<void(std::string_view line, int number)>& take);

}  // namespace handrail::learners
