// What the cache keeps of a world that took long to read: which files next to it were needed, then the Scene as bytes.
// Private to this folder, but for tests.
#pragma once

#include <functional>
#include <optional>

#include "app/import/reader_process.h"

namespace handrail {

std::string kept_scene(const std::vector<BesideFile>& beside, std::string_view scene);
// Calls `still_good` before it unpacks the Scene; nothing if that says no. Fails for bytes that are damaged.
Result<std::optional<Scene>> scene_in(std::string_view kept,
                                      const std::function<bool(const std::vector<BesideFile>&)>& still_good);

}  // namespace handrail
