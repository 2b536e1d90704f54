// Deletes a learner: lists what would be deleted, deletes it, and afterwards searches to show that nothing is left.
// Sectors of the disk may still contain deleted data, because these functions do not overwrite them. Any thread; large
// folders may take long.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::learners {

struct Holdings {
    // Numbers of recorded sessions, and of worlds with marks or learnt knowledge.
    std::size_t recordings = 0, worlds = 0;
    // Files outside the learner's folder that are still as Handrail wrote them.
    std::vector<std::filesystem::path> exported;
    // Files outside the learner's folder that still exist, but that somebody has changed since Handrail wrote them.
    std::vector<std::filesystem::path> exported_other;
    std::vector<Error> faults;
};
Holdings holdings_of(const std::filesystem::path& learner_folder);

// Deletes the learner's folder and the exported files that are unchanged. If a file or folder cannot be deleted,
// deletes everything else and fails with the names of what is left.
Result<void> delete_learner(const std::filesystem::path& learner_folder, const Holdings& holdings);

struct Search {
    // Files and folders that contain one of the searched words in their name or content.
    std::vector<std::filesystem::path> hits;
    std::vector<std::filesystem::path> unread;  // files that could not be read
    std::size_t files = 0;                      // number of files searched
};
// Searches every file below the folders, including the contents of gzip files, without following links. Finds a word
// only as a whole word, not as part of another. Treats missing folders as empty.
Search search_for(std::span<const std::string> words, std::span<const std::filesystem::path> folders);

}  // namespace handrail::learners
