// Keeps a list of the files that were written about a learner outside the learner's own folder. The list is
// exports.jsonl: one line of JSON for each file, with its checksum. So deleting a learner can also delete the exported
// files that are unchanged. Any thread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::learners {

struct Exported {
    std::filesystem::path file;          // absolute path
    std::vector<std::string> checksums;  // CRC-32, eight hex digits, of each content that was ever written to the file
};

// Adds the file to exports.jsonl in that folder. Call it before writing the file. After a crash between the two steps,
// the list then has one line too many, but no exported file is missing from it. Earlier entries for the file are kept,
// because writing it may fail.
Result<void> note_exported(const std::filesystem::path& learner_folder, const std::filesystem::path& file,
                           std::string_view content);
// Returns all exported files, each once. Lines that cannot be read become faults with file and line.
std::vector<Exported> exported_of(const std::filesystem::path& learner_folder, std::vector<Error>& faults);
// Returns true if the file exists and its contents are ones that were written there.
bool unchanged(const Exported& exported);

}  // namespace handrail::learners
