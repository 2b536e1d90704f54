#include "worlds/base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "worlds/base/descriptor.h"
#include "worlds/base/language.h"

namespace handrail {
namespace fs = std::filesystem;

std::string reason_of(int error) {
    switch (error) {
        case ENOENT:
            return phrase("files.not_there");
        case EACCES:
        case EPERM:
            return phrase("files.not_allowed");
        case ENOSPC:
        case EDQUOT:
            return phrase("files.full");
        case EROFS:
            return phrase("files.read_only");
        case ENOTDIR:
            return phrase("files.not_a_folder");
        case ELOOP:
            return phrase("files.link_loop");
        default:
            return std::generic_category().message(error);
    }
}

Result<std::string> read_whole_file(const fs::path& path, std::size_t max_bytes) {
    const std::string name = path.filename().string();
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.get() < 0) return fail(phrase("files.cannot_open", {{"reason", reason_of(errno)}}), name);
    struct stat info {};
    if (::fstat(file.get(), &info) != 0) return fail(phrase("files.cannot_read", {{"reason", reason_of(errno)}}), name);
    if (S_ISDIR(info.st_mode)) return fail(phrase("files.folder"), name);
    std::string content;
    char block[1 << 16];
    for (;;) {
        const ssize_t got = ::read(file.get(), block, sizeof block);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return fail(phrase("files.cannot_read", {{"reason", reason_of(errno)}}), name);
        if (got == 0) return content;
        if (content.size() + static_cast<std::size_t>(got) > max_bytes) return fail(phrase("files.too_large", {{"megabytes", max_bytes >> 20}}), name);
        content.append(block, static_cast<std::size_t>(got));
    }
}

Result<void> write_file_atomically(const fs::path& path, std::string_view content) {
    std::error_code ec;
    // Link by link, since the last one may point to a file that is still to be made.
    fs::path target = path;
    for (int links = 0; fs::is_symlink(target, ec); ++links) {
        if (links == 40) return fail(phrase("files.cannot_save", {{"reason", reason_of(ELOOP)}}), path.filename().string());  // the system's own limit
        target = target.parent_path() / fs::read_symlink(target, ec);
    }
    const std::string name = target.filename().string();
    const auto refused = [&](int error) { return fail(phrase("files.save_refused", {{"reason", reason_of(error)}}), name); };
    if (target.has_parent_path()) {
        fs::create_directories(target.parent_path(), ec);
        if (ec) return refused(ec.value());
    }
    struct stat old {};
    const mode_t mode = ::stat(target.c_str(), &old) == 0 ? (old.st_mode & 07777) : 0644;
    std::string beside = target.string() + ".new-XXXXXX";
    int error = 0;
    {
        const Descriptor file(::mkostemp(beside.data(), O_CLOEXEC));
        if (file.get() < 0) return refused(errno);
        std::size_t done = 0;
        while (done < content.size() && error == 0) {
            const ssize_t put = ::write(file.get(), content.data() + done, content.size() - done);
            if (put >= 0) done += static_cast<std::size_t>(put);
            else if (errno != EINTR) error = errno;
        }
        if (error == 0 && (::fchmod(file.get(), mode) != 0 || ::fsync(file.get()) != 0)) error = errno;
    }
    if (error == 0 && ::rename(beside.c_str(), target.c_str()) != 0) error = errno;
    if (error != 0) {
        ::unlink(beside.c_str());
        return refused(error);
    }
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const Descriptor parent(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (parent.get() >= 0) ::fsync(parent.get());  // the rename itself survives a power cut; failure here changes nothing
    return {};
}

}  // namespace handrail
