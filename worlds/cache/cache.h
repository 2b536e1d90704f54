// What Handrail works out itself and would have to work out again: one file for each key in a folder of the person's.
// The folder may be deleted at any time. It is bounded: keeping more removes the files that were used least recently.
// The folder is believed only if it belongs to the person and nobody else may write in it, a file only if it belongs to
// the person and its digest fits its content and its own name. If anything refuses, nothing is kept and nothing fails.
// Several processes may use it at once. Plain value; any thread but the app's, because it waits for the disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "worlds/base/descriptor.h"

namespace handrail {

class Cache {
public:
    static constexpr std::uint64_t kMost_bytes = 500'000'000;

    // Empty: nothing is kept.
    explicit Cache(std::filesystem::path folder, std::uint64_t most_bytes = kMost_bytes)
        : folder_(std::move(folder)), most_bytes_(most_bytes) {}

    explicit operator bool() const { return !folder_.empty(); }
    // The file of that name, open for reading, and noted as used now; -1: there is none. Whoever reads it checks it
    // with kept_content, which may be another process.
    Descriptor open(const std::string& name) const;
    void keep(const std::string& name, std::string_view content) const;

private:
    std::filesystem::path folder_;
    std::uint64_t most_bytes_;
};

// What keep() wrote under that name; nothing if the bytes are damaged or were kept under another name.
std::optional<std::string> kept_content(int file, const std::string& name, const std::stop_token& stop = {});

// $XDG_CACHE_HOME/handrail, else ~/.cache/handrail; empty if neither is known.
std::filesystem::path user_cache_folder();

}  // namespace handrail
