// Locks a folder against other sessions of the program while this object exists. The folder itself is locked, so a
// crashed session leaves no lock file. If the folder is missing or its file system has no locks, the lock keeps no
// session out.
#pragma once

#include <filesystem>

#include "worlds/base/descriptor.h"

namespace handrail::core {

class FolderLock {
public:
    // Waits up to `most_s` seconds for another session to release the folder.
    FolderLock(const std::filesystem::path& folder, double most_s);
    bool held() const { return held_; }
    bool held_elsewhere() const { return held_elsewhere_; }

private:
    Descriptor folder_;
    bool held_ = false, held_elsewhere_ = false;
};

}  // namespace handrail::core
