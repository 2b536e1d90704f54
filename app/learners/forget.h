// Deletes a learner: lists what would be deleted, deletes it, and afterwards searches to show that nothing is left.
// What a disk keeps of deleted blocks is not covered. Any thread; large folders may take long.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::learners {

struct Holdings {
    std::size_t recordings = 0, worlds = 0;             // folders of sessions; worlds with marks or learnt knowledge
    std::vector<std::filesystem::path> exported;        // written elsewhere and still unchanged
    std::vector<std::filesystem::path> exported_other;  // written elsewhere, changed since, and still there
    std::vector<Error> faults;
};
Holdings holdings_of(const std::filesystem::path& learner_folder);

// Deletes the learner's folder and the exported files that are unchanged. If something could not be deleted, fails with
// its name; everything else is gone then.
Result<void> delete_learner(const std::filesystem::path& learner_folder, const Holdings& holdings);

struct Search {
    std::vector<std::filesystem::path> hits;    // files and folders with one of the words in their name or content
    std::vector<std::filesystem::path> unread;  // could not be read
    std::size_t files = 0;                      // number of files searched
};
// Searches every file below the folders, also gzip files, without following links. A word counts only as a whole word,
// not as part of another. Missing folders count as empty.
Search search_for(std::span<const std::string> words, std::span<const std::filesystem::path> folders);

}  // namespace handrail::learners
