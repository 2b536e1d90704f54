#include "app/core/kept/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <chrono>
#include <thread>

namespace handrail::core {

FolderLock::FolderLock(const std::filesystem::path& folder, double most_s)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    constexpr auto kLook = std::chrono::milliseconds(2);
    if (folder_.get() < 0) return;
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(most_s);
    while (::flock(folder_.get(), LOCK_EX | LOCK_NB) != 0) {
        if (errno != EWOULDBLOCK && errno != EINTR) return;
        if (std::chrono::steady_clock::now() >= until) {
            held_elsewhere_ = true;
            return;
        }
        std::this_thread::sleep_for(kLook);
    }
    held_ = true;
}

}  // namespace handrail::core
