// Reads a file in a separate process, handrail-reader, so that no file can crash this program, whatever the file
// contains. The process has limited memory and time, and it ends when this program ends. It is confined: it has no
// environment and opens no files, but requests the world and the files next to it from this program (requested_files).
//
// handrail-reader also unpacks cached results and parses TOML (toml_apart). The result comes back through shared memory
// (worlds/stored), the progress through a pipe. This program trusts only the length of the answer: when it reads the
// answer, it checks every count, enumerator and reference.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "worlds/readers/reader.h"

namespace handrail::importing {

struct ReaderLimits {
    // Size of the process's address space. The size is not limited in sanitized builds, because a sanitizer reserves
    // the whole address space.
    std::size_t memory_bytes = 2'000'000'000;
    int cpu_s = 50;        // processor time in seconds
    double idle_s = 60.0;  // time on the clock in which the process makes no progress, for example because a disk hangs
    std::size_t answer_bytes = std::size_t{1} << 30;  // size of the answer in shared memory
};

// A file that the world needs next to its own file, and the SHA-256 of that file in hex. The SHA-256 is empty if the
// file could not be read.
struct NeighbourFile {
    std::string name;
    std::string sha256;
    bool operator==(const NeighbourFile&) const = default;
};

struct ReadApart {
    std::string scene;  // the scene as bytes, for scene_from(scene)
    bool kept = false, kept_damaged = false;
    std::vector<NeighbourFile> beside;
};

// A cached file (worlds/cache), which the process checks and unpacks. The descriptor -1 means that there is none.
struct KeptForReader {
    int file = -1;
    std::string name;
};

// Returns the path of handrail-reader, next to this program or installed; empty if it does not exist.
std::filesystem::path find_reader_program();

// Reads a world as read_world does, but never calls options.read_next_to, because this program itself opens the files
// next to the world. Waits for the process, and ends it within a tenth of a second after `options.stop`. Fails with a
// different sentence for each way in which the process can fail. The calling thread must not end during the call,
// because the kernel ends the process with that thread. If `kept` is given, the process unpacks the scene from the
// cache. It then reads the file only if the cached scene is damaged, or if a file next to the world has changed.
Result<ReadApart> read_apart(const std::filesystem::path& path, const readers::ReadOptions& options,
                             const std::filesystem::path& program, const ReaderLimits& limits = {},
                             const KeptForReader& kept = {});

// Unpacks cached routes in a handrail-reader process (see unpacked_navigation). Returns an empty text if the routes are
// damaged or the process fails.
std::string unpack_navigation_apart(const KeptForReader& kept, const std::filesystem::path& program,
                                    const std::stop_token& stop = {}, const ReaderLimits& limits = {});

// Implements the main function of handrail-reader. Returns the exit status.
int reader_process(int argc, char** argv);

}  // namespace handrail::importing
