// The output of a session's tick for the servo of one hand, in addition to what both hands share: the rendered world
// and the places of its bodies. Plain data; app thread only.
#pragma once

#include <memory>

#include "haptic/servo/servo_tick.h"

namespace handrail::core {

struct HandOutput {
    servo::WorkspacePose pose;
    servo::ServoTuning tuning;
    const servo::GuidancePath* guidance = nullptr;  // null: this hand is never guided
    Vec3 target_m{0.0};                             // for the simulated hand, device frame
    std::shared_ptr<servo::HandBodyServo> engine;   // its access to the movable things; null: nothing is movable
};

}  // namespace handrail::core
