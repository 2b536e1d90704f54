// Deletes a learner: lists what would be deleted, deletes it, and afterwards searches to show that nothing is left.
// Deleted data may still be readable on the disk itself; these functions do not erase it there. Any thread; large
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
    std::vector<std::filesystem::path> exported;  // files written elsewhere that are still unchanged
    // Files written elsewhere that still exist but were changed since.
    std::vector<std::filesystem::path> exported_other;
    std::vector<Error> faults;
};
Holdings holdings_of(const std::filesystem::path& learner_folder);

// Deletes the learner's folder and the exported files that are unchanged. If something cannot be deleted, deletes
// everything else and fails with the name of what is left.
Result<void> delete_learner(const std::filesystem::path& learner_folder, const Holdings& holdings);

struct Search {
    // Files and folders that contain one of the words in their name or content.
    std::vector<std::filesystem::path> hits;
    std::vector<std::filesystem::path> unread;  // files that could not be read
    std::size_t files = 0;                      // number of files searched
};
// Searches every file below the folders, including the contents of gzip files, without following links. A word counts
// only as a whole word, not as part of another. Missing folders count as empty.
Search search_for(std::span<const std::string> words, std::span<const std::filesystem::path> folders);

}  // namespace handrail::learners
