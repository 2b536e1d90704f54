// Gets a world from a file. A separate process reads it (see reader_process). The result is cached, so that the next
// start is as fast as with a small .map, which is not cached. Any thread except the app's, because it waits.
#pragma once

#include "app/import/reader_process.h"
#include "worlds/cache/cache.h"

namespace handrail::importing {

struct ImportHow {
    // The cache where results are looked up and kept.
    cache::Cache cache{{}};
    std::filesystem::path program = find_reader_program();  // empty: the file is read in this process
    ReaderLimits limits;
};

// Smaller files are read faster than the cached result.
inline constexpr std::uintmax_t kLeastKept_bytes = 65'536;
// Smaller .map files are read faster than the cached result.
inline constexpr std::uintmax_t kLeastKeptMap_bytes = 4'194'304;

struct ImportedWorld {
    Scene scene;
    bool kept = false;          // taken from the cache
    bool kept_damaged = false;  // the cached result was damaged, so the file was read again
};

// Fails as read_world does. A cached result is used only for the same bytes of the file and of the files that it needs
// next to it, and for the same options, language and build. The cache key is the SHA-256 of all of these except the
// files next to it, whose digests are kept with the scene.
Result<ImportedWorld> import_world(const std::filesystem::path& path, const readers::ReadOptions& options,
                                   const ImportHow& how);

}  // namespace handrail::importing
