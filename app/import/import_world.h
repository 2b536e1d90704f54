// Reads a world from a file in a separate process (see reader_process). Stores the result in a cache, so that the next
// start is as fast as with a small .map; small files are not cached. Any thread except the app thread may call
// import_world, because it waits.
#pragma once

#include "app/import/reader_process.h"
#include "worlds/cache/cache.h"

namespace handrail::importing {

struct ImportHow {
    // The cache that contains earlier results and receives new ones.
    cache::Cache cache{{}};
    // Path of handrail-reader; empty: this process reads the file.
    std::filesystem::path program = find_reader_program();
    ReaderLimits limits;
};

// Smaller files are not cached, because reading them is faster than unpacking a cached result.
inline constexpr std::uintmax_t kLeastKept_bytes = 65'536;
// The same limit, but for .map files.
inline constexpr std::uintmax_t kLeastKeptMap_bytes = 4'194'304;

struct ImportedWorld {
    Scene scene;
    bool kept = false;          // true if the scene comes from the cache
    bool kept_damaged = false;  // true if the cached result was damaged, so the file was read again
};

// Returns the world of the file. Fails as read_world does. Uses a cached result only if the file, the files that it
// needs next to it, the options, the language and the build are the same. The cache key is the SHA-256 of all of these
// except the files next to the world; the digests of those files are stored with the scene.
Result<ImportedWorld> import_world(const std::filesystem::path& path, const readers::ReadOptions& options,
                                   const ImportHow& how);

}  // namespace handrail::importing
