// A new folder that nobody but the person can look into, and that goes again with all in it unless what it is for has
// begun: a full disk must not leave an empty one for each try. One thread; costs nothing once kept.
#pragma once

#include <sys/stat.h>

#include <cerrno>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

namespace handrail {

class FolderUnlessKept {
public:
    explicit FolderUnlessKept(std::filesystem::path folder) : folder_(std::move(folder)) {}
    FolderUnlessKept(const FolderUnlessKept&) = delete;
    FolderUnlessKept& operator=(const FolderUnlessKept&) = delete;
    ~FolderUnlessKept() {
        if (!made_) return;
        try {
            std::error_code ec;
            std::filesystem::remove_all(folder_, ec);
        } catch (const std::exception&) {  // no memory for it: the folder stays, which harms nobody
        }
    }
    // The errno of what went wrong; 0: nothing. Allocates nothing, so no failure comes between the folder and its
    // guard.
    int make() {
        made_ = ::mkdir(folder_.c_str(), 0700) == 0;
        return made_ ? 0 : errno;
    }
    void keep() { made_ = false; }

private:
    std::filesystem::path folder_;
    bool made_ = false;
};

}  // namespace handrail
