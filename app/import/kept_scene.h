// Packs and unpacks what the cache stores for a world that took long to read: the list of files that the world needed
// next to its own file, then the Scene as bytes. Private to this folder, except for tests.
#pragma once

#include <functional>
#include <optional>

#include "app/import/reader_process.h"

namespace handrail::importing {

std::string kept_scene(const std::vector<NeighbourFile>& beside, std::string_view scene);
// Unpacks the Scene. Before that, calls `still_good` with the list of files, and returns nothing if `still_good`
// returns false. Fails if the bytes are damaged.
Result<std::optional<Scene>> scene_in(std::string_view kept,
                                      const std::function<bool(const std::vector<NeighbourFile>&)>& still_good);

}  // namespace handrail::importing
