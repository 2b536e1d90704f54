// Reading a file in a process of its own (handrail-reader), so that no file takes the program down, whatever it holds:
// its memory and time are bounded, and it dies with the program. It is confined: it has no environment, opens nothing,
// and requests the world and the files next to it from the program (requested_files). The same process unpacks what the
// cache keeps and parses TOML (toml_apart). What it made of either comes back through a piece of shared memory
// (worlds/stored), how far it is through a pipe. Of that answer the program trusts nothing but its length: reading it
// back checks every count, enumerator and reference.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "worlds/readers/reader.h"

namespace handrail {

struct ReaderLimits {
    std::size_t memory_bytes = 2'000'000'000;         // address space; sanitized builds need all there is and have none
    int cpu_s = 50;                                   // of the processor
    double idle_s = 60.0;                             // on the clock, without any work done: a disk hangs
    std::size_t answer_bytes = std::size_t{1} << 30;  // what it hands over
};

// A file next to the world's that it needed, and its SHA-256 in hex; empty if it could not be read.
struct BesideFile {
    std::string name;
    std::string sha256;
    bool operator==(const BesideFile&) const = default;
};

struct ReadApart {
    std::string scene;  // as bytes: scene_from(scene)
    bool kept = false, kept_damaged = false;
    std::vector<BesideFile> beside;
};

// A file of the cache (worlds/cache), which the process checks and unpacks; -1: none.
struct KeptForReader {
    int file = -1;
    std::string name;
};

// handrail-reader, beside this program or installed; empty: there is none.
std::filesystem::path find_reader_program();

// As read_world. options.read_beside is not called: files next to the world's are opened here. Waits for the process,
// and ends it when `options.stop` says so, within a tenth of a second. One sentence for each way in which it can end.
// The calling thread must outlive the call: the kernel ends the process with the thread. The process takes the scene
// from what was kept, and reads the file only if that is damaged or another file next to the world's has changed.
Result<ReadApart> read_apart(const std::filesystem::path& path, const ReadOptions& options,
                             const std::filesystem::path& program, const ReaderLimits& limits = {},
                             const KeptForReader& kept = {});

// The ways that were kept, unpacked in such a process (unpacked_ways); empty if they are damaged or it fails.
std::string unpack_ways_apart(const KeptForReader& kept, const std::filesystem::path& program,
                              const std::stop_token& stop = {}, const ReaderLimits& limits = {});

// The main function of handrail-reader.
int reader_process(int argc, char** argv);

}  // namespace handrail
