// The hands: what they hold, where their servos told last that they are, and what the servos are told. Plain state; app
// thread only.
#pragma once

#include <optional>
#include <string>

#include "app/core/context/workspace_scale.h"
#include "haptic/device/device_spec.h"
#include "haptic/servo/servo_tick.h"

namespace handrail {

// What the hand has: none, or a device of which the workspace size, force and stiffness count.
struct HandFacts {
    bool present = false;
    bool simulated = false;
    DeviceSpec spec{};
    std::string serial = {};  // empty: it has none
};

struct HandsState {
    HandFacts right, left;  // right: also the only one
    ToolState tool, left_tool;
    ServoTuning tuning;
    BodyTuning left_bodies;  // what the left hand's servo is told of holding; all else as tuning.bodies
    WorkspacePose pose;
    std::optional<NamedScale> named_scale;  // none: the scale of the settings
    bool keys_alone = false;                // the simulated hand is there for want of a real one
    bool left_behind = false;  // the body has gone on, and something solid is between it and the only or right hand

    // The place of the only or right hand is known.
    bool known() const { return right.present && tool.ticks > 0; }
    // That hand is where the body is: what it touches and where it is answer questions, and not what is at the feet.
    bool answers() const { return known() && !left_behind; }
    bool two() const { return right.present && left.present; }
    bool at_desk() const { return tool.desk.open; }
};

}  // namespace handrail
