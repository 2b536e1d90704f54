// Keeps results that Handrail would otherwise have to compute again, with one file for each key in a folder of the
// person. The folder may be deleted at any time. Its size is limited: to make space for a new file, the least recently
// used files are removed.
//
// The cache trusts the folder only if it belongs to the person and nobody else may write in it. It trusts a file only
// if it belongs to the person and its digest matches its content and its name. If anything goes wrong, nothing is kept,
// and no call fails. Several processes may use the cache at once. A plain value. Use it on any thread except the app
// thread, because it waits for the disk.
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

    // If `folder` is empty, nothing is kept.
    explicit Cache(std::filesystem::path folder, std::uint64_t most_bytes = kMost_bytes)
        : folder_(std::move(folder)), most_bytes_(most_bytes) {}

    explicit operator bool() const { return !folder_.empty(); }
    // Opens the file of that name for reading and marks it as used now. Returns -1 if there is no such file. The code
    // that reads the file, perhaps in another process, must check it with kept_content.
    Descriptor open(const std::string& name) const;
    void keep(const std::string& name, std::string_view content) const;

private:
    std::filesystem::path folder_;
    std::uint64_t most_bytes_;
};

// Returns what keep() wrote under that name. Empty if the bytes are damaged or belong to another name, or if a stop is
// requested.
std::optional<std::string> kept_content(int file, const std::string& name, const std::stop_token& stop = {});

// Returns $XDG_CACHE_HOME/handrail, or else ~/.cache/handrail. Empty if neither is known.
std::filesystem::path user_cache_folder();

}  // namespace handrail::cache
