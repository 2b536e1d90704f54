// What a tick of the session has for the servo of one hand, beside what both have in common (the world as it is felt,
// and where its bodies are). Plain data; app thread only.
#pragma once

#include <memory>

#include "haptic/servo/servo_tick.h"

namespace handrail {

struct HandOutput {
    WorkspacePose pose;
    ServoTuning tuning;
    const GuidancePath* guidance = nullptr;  // null: this hand is never led
    Vec3 target_m{0.0};                      // of the simulated hand, device frame
    std::shared_ptr<HandEngine> engine;      // its side of what is free to move; null: nothing is
};

}  // namespace handrail
