// What of a learner was written outside of the learner's own folder: exports.jsonl, one line of JSON for each file with
// its checksum, so that deleting a learner can take away what still is as it was written. Any thread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"

namespace handrail {

struct Exported {
    std::filesystem::path file;          // absolute
    std::vector<std::string> checksums;  // CRC-32, eight hex digits, of all that was ever written there
};

// Adds the file to exports.jsonl in that folder, before it is written: a crash between the two then leaves a line too
// many, and no file that nobody knows of. What is noted of a file before stays, as the write may fail.
Result<void> note_exported(const std::filesystem::path& learner_folder, const std::filesystem::path& file,
                           std::string_view content);
// All that were noted, and each once. Lines that cannot be understood are faults with file and line.
std::vector<Exported> exported_of(const std::filesystem::path& learner_folder, std::vector<Error>& faults);
// The file is there and as it was written.
bool unchanged(const Exported& exported);

}  // namespace handrail
