// Defines the settings for the physics engines of a session, which makes one engine for each world with movable things.
// They are plain data, set once.
#pragma once

#include <functional>
#include <memory>

#include "haptic/dynamics/body_engine.h"
#include "haptic/dynamics/engine_recording.h"
#include "worlds/base/clock.h"

namespace handrail::core {

struct BodyEngines {
    // The session's clock, which outlives the engines. With a clock, each engine runs on its own thread. If `clock` is
    // null, each tick of the session steps the engine.
    Clock* clock = nullptr;
    // Records every step of the engines, and outlives the session. If null, nothing is recorded.
    dynamics::EngineRecording* recording = nullptr;
    // Makes an engine that replays a recording from the given time on. If empty, the session makes real engines.
    std::function<std::unique_ptr<dynamics::BodyEngine>(std::shared_ptr<const render::DynamicsScene> scene,
                                                        double begin_s)>
        played;
};

}  // namespace handrail::core
