// Keeps a list of the files about a learner that were written outside the learner's own folder. The list is the file
// exports.jsonl, which has one line of JSON for each exported file, with a checksum. So deleting a learner can also
// delete the exported files that are unchanged. Any thread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::learners {

struct Exported {
    std::filesystem::path file;          // absolute path of the exported file
    std::vector<std::string> checksums;  // CRC-32, eight hex digits, of each content that Handrail ever wrote to `file`
};

// Adds `file` to exports.jsonl in `learner_folder`. Call it before writing `file`. If the program crashes between these
// two steps, the list has one line too many, but no exported file is missing from it. Earlier entries for the file are
// kept, because writing the file may fail.
Result<void> note_exported(const std::filesystem::path& learner_folder, const std::filesystem::path& file,
                           std::string_view content);
// Returns all exported files, each once. Adds a fault with file and line for each line that cannot be read.
std::vector<Exported> exported_of(const std::filesystem::path& learner_folder, std::vector<Error>& faults);
// Returns true if the exported file exists and Handrail itself once wrote its present contents.
bool unchanged(const Exported& exported);

}  // namespace handrail::learners
