// Defines what a tick of the session sends to the servo of one hand. The rendered world and the positions of its bodies
// are not included, because both hands share them. Plain data for the app thread only.
#pragma once

#include <memory>

#include "haptic/servo/servo_tick.h"

namespace handrail::core {

struct HandOutput {
    servo::WorkspacePose pose;
    servo::ServoTuning tuning;
    const servo::GuidancePath* guidance = nullptr;  // null: this hand is not guided
    Vec3 target_m{0.0};                             // target of the simulated hand in the device frame
    // The hand's access to the movable things; null: nothing in the world is movable.
    std::shared_ptr<servo::HandBodyServo> engine;
};

}  // namespace handrail::core
