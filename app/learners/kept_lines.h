// The files of a learner that are a list of lines, each an entry of its own. Any thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"

namespace handrail {

// Gives `take` each line of the file and its number, from 1; none where there is no such file. A file that cannot be
// read, or is longer than that, is added to `faults`.
void each_kept_line(const std::filesystem::path& file, std::size_t longest_bytes, std::vector<Error>& faults,
                    const std::function<void(std::string_view line, int number)>& take);

}  // namespace handrail
