// Counts the parts of a world that a tick of the servo has to process. The counts show that features which a world does
// not contain cost nothing. `handrail info` prints the counts. touch_model() is a pure function that visits each part
// of a compiled scene once. Any thread but the servo thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "haptic/render/haptic_scene.h"

namespace handrail::compile {

struct TouchModel {
    struct Part {
        std::string_view key;  // name in `info --json`, for example "liquids_with_drag"
        std::size_t count = 0;
    };
    std::vector<Part> parts;  // in a fixed order; includes those with count 0
    // Optional stages of the tick, by their names in `info --json`. `stages_on` are those that this world needs,
    // `stages_off` those that cost it nothing.
    std::vector<std::string_view> stages_on, stages_off;
};
TouchModel touch_model(const render::HapticScene& scene);

// Return phrases suitable for speech: "3 liquids with drag", "liquid surfaces".
std::string spoken_part(const TouchModel::Part& part);
std::string spoken_stage(std::string_view stage);

}  // namespace handrail::compile
