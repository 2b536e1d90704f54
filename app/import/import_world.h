// How the program comes to a world from a file: a process of its own reads it (reader_process). The cache keeps what
// comes of it, so that the next start is as fast as a .map's, of which nothing is kept. Any thread but the app's,
// because it waits.
#pragma once

#include "app/import/reader_process.h"
#include "worlds/cache/cache.h"

namespace handrail {

struct ImportHow {
    // Where what was read is kept, and looked for first.
    Cache cache{{}};
    std::filesystem::path program = find_reader_program();  // empty: the file is read in this process
    ReaderLimits limits;
};

// A small file is read sooner than what would be kept of it.
inline constexpr std::uintmax_t kLeastKept_bytes = 65'536;
// A smaller .map is read faster than it would be taken from the cache.
inline constexpr std::uintmax_t kLeastKeptMap_bytes = 4'194'304;

struct ImportedWorld {
    Scene scene;
    bool kept = false;          // taken from what was kept
    bool kept_damaged = false;  // what was kept could not be understood, so the file was read anew
};

// As read_world. What was kept counts only for the same bytes of the file and of those it needs next to it, the same
// options, language and build: all but the files next to it are in the key, by SHA-256, and the digests of those are
// kept with the scene.
Result<ImportedWorld> import_world(const std::filesystem::path& path, const ReadOptions& options, const ImportHow& how);

}  // namespace handrail
