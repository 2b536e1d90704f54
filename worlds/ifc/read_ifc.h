// IFC (2x3, 4, 4x2, 4x3) as a Scene: the building solid where the file gives solids, its rooms and doors as the file
// states them. Any thread.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

#include "worlds/base/result.h"
#include "worlds/scene/scene.h"

namespace handrail {

struct IfcOptions {
    std::string world_name;       // where the file gives none that can be spoken
    bool guess_materials = true;  // from what the file calls them
    std::function<void(double fraction)> progress;
    std::function<void(std::string_view stage)> stage;  // a text's key
    std::stop_token stop;
};

// The same bytes give the same Scene. Fails with one sentence for what is damaged, cut short, of another schema, holds
// no building or too much of one.
Result<Scene> read_ifc_building(std::string_view bytes, const std::string& file_name, const IfcOptions& options = {});

}  // namespace handrail
