// Reads the world of a WorldRequest. Any thread may call these functions.
#pragma once

#include <functional>

#include "app/core/kept/world_request.h"
#include "settings/toml_value.h"
#include "worlds/base/result.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

// Returns the options for the reader. It is a pure function.
readers::ReadOptions read_options(const WorldRequest& request);

// Functions that read a world and the files next to it. Each fails with a sentence. The program uses functions that
// read in its confined process (imported_scene and toml_next_to_worlds in app/main/world_files.h).
struct WorldReader {
    std::function<Result<Scene>(const WorldRequest&)> scene;
    settings::TomlReader toml = settings::toml_of;
};
// Reads the world in this process. Only tests may use it, because they trust their own worlds.
Result<Scene> read_requested(const WorldRequest& request);

}  // namespace handrail::core
