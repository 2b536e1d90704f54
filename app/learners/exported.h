// Notes what was written about a learner outside the learner's own folder. exports.jsonl has one line of JSON for each
// file with its checksum. So deleting a learner can also delete the exported files that are unchanged. Any thread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::learners {

struct Exported {
    std::filesystem::path file;          // absolute path
    std::vector<std::string> checksums;  // CRC-32, eight hex digits, of everything that was ever written there
};

// Adds the file to exports.jsonl in that folder. Call it before the file is written: after a crash in between there is
// a line too many, but never an unknown file. Earlier entries for the file stay, because the write may fail.
Result<void> note_exported(const std::filesystem::path& learner_folder, const std::filesystem::path& file,
                           std::string_view content);
// All exported files, each once. Lines that cannot be read are reported as faults with file and line.
std::vector<Exported> exported_of(const std::filesystem::path& learner_folder, std::vector<Error>& faults);
// Returns true if the file exists and has the contents that were written.
bool unchanged(const Exported& exported);

}  // namespace handrail::learners
