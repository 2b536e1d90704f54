#include "worlds/cache/cache.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <memory>
#include <vector>

#include "worlds/base/files.h"
#include "worlds/cache/sha256.h"

namespace handrail::cache {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDigest_bytes = 64;  // a SHA-256 digest in hex digits
constexpr mode_t kOthersWrite = S_IWGRP | S_IWOTH;

std::string digest_of(const std::string& name, std::string_view content) {
    Sha256 sum;
    sum.add_counted(name);
    sum.add(content);
    return sum.hex();
}

// Opens the folder if it belongs to the person and nobody else may write in it. If others may read it, that permission
// is removed first.
Descriptor own_folder(const fs::path& path) {
    Descriptor folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    struct stat of {};
    if (folder.get() < 0 || ::fstat(folder.get(), &of) != 0 || of.st_uid != ::geteuid() || (of.st_mode & kOthersWrite))
        return Descriptor(-1);
    if ((of.st_mode & 07777) != 0700 && ::fchmod(folder.get(), 0700) != 0) return Descriptor(-1);
    return folder;
}

// Makes missing folders that only the person can use, as the base directory specification requires.
void make_folder(const fs::path& path) {
    if (path.empty() || path == path.root_path()) return;
    if (::mkdir(path.c_str(), 0700) == 0 || errno != ENOENT) return;
    make_folder(path.parent_path());
    ::mkdir(path.c_str(), 0700);
}

struct KeptFile {
    std::string name;
    std::uint64_t bytes = 0;
    timespec used{};
};

std::vector<KeptFile> files_in(int folder) {
    std::vector<KeptFile> files;
    const int again = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const std::unique_ptr<DIR, int (*)(DIR*)> list(again < 0 ? nullptr : ::fdopendir(again), ::closedir);
    if (!list) {
        if (again >= 0) ::close(again);
        return files;
    }
    while (const dirent* entry = ::readdir(list.get())) {
        struct stat of {};
        if (::fstatat(folder, entry->d_name, &of, AT_SYMLINK_NOFOLLOW) != 0 || S_ISDIR(of.st_mode)) continue;
        files.push_back({entry->d_name, static_cast<std::uint64_t>(of.st_size), of.st_mtim});
    }
    return files;
}

// Removes the least recently used files until the remaining ones are no larger than most_bytes together. The size of a
// file is subtracted even if another process has removed the file in the meantime.
void remove_oldest(int folder, std::uint64_t most_bytes) {
    std::vector<KeptFile> files = files_in(folder);
    std::sort(files.begin(), files.end(), [](const KeptFile& a, const KeptFile& b) {
        return a.used.tv_sec != b.used.tv_sec ? a.used.tv_sec < b.used.tv_sec : a.used.tv_nsec < b.used.tv_nsec;
    });
    std::uint64_t all = 0;
    for (const KeptFile& file : files) all += file.bytes;
    for (const KeptFile& file : files) {
        if (all <= most_bytes) return;
        ::unlinkat(folder, file.name.c_str(), 0);
        all -= file.bytes;
    }
}

}  // namespace

Descriptor Cache::open(const std::string& name) const {
    if (folder_.empty()) return Descriptor(-1);
    const Descriptor folder = own_folder(folder_);
    if (folder.get() < 0) return Descriptor(-1);
    Descriptor file(::openat(folder.get(), name.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    struct stat of {};
    if (file.get() < 0 || ::fstat(file.get(), &of) != 0 || !S_ISREG(of.st_mode) || of.st_uid != ::geteuid() ||
        (of.st_mode & kOthersWrite))
        return Descriptor(-1);
    // Marks the file as used now. This fails on a read-only disk, which does no harm, because no files can be removed
    // there.
    ::futimens(file.get(), nullptr);
    return file;
}

void Cache::keep(const std::string& name, std::string_view content) const {
    if (folder_.empty() || content.size() + kDigest_bytes > most_bytes_) return;
    make_folder(folder_);
    if (own_folder(folder_).get() < 0) return;
    std::string all = digest_of(name, content);
    all += content;
    if (!write_private_file_atomically(folder_ / name, all)) return;
    // Opens the folder a second time, because another process may have removed the folder in the meantime, and the
    // write may have made it again.
    if (const Descriptor folder = own_folder(folder_); folder.get() >= 0) remove_oldest(folder.get(), most_bytes_);
}

std::optional<std::string> kept_content(int file, const std::string& name, const std::stop_token& stop) {
    std::string all;
    std::string piece(std::size_t{1} << 20, '\0');
    for (;;) {
        if (stop.stop_requested()) return std::nullopt;
        const ssize_t got = ::pread(file, piece.data(), piece.size(), static_cast<off_t>(all.size()));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return std::nullopt;
        if (got == 0) break;
        all.append(piece, 0, static_cast<std::size_t>(got));
    }
    if (all.size() < kDigest_bytes) return std::nullopt;
    const std::string digest = all.substr(0, kDigest_bytes);
    all.erase(0, kDigest_bytes);
    if (digest_of(name, all) != digest) return std::nullopt;
    return all;
}

fs::path user_cache_folder() {
    // The base directory specification allows only an absolute path in XDG_CACHE_HOME.
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache && cache[0] == '/') return fs::path(cache) / "handrail";
    const char* home = std::getenv("HOME");
    if (home && home[0] == '/') return fs::path(home) / ".cache" / "handrail";
    return {};
}

}  // namespace handrail::cache
