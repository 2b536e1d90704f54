// How the engines of what is free to move are made in a session, one for each world that has such things. Plain data,
// chosen once.
#pragma once

#include <functional>
#include <memory>

#include "haptic/dynamics/body_engine.h"
#include "haptic/dynamics/engine_recording.h"
#include "worlds/base/clock.h"

namespace handrail {

struct BodyEngines {
    // Each has a thread of its own, by this clock, the session's, which outlives it; null: it is stepped in each tick.
    Clock* clock = nullptr;
    // Gets each step of theirs, and outlives the session; null: nothing is kept.
    EngineRecording* recording = nullptr;
    // Makes one that goes on by itself, as a recording had it, from that moment; empty: they are real ones.
    std::function<std::unique_ptr<BodyEngine>(std::shared_ptr<const DynamicsScene> scene, double begin_s)> played;
};

}  // namespace handrail
