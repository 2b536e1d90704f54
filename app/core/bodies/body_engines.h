// How a session makes the physics engine of each world with movable things. Plain data, set once.
#pragma once

#include <functional>
#include <memory>

#include "haptic/dynamics/body_engine.h"
#include "haptic/dynamics/engine_recording.h"
#include "worlds/base/clock.h"

namespace handrail::core {

struct BodyEngines {
    // With a clock, each engine runs on its own thread. It is the session's clock and outlives the engines. Null: each
    // tick steps the engine.
    Clock* clock = nullptr;
    // Records every step of the engines, and outlives the session; null: no recording.
    dynamics::EngineRecording* recording = nullptr;
    // Makes an engine that replays a recording from that moment on. Empty: real engines.
    std::function<std::unique_ptr<dynamics::BodyEngine>(std::shared_ptr<const render::DynamicsScene> scene,
                                                        double begin_s)>
        played;
};

}  // namespace handrail::core
