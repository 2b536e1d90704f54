// Deleting a learner: what would go, going, and the search afterwards that shows that nothing is left. What a disk
// keeps of deleted blocks is not promised. Any thread; may take long on large folders.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "worlds/base/result.h"

namespace handrail {

struct Holdings {
    std::size_t recordings = 0, worlds = 0;             // folders of sessions; worlds with marks or memories
    std::vector<std::filesystem::path> exported;        // written elsewhere, and still as they were
    std::vector<std::filesystem::path> exported_other;  // changed since, and still there
    std::vector<Error> faults;
};
Holdings holdings_of(const std::filesystem::path& learner_folder);

// The learner's folder, and what of the exported files is still as it was. Fails with what could not be deleted; what
// could be is gone then.
Result<void> delete_learner(const std::filesystem::path& learner_folder, const Holdings& holdings);

struct Search {
    std::vector<std::filesystem::path> hits;    // files and folders whose name or content has one of the words
    std::vector<std::filesystem::path> unread;  // that could not be looked into
    std::size_t files = 0;                      // looked into
};
// Looks into every file below the folders, into those packed by gzip as well, links not followed. A word counts where
// it stands by itself, not inside another. Folders that are not there are empty.
Search search_for(std::span<const std::string> words, std::span<const std::filesystem::path> folders);

}  // namespace handrail
