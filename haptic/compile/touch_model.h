// What of a world the hand's tick has to look at, counted: so that one can see that what a world does not contain is
// not modelled. `handrail info` prints it. Pure function of a compiled scene; looks at everything once; any thread but
// the servo's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "haptic/render/haptic_scene.h"

namespace handrail {

struct TouchModel {
    struct Part {
        std::string_view key;  // as in `info --json`: "liquids_with_drag"
        std::size_t count = 0;
    };
    std::vector<Part> parts;  // fixed order; also those with count 0
    // Stages of the tick that only some worlds need, by their names in `info --json`: those this world switches on, and
    // those that cost it nothing.
    std::vector<std::string_view> stages_on, stages_off;
};
TouchModel touch_model(const HapticScene& scene);

// To be spoken: "3 liquids with drag", "liquid surfaces".
std::string spoken_part(const TouchModel::Part& part);
std::string spoken_stage(std::string_view stage);

}  // namespace handrail
