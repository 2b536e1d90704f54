// Counts what the hand's tick has to look at in a world, to show that features which a world does not contain are not
// modelled. `handrail info` prints it. Pure function of a compiled scene; looks at everything once; any thread but the
// servo's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "haptic/render/haptic_scene.h"

namespace handrail::compile {

struct TouchModel {
    struct Part {
        std::string_view key;  // as in `info --json`, for example "liquids_with_drag"
        std::size_t count = 0;
    };
    std::vector<Part> parts;  // in a fixed order; includes those with count 0
    // Stages of the tick that only some worlds need, by their names in `info --json`: those that this world switches
    // on, and those that cost it nothing.
    std::vector<std::string_view> stages_on, stages_off;
};
TouchModel touch_model(const render::HapticScene& scene);

// Suitable for speech: "3 liquids with drag", "liquid surfaces".
std::string spoken_part(const TouchModel::Part& part);
std::string spoken_stage(std::string_view stage);

}  // namespace handrail::compile
