// Makes a new folder that only the person can read. The destructor removes the folder with its content unless keep()
// was called, so a full disk does not leave an empty folder for each attempt. Used on one thread. After keep(),
// destruction costs nothing.
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
        } catch (const std::exception&) {  // if memory runs out during the removal, the folder stays, which is harmless
        }
    }
    // Makes the folder. Returns 0 on success, else the errno of the failure. Allocates nothing, so nothing can fail
    // between making the folder and guarding it.
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
