// Keeps results that Handrail would otherwise have to compute again: one file for each key, in a folder of the person.
// The folder may be deleted at any time. Its size is bounded: keeping more removes the files used least recently.
//
// The folder is trusted only if it belongs to the person and nobody else may write in it. A file is trusted only if it
// belongs to the person and its digest fits its content and its name. If anything goes wrong, nothing is kept and
// nothing fails. Several processes may use the cache at once. Plain value; any thread except the app's, because it
// waits for the disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "worlds/base/descriptor.h"

namespace handrail::cache {

class Cache {
public:
    static constexpr std::uint64_t kMost_bytes = 500'000'000;

    // An empty folder means that nothing is kept.
    explicit Cache(std::filesystem::path folder, std::uint64_t most_bytes = kMost_bytes)
        : folder_(std::move(folder)), most_bytes_(most_bytes) {}

    explicit operator bool() const { return !folder_.empty(); }
    // Opens the file of that name for reading and marks it as used now; -1 if there is none. The reader, which may be
    // another process, must check the file with kept_content.
    Descriptor open(const std::string& name) const;
    void keep(const std::string& name, std::string_view content) const;

private:
    std::filesystem::path folder_;
    std::uint64_t most_bytes_;
};

// Returns what keep() wrote under that name. Empty if the bytes are damaged or were kept under another name.
std::optional<std::string> kept_content(int file, const std::string& name, const std::stop_token& stop = {});

// $XDG_CACHE_HOME/handrail, else ~/.cache/handrail; empty if neither is known.
std::filesystem::path user_cache_folder();

}  // namespace handrail::cache
