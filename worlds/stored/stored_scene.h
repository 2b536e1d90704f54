// Packs a Scene into bytes and reads it back bit for bit. The process that reads a file passes the Scene to the program
// in this form, and the cache keeps it for the next start. The bytes are valid only for this machine and this build.
// Pure functions; any thread may call them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "worlds/base/result.h"
#include "worlds/scene/scene.h"

namespace handrail::stored {

// A number that changes whenever a source file in worlds or a text of the program changes. The number is part of the
// cache's keys.
extern const std::uint64_t kWorldsVersion;

std::string stored(const Scene& scene);
// Reads a Scene. Fails with one sentence if the bytes are not a Scene, or if the Scene is inconsistent.
Result<Scene> scene_from(std::string_view bytes);

// Returns the SHA-256, in hex, of everything in the Scene except the reader's report.
std::string sum_of(const Scene& scene);

}  // namespace handrail::stored
