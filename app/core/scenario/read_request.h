// How the world of a request is read. Any thread.
#pragma once

#include <functional>

#include "app/core/kept/world_request.h"
#include "worlds/base/result.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/scene.h"

namespace handrail {

// Pure.
ReadOptions read_options(const WorldRequest& request);

// Reads the world of a request, and fails with a sentence. The program reads in its confined process
// (imported_scene in app/main/world_files.h).
using WorldReader = std::function<Result<Scene>(const WorldRequest&)>;
// Reads in this process. For tests, which read their own worlds.
Result<Scene> read_requested(const WorldRequest& request);

}  // namespace handrail
