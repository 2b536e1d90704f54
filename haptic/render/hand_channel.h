// The channel between the engine of movable bodies and the servo of one hand. Each member has one producer and one
// consumer, and neither side waits, allocates or fails. Both sides own it, so either may end first.
#pragma once

#include "haptic/render/rigid_body_state.h"
#include "worlds/base/latest_value.h"
#include "worlds/base/spsc_ring.h"

namespace handrail::render {

using HandPushRing = SpscRing<HandPush, 64>;

struct HandChannel {
    std::uint32_t engine = 0;          // EngineRow::engine; 0: no recording; set before either side begins
    HandPushRing pushes;               // servo to engine
    LatestValue<HandPlace> place;      // servo to engine
    LatestValue<DynamicsFrame> frame;  // engine to servo
};

}  // namespace handrail::render
