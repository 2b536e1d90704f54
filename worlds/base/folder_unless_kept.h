// A new folder that only the person can read. It is removed again with its content unless keep() is called, so that a
// full disk does not leave an empty folder for each attempt. One thread; costs nothing once kept.
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
        } catch (const std::exception&) {  // out of memory while removing: the folder stays, which does no harm
        }
    }
    // Returns the errno of the failure, or 0 on success. Allocates nothing, so nothing can fail between making the
    // folder and guarding it.
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
