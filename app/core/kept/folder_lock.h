// Keeps other sessions of ours out of a folder for as long as it lives. The folder itself is locked, so nothing is left
// behind by whoever dies. Where the folder is not there or its file system knows no locks, nobody is kept out.
#pragma once

#include <filesystem>

#include "worlds/base/descriptor.h"

namespace handrail {

class FolderLock {
public:
    // Waits so long at most for another who holds it.
    FolderLock(const std::filesystem::path& folder, double most_s);
    bool held() const { return held_; }
    bool held_elsewhere() const { return held_elsewhere_; }

private:
    Descriptor folder_;
    bool held_ = false, held_elsewhere_ = false;
};

}  // namespace handrail
