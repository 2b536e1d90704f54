// Reading and replacing whole files: the one way to everything a person names. Reading never waits for a pipe or a
// device to give something. Writing is atomic: beside the target, fsync, rename; the old file survives any failure. An
// interrupted call is made again.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

#include "worlds/base/descriptor.h"
#include "worlds/base/result.h"

namespace handrail {

// Why the system refused something, by its errno: the usual reasons in the language spoken, the others in the system's
// words. No full stop.
std::string reason_of(int error);

// An ordinary file that is open for reading.
struct OpenFile {
    Descriptor file;
    std::size_t size = 0;
    std::string name;  // for sentences
};

Result<OpenFile> open_file(const std::filesystem::path& path);
// `name` is relative and without "..". A link at any part of it is refused, so the file is in `folder` or below.
Result<OpenFile> open_file_within(const std::filesystem::path& folder, const std::filesystem::path& name);

// The whole file. Fails in one sentence when it is missing, unreadable, larger than max_bytes, or no ordinary file (a
// folder, a pipe, a socket, a device), and when it is stopped, which is looked at every 64 KiB.
Result<std::string> read_whole_file(const std::filesystem::path& path, std::size_t max_bytes = std::size_t{1} << 30,
                                    const std::stop_token& stop = {});
Result<std::string> read_whole_file(const OpenFile& from, std::size_t max_bytes, const std::stop_token& stop);

// The bytes of a file as the system lays them into memory when they are looked at, and drops them again when memory is
// short; nothing is copied. Whoever looks at what somebody cuts off the file meanwhile gets SIGBUS, so this is for
// processes that may end by that.
class MappedFile {
public:
    explicit MappedFile(std::string_view bytes) noexcept : bytes_(bytes) {}
    MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    ~MappedFile();

    std::string_view bytes() const { return bytes_; }

private:
    std::string_view bytes_;
};

// Fails as read_whole_file does; throws std::bad_alloc, as that does, where there is no room in memory.
Result<MappedFile> map_file(const OpenFile& from, std::size_t max_bytes = std::size_t{1} << 30);

// Replaces `path` with `content`, or leaves it exactly as it was and says why. Creates missing parent folders.
// Refuses a symbolic link in one sentence: somebody who prepared the folder could point it at any file of the person's.
// Keeps the permission bits of an existing file, which must be an ordinary file. Removes what an earlier replacement of
// this file left next to it when the program was killed in the middle.
Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view content);
// The same, but only the person may read a new file.
Result<void> write_private_file_atomically(const std::filesystem::path& path, std::string_view content);
// The same for a path that the person chose (their settings, the file of an export): a symbolic link is followed, so
// that it stays a link.
Result<void> write_named_file_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace handrail
