// Reads and replaces whole files. Every access to a file that a person names goes through these functions. Reading
// never waits for data from a pipe or a device. Writing is atomic: a temporary file next to the target, fsync, rename;
// the old file survives any failure. System calls that a signal interrupts are repeated.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

#include "worlds/base/descriptor.h"
#include "worlds/base/result.h"

namespace handrail {

// Describes an errno: the usual reasons in the spoken language, all others in the system's words. Without a full stop.
std::string reason_of(int error);

// An ordinary file, opened for reading.
struct OpenFile {
    Descriptor file;
    std::size_t size = 0;
    std::string name;  // the name to use in sentences
};

Result<OpenFile> open_file(const std::filesystem::path& path);
// `name` must be relative and without "..". A link in any part of it is refused, so the file is really inside `folder`.
Result<OpenFile> open_file_within(const std::filesystem::path& folder, const std::filesystem::path& name);

// Returns the content of the whole file. Fails with one sentence if the file is missing, unreadable, larger than
// max_bytes, or not an ordinary file (a folder, pipe, socket or device). It also fails when stopped; it checks `stop`
// every 64 KiB.
Result<std::string> read_whole_file(const std::filesystem::path& path, std::size_t max_bytes = std::size_t{1} << 30,
                                    const std::stop_token& stop = {});
Result<std::string> read_whole_file(const OpenFile& from, std::size_t max_bytes, const std::stop_token& stop);

// The bytes of a file, mapped into memory: the system loads them when they are read and drops them when memory is
// short. Nothing is copied. If somebody truncates the file meanwhile, reading the lost part raises SIGBUS, so use this
// only in processes that may end that way.
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

// Fails as read_whole_file does. Also like that function, throws std::bad_alloc if there is not enough memory.
Result<MappedFile> map_file(const OpenFile& from, std::size_t max_bytes = std::size_t{1} << 30);

// Replaces `path` with `content`, or leaves it exactly as it was and returns the reason. Creates missing parent
// folders. Refuses a symbolic link, because somebody who prepared the folder could point it at any file of the person.
// Keeps the permission bits of an existing file, which must be an ordinary file. Removes temporary files that were left
// next to this file when the program was killed during an earlier replacement.
Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view content);
// The same, but a new file is readable by the person alone.
Result<void> write_private_file_atomically(const std::filesystem::path& path, std::string_view content);
// The same for a path that the person chose (their settings, the file of an export). A symbolic link is followed, so it
// stays a link.
Result<void> write_named_file_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace handrail
