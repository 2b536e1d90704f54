#include "worlds/base/files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <new>
#include <system_error>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kNextTo = ".new-";
constexpr std::size_t kRandomLetters = 6;  // the number of random letters in a mkostemp template
// Seconds after which an unlocked temporary file is regarded as abandoned. A process needs less time to lock a new one.
constexpr time_t kStaleAfterS = 60;

// Repeats a system call that a signal interrupted. That is safe, because an interrupted call has had no effect.
template <class Call>
auto again(Call&& call) {
    for (;;) {
        const auto result = call();
        if (result >= 0 || errno != EINTR) return result;
    }
}

// Without O_NONBLOCK, opening a pipe that has no writer would block for ever.
constexpr int kOpenFlags = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;

// Checks what openat opened. `file` is the result of openat, and errno must still have the value that openat set.
Result<OpenFile> as_open_file(Descriptor file, const std::string& name) {
    // ENXIO means that the file is a socket.
    if (file.get() < 0 && errno == ENXIO) return fail(phrase("files.no_file"), name);
    if (file.get() < 0) return fail(phrase("files.cannot_open", {{"reason", reason_of(errno)}}), name);
    struct stat info {};
    if (::fstat(file.get(), &info) != 0) return fail(phrase("files.cannot_read", {{"reason", reason_of(errno)}}), name);
    if (S_ISDIR(info.st_mode)) return fail(phrase("files.folder"), name);
    if (!S_ISREG(info.st_mode)) return fail(phrase("files.no_file"), name);
    return OpenFile{std::move(file), static_cast<std::size_t>(info.st_size), name};
}

bool is_link(int folder, const fs::path& part) {
    struct stat info {};
    return ::fstatat(folder, part.c_str(), &info, AT_SYMLINK_NOFOLLOW) == 0 && S_ISLNK(info.st_mode);
}

// Removes abandoned temporary files next to `target`. A process that replaces a file holds a lock on its temporary file
// and loses the lock when it dies. So an old temporary file without a lock is abandoned.
void sweep_up_beside(const fs::path& target) {
    const std::string begin = target.filename().string() + std::string(kNextTo);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    std::error_code ec;
    for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec)) {
        const std::string name = it->path().filename().string();
        if (name.size() != begin.size() + kRandomLetters || !name.starts_with(begin)) continue;
        const Descriptor file(
            again([&] { return ::open(it->path().c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW); }));
        struct stat info {};
        if (file.get() < 0 || ::fstat(file.get(), &info) != 0) continue;
        if (!S_ISREG(info.st_mode) || info.st_uid != ::geteuid() || ::time(nullptr) - info.st_mtime < kStaleAfterS)
            continue;
        if (again([&] { return ::flock(file.get(), LOCK_EX | LOCK_NB); }) == 0) ::unlink(it->path().c_str());
    }
}

}  // namespace

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

Result<OpenFile> open_file(const fs::path& path) {
    return as_open_file(Descriptor(again([&] { return ::open(path.c_str(), kOpenFlags); })), path.filename().string());
}

// Opens the path part by part, starting from an open folder, so that nobody can insert a link in the meantime.
Result<OpenFile> open_file_within(const fs::path& folder, const fs::path& name) {
    Descriptor at(again([&] { return ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC); }));
    for (auto part = name.begin(); at.get() >= 0 && part != name.end(); ++part) {
        contract_pre(*part != ".." && !part->is_absolute());
        const bool last = std::next(part) == name.end();
        const int flags = O_NOFOLLOW | (last ? kOpenFlags : O_PATH | O_DIRECTORY | O_CLOEXEC);
        Descriptor next(again([&] { return ::openat(at.get(), part->c_str(), flags); }));
        if (next.get() < 0 && is_link(at.get(), *part)) return fail(phrase("reader.link"), name.string());
        if (last) return as_open_file(std::move(next), name.string());
        at = std::move(next);
    }
    return as_open_file(std::move(at), name.string());
}

Result<std::string> read_whole_file(const OpenFile& from, std::size_t max_bytes, const std::stop_token& stop) {
    std::string content;
    char block[1 << 16];
    for (;;) {
        if (stop.stop_requested()) return fail(phrase("files.stopped"), from.name);
        const ssize_t got = again([&] { return ::read(from.file.get(), block, sizeof block); });
        if (got < 0) return fail(phrase("files.cannot_read", {{"reason", reason_of(errno)}}), from.name);
        if (got == 0) return content;
        if (content.size() + static_cast<std::size_t>(got) > max_bytes)
            return fail(phrase("files.too_large", {{"megabytes", max_bytes >> 20}}), from.name);
        content.append(block, static_cast<std::size_t>(got));
    }
}

Result<std::string> read_whole_file(const fs::path& path, std::size_t max_bytes, const std::stop_token& stop) {
    const Result<OpenFile> from = open_file(path);
    return from ? read_whole_file(*from, max_bytes, stop) : tl::unexpected(from.error());
}

MappedFile::~MappedFile() {
    if (!bytes_.empty()) ::munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

Result<MappedFile> map_file(const OpenFile& from, std::size_t max_bytes) {
    if (from.size > max_bytes) return fail(phrase("files.too_large", {{"megabytes", max_bytes >> 20}}), from.name);
    if (from.size == 0) return MappedFile({});
    void* const at = ::mmap(nullptr, from.size, PROT_READ, MAP_PRIVATE, from.file.get(), 0);
    if (at == MAP_FAILED && errno == ENOMEM) throw std::bad_alloc();
    if (at == MAP_FAILED) return fail(phrase("files.cannot_read", {{"reason", reason_of(errno)}}), from.name);
    return MappedFile({static_cast<const char*>(at), from.size});
}

namespace {

// Replaces `target`. If `target` does not exist yet, its permission bits are `fresh_mode`.
Result<void> replace(const fs::path& target, std::string_view content, mode_t fresh_mode) {
    std::error_code ec;
    const std::string name = target.filename().string();
    const auto refused = [&](int error) {
        return fail(phrase("files.save_refused", {{"reason", reason_of(error)}}), name);
    };
    if (target.has_parent_path()) {
        fs::create_directories(target.parent_path(), ec);
        if (ec) return refused(ec.value());
    }
    struct stat old {};
    const bool there = ::lstat(target.c_str(), &old) == 0;
    if (there && S_ISLNK(old.st_mode)) return fail(phrase("files.link"), name);
    if (there && !S_ISREG(old.st_mode))
        return fail(phrase(S_ISDIR(old.st_mode) ? "files.folder" : "files.no_file"), name);
    const mode_t mode = there ? (old.st_mode & 07777) : fresh_mode;
    sweep_up_beside(target);
    std::string beside = target.string() + std::string(kNextTo) + std::string(kRandomLetters, 'X');
    int error = 0;
    {
        const Descriptor file(again([&] { return ::mkostemp(beside.data(), O_CLOEXEC); }));
        if (file.get() < 0) return refused(errno);
        again([&] { return ::flock(file.get(), LOCK_EX | LOCK_NB); });
        std::size_t done = 0;
        while (done < content.size() && error == 0) {
            const ssize_t put =
                again([&] { return ::write(file.get(), content.data() + done, content.size() - done); });
            if (put >= 0) done += static_cast<std::size_t>(put);
            else error = errno;
        }
        if (error == 0 && (::fchmod(file.get(), mode) != 0 || again([&] { return ::fsync(file.get()); }) != 0))
            error = errno;
    }
    if (error == 0 && ::rename(beside.c_str(), target.c_str()) != 0) error = errno;
    if (error != 0) {
        ::unlink(beside.c_str());
        return refused(error);
    }
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const Descriptor parent(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (parent.get() >= 0)
        ::fsync(parent.get());  // makes the rename survive a power cut; a failure of fsync here is ignored
    return {};
}

}  // namespace

Result<void> write_file_atomically(const fs::path& path, std::string_view content) {
    return replace(path, content, 0644);
}

Result<void> write_private_file_atomically(const fs::path& path, std::string_view content) {
    return replace(path, content, 0600);
}

Result<void> write_named_file_atomically(const fs::path& path, std::string_view content) {
    std::error_code ec;
    // Follows the links one by one, because the last link may point to a file that does not exist yet.
    fs::path target = path;
    for (int links = 0; fs::is_symlink(target, ec); ++links) {
        if (links == 40)  // Linux itself follows at most 40 links (ELOOP)
            return fail(phrase("files.cannot_save", {{"reason", reason_of(ELOOP)}}), path.filename().string());
        target = target.parent_path() / fs::read_symlink(target, ec);
    }
    return replace(target, content, 0644);
}

}  // namespace handrail
