// Reading and replacing whole files. Writing is atomic: beside the target, fsync, rename; the old file survives any failure.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "worlds/base/result.h"

namespace handrail {

// Why the system refused something, by its errno: the usual reasons in the language spoken, the others in the system's words. No full stop.
std::string reason_of(int error);

// The whole file. Fails in one sentence when it is missing, unreadable, a folder, or larger than max_bytes.
Result<std::string> read_whole_file(const std::filesystem::path& path, std::size_t max_bytes = std::size_t{1} << 30);

// Replaces `path` with `content`, or leaves it exactly as it was and says why. Creates missing parent folders.
// A symbolic link is followed, so that the link stays a link. Keeps the permission bits of an existing file.
Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace handrail
