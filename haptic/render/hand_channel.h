// Defines the channel between the engine of the free bodies and the servo of one hand. Each member has one producer and
// one consumer, and neither of them waits, allocates or fails. Both own the channel, so either may end first.
#pragma once

#include "haptic/render/rigid_body_state.h"
#include "worlds/base/latest_value.h"
#include "worlds/base/spsc_ring.h"

namespace handrail::render {

using HandPushRing = SpscRing<HandPush, 64>;

struct HandChannel {
    std::uint32_t engine = 0;          // EngineRow::engine; 0: no recording. Set before the engine and the servo start.
    HandPushRing pushes;               // from servo to engine
    LatestValue<HandPlace> place;      // from servo to engine
    LatestValue<DynamicsFrame> frame;  // from engine to servo
};

}  // namespace handrail::render
