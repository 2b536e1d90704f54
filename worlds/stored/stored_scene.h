// A Scene as bytes and back, bit for bit: how one is handed from the process that reads a file to the program, and kept
// for the next start. The bytes are good for this machine and this build alone. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "worlds/base/result.h"
#include "worlds/scene/scene.h"

namespace handrail {

// Another number whenever a source of the readers, of what a Scene is made of, or of what is said has changed.
extern const std::uint64_t kReaderVersion;

std::string stored(const Scene& scene);
// Fails in one sentence for bytes that are none of a Scene, or of one that does not hold together.
Result<Scene> scene_from(std::string_view bytes);

// By which a Scene is known again: of all that stands in it, but not of what its reader reported.
struct SceneSum {
    std::uint64_t bytes = 0;
    std::uint32_t checksum = 0;
    bool operator==(const SceneSum&) const = default;
};
SceneSum sum_of(const Scene& scene);

// Of bytes, in pieces: begin with 0 and hand on what came out. CRC-32.
std::uint32_t checksum(std::uint32_t before, std::string_view bytes);

}  // namespace handrail
