// Reads IFC (2x3, 4, 4x2, 4x3) as a Scene. The building consists of solids if the file contains solids. Rooms and doors
// are those that the file states. Any thread may call it.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

#include "worlds/base/result.h"
#include "worlds/scene/scene.h"

namespace handrail::ifc {

struct IfcOptions {
    std::string world_name;       // name of the world if the file has none that can be spoken
    bool guess_materials = true;  // guess materials from the names in the file
    std::function<void(double fraction)> progress;
    std::function<void(std::string_view stage)> stage;  // called with the current stage, as the key of a text
    std::stop_token stop;
};

// Reads the building. The same bytes always give the same Scene. Fails with one sentence if the file is damaged, cut
// short, in another schema, without a building, or too large.
Result<Scene> read_ifc_building(std::string_view bytes, const std::string& file_name, const IfcOptions& options = {});

}  // namespace handrail::ifc
