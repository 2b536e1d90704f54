// Reads and replaces whole files. Every access to a file that a person names goes through these functions. Reading
// never waits for data from a pipe or a device. Writing is atomic: it writes a temporary file next to the target, calls
// fsync, and renames. The old file survives any failure. System calls that a signal interrupts are repeated.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

#include "worlds/base/descriptor.h"
#include "worlds/base/result.h"

namespace handrail {

// Returns a description of an errno without a full stop. Common reasons are in the spoken language, all others in the
// system's own words.
std::string reason_of(int error);

// An ordinary file that is open for reading.
struct OpenFile {
    Descriptor file;
    std::size_t size = 0;
    std::string name;  // the name of the file for use in sentences
};

Result<OpenFile> open_file(const std::filesystem::path& path);
// Opens the file `name` within `folder`. `name` must be relative and must not contain "..". The function refuses a
// symbolic link in any part of `name`, so the opened file is really inside `folder`.
Result<OpenFile> open_file_within(const std::filesystem::path& folder, const std::filesystem::path& name);

// Returns the content of the whole file. Fails with one sentence if the file is missing, unreadable, larger than
// max_bytes, or not an ordinary file (a folder, pipe, socket or device). Also fails after a stop request; it checks
// `stop` every 64 KiB.
Result<std::string> read_whole_file(const std::filesystem::path& path, std::size_t max_bytes = std::size_t{1} << 30,
                                    const std::stop_token& stop = {});
Result<std::string> read_whole_file(const OpenFile& from, std::size_t max_bytes, const std::stop_token& stop);

// The bytes of a file, mapped into memory without copying. The system loads them when they are read and drops them when
// memory is short. If another process truncates the file while it is mapped, reading the lost part raises SIGBUS. So
// use this only in processes that may end in that way.
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

// Maps a file into memory. Fails as read_whole_file does, and throws std::bad_alloc if there is not enough memory.
Result<MappedFile> map_file(const OpenFile& from, std::size_t max_bytes = std::size_t{1} << 30);

// Replaces `path` with `content`, or leaves the file exactly as it was and returns the reason. Creates missing parent
// folders. Refuses a symbolic link, because whoever prepared the folder could point the link at any file of the person.
// Keeps the permission bits of an existing file, which must be an ordinary file. Removes temporary files of the same
// target that an earlier, killed process left behind.
Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view content);
// Like write_file_atomically, but only the person can read the new file.
Result<void> write_private_file_atomically(const std::filesystem::path& path, std::string_view content);
// Like write_file_atomically, for a path that the person chose (the settings file, the file of an export). If the path
// is a symbolic link, replaces the file to which it points and keeps the link.
Result<void> write_named_file_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace handrail
