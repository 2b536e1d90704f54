// The contents of the cache for a world that took long to read: the list of files that it needed next to it, then the
// Scene as bytes. Private to this folder, except for tests.
#pragma once

#include <functional>
#include <optional>

#include "app/import/reader_process.h"

namespace handrail::importing {

std::string kept_scene(const std::vector<NeighbourFile>& beside, std::string_view scene);
// Unpacks the Scene. Calls `still_good` before, and returns nothing if that returns false. Fails if the bytes are
// damaged.
Result<std::optional<Scene>> scene_in(std::string_view kept,
                                      const std::function<bool(const std::vector<NeighbourFile>&)>& still_good);

}  // namespace handrail::importing
