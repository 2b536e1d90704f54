// The hands: their devices, what their servos last reported, and what is sent to the servos. Plain state; app thread
// only.
#pragma once

#include <optional>
#include <string>

#include "app/core/context/workspace_scale.h"
#include "haptic/device/device_spec.h"
#include "haptic/servo/servo_tick.h"

namespace handrail::core {

// The device of one hand, or none. Of `spec`, only workspace size, force and stiffness are used.
struct HandFacts {
    bool present = false;
    bool simulated = false;
    device::DeviceSpec spec{};
    std::string serial = {};  // empty: it has none
};

struct HandsState {
    HandFacts right, left;  // right: also the only one
    servo::ToolState tool, left_tool;
    servo::ServoTuning tuning;
    servo::BodyTuning left_bodies;  // what the left hand's servo receives about holding; everything else as in `tuning`
    servo::WorkspacePose pose;
    std::optional<NamedScale> named_scale;  // none: the scale of the settings
    bool keys_alone = false;                // the keyboard moves a simulated hand because there is no device
    bool left_behind = false;               // the walker moved on, and a solid is between it and the only or right hand

    // True if the position of the only or right hand is known.
    bool known() const { return right.present && tool.ticks > 0; }
    // True if that hand is where the walker is. Questions are then about what it touches and where it is, not about the
    // walker's feet.
    bool answers() const { return known() && !left_behind; }
    bool two() const { return right.present && left.present; }
    bool at_desk() const { return tool.desk.open; }
};

}  // namespace handrail::core
