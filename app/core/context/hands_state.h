// The state of the hands consists of their devices, the last reports of their servos, and the values for the servos. It
// is plain state for the app thread only.
#pragma once

#include <optional>
#include <string>

#include "app/core/context/workspace_scale.h"
#include "haptic/device/device_spec.h"
#include "haptic/servo/servo_tick.h"

namespace handrail::core {

// The device of one hand. `present` is false if there is none. Handrail uses only workspace size, force and stiffness
// from `spec`.
struct HandFacts {
    bool present = false;
    bool simulated = false;
    device::DeviceSpec spec{};
    std::string serial = {};  // empty: the device has no serial number
};

struct HandsState {
    HandFacts right, left;  // if there is only one hand, it is `right`
    servo::ToolState tool, left_tool;
    servo::ServoTuning tuning;
    servo::BodyTuning left_bodies;  // how the left hand's servo holds bodies; all its other values are in `tuning`
    servo::WorkspacePose pose;
    std::optional<NamedScale> named_scale;  // none: the scale comes from the settings
    bool keys_alone = false;                // the keyboard moves a simulated hand because there is no device
    // True: the walker moved on, so that a solid is now between the walker and the only or right hand.
    bool left_behind = false;

    // Returns true if the position of the only or right hand is known.
    bool known() const { return right.present && tool.ticks > 0; }
    // Returns true if the only or right hand is where the walker is. Answers to questions then describe the place of
    // the hand and what it touches, instead of the place of the walker's feet.
    bool answers() const { return known() && !left_behind; }
    bool two() const { return right.present && left.present; }
    bool at_desk() const { return tool.desk.open; }
};

}  // namespace handrail::core
