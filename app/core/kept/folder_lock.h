// Locks a folder against our other sessions while this object lives. The folder itself is locked, so a session that
// dies leaves nothing behind. If the folder is missing or its file system has no locks, nobody is kept out.
#pragma once

#include <filesystem>

#include "worlds/base/descriptor.h"

namespace handrail::core {

class FolderLock {
public:
    // Waits at most this long, in seconds, for another session to release the folder.
    FolderLock(const std::filesystem::path& folder, double most_s);
    bool held() const { return held_; }
    bool held_elsewhere() const { return held_elsewhere_; }

private:
    Descriptor folder_;
    bool held_ = false, held_elsewhere_ = false;
};

}  // namespace handrail::core
