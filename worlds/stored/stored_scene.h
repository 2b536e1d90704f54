// Packs a Scene into bytes and reads it back, bit for bit. The process that reads a file hands the Scene to the program
// in this form, and the cache keeps it for the next start. The bytes are valid for this machine and this build only.
// Pure functions; any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "worlds/base/result.h"
#include "worlds/scene/scene.h"

namespace handrail::stored {

// Changes with every source in worlds and every text of the program. The keys of the cache contain it.
extern const std::uint64_t kWorldsVersion;

std::string stored(const Scene& scene);
// Fails with one sentence if the bytes are not a Scene, or a Scene that is inconsistent.
Result<Scene> scene_from(std::string_view bytes);

// SHA-256, in hex, of everything in the Scene except the reader's report.
std::string sum_of(const Scene& scene);

}  // namespace handrail::stored
