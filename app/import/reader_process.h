// Reads a file in a separate process (handrail-reader), so that no file can crash the program, whatever it contains.
// Its memory and time are limited, and it ends with the program. It is confined: it has no environment, opens no files,
// and requests the world and the files next to it from the program (requested_files). The same process unpacks what the
// cache keeps and parses TOML (toml_apart). The result comes back through shared memory (worlds/stored), the progress
// through a pipe. The program trusts only the length of the answer: reading it checks every count, enumerator and
// reference.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "worlds/readers/reader.h"

namespace handrail::importing {

struct ReaderLimits {
    std::size_t memory_bytes = 2'000'000'000;  // address space; not limited in sanitized builds, which need all of it
    int cpu_s = 50;                            // processor time
    double idle_s = 60.0;  // time on the clock without any progress, for example because a disk hangs
    std::size_t answer_bytes = std::size_t{1} << 30;  // size of the answer
};

// A file that was needed next to the world's, and its SHA-256 in hex; empty if it could not be read.
struct NeighbourFile {
    std::string name;
    std::string sha256;
    bool operator==(const NeighbourFile&) const = default;
};

struct ReadApart {
    std::string scene;  // as bytes, for scene_from(scene)
    bool kept = false, kept_damaged = false;
    std::vector<NeighbourFile> beside;
};

// A cached file (worlds/cache), which the process checks and unpacks; -1: none.
struct KeptForReader {
    int file = -1;
    std::string name;
};

// The path of handrail-reader, next to this program or installed; empty if it does not exist.
std::filesystem::path find_reader_program();

// Like read_world, except that options.read_beside is not called: files next to the world's are opened here. Waits for
// the process, and ends it within a tenth of a second after `options.stop`. Each way in which the process can end has
// its own sentence. The calling thread must outlive the call, because the kernel ends the process with the thread. The
// process takes the scene from the cache. It reads the file only if the cached scene is damaged or another file next to
// the world's has changed.
Result<ReadApart> read_apart(const std::filesystem::path& path, const readers::ReadOptions& options,
                             const std::filesystem::path& program, const ReaderLimits& limits = {},
                             const KeptForReader& kept = {});

// Unpacks cached routes in such a process (see unpacked_ways). Empty if they are damaged or it fails.
std::string unpack_ways_apart(const KeptForReader& kept, const std::filesystem::path& program,
                              const std::stop_token& stop = {}, const ReaderLimits& limits = {});

// The main function of handrail-reader.
int reader_process(int argc, char** argv);

}  // namespace handrail::importing
