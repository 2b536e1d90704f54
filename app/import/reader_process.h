// Reading a file in a process of its own (handrail-reader), so that no file takes the program down, whatever it holds:
// its memory and time are bounded, and it dies with the program. What it made of the file comes back through a piece of
// shared memory (worlds/stored), how far it is through a pipe.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "worlds/readers/reader.h"

namespace handrail {

struct ReaderLimits {
    std::size_t memory_bytes = 2'000'000'000;  // address space; sanitized builds need all there is and have none
    int cpu_s = 50;                            // of the processor
    double wall_s = 60.0;                      // on the clock, where the machine is busy or a disk hangs
};

// A file beside the world's that it needed, and its checksum; 0 where it was not to be had.
struct BesideFile {
    std::string name;
    std::uint32_t checksum = 0;
    bool operator==(const BesideFile&) const = default;
};

struct ReadApart {
    std::string scene;  // as bytes: scene_from(scene)
    std::vector<BesideFile> beside;
};

// handrail-reader, beside this program or installed; empty: there is none.
std::filesystem::path find_reader_program();

// As read_world. options.read_beside is not asked: the process looks beside the file itself. Waits for the process, and
// ends it when `options.stop` says so, within a tenth of a second. One sentence for each way in which it can end. The
// calling thread must outlive the call: the kernel ends the process with the thread.
Result<ReadApart> read_apart(const std::filesystem::path& path, const ReadOptions& options,
                             const std::filesystem::path& program, const ReaderLimits& limits = {});

// The main function of handrail-reader.
int reader_process(int argc, char** argv);

}  // namespace handrail
