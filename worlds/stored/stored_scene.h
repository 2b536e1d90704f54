// A Scene as bytes and back, bit for bit: how the process that reads a file hands it to the program, and how the cache
// keeps it for the next start. The bytes are good for this machine and this build alone. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "worlds/base/result.h"
#include "worlds/scene/scene.h"

namespace handrail {

// Changes with every source in worlds and every text that the program says. The keys of the cache contain it.
extern const std::uint64_t kWorldsVersion;

std::string stored(const Scene& scene);
// Fails in one sentence for bytes that are none of a Scene, or of one that does not hold together.
Result<Scene> scene_from(std::string_view bytes);

// SHA-256, in hex, of all that is in the Scene, but not of what its reader reported.
std::string sum_of(const Scene& scene);

}  // namespace handrail
