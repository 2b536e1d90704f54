// What a servo is given by whoever drives a session. ServoLoop takes it on its own thread or stepped by its owner;
// PlayedServo numbers it, to compute a recording again. Calls on the app thread.
#pragma once

#include <memory>

#include "haptic/servo/hand_engine.h"
#include "haptic/servo/servo_tick.h"

namespace handrail {

class ServoInbox {
public:
    virtual ~ServoInbox() = default;
    // Felt from the next tick on. A null scene is none. engine: this hand's side of the bodies that can move; null:
    // there are none. No other servo has the same engine at the same time.
    virtual void set_scene(std::shared_ptr<const HapticScene> scene, std::shared_ptr<HandEngine> engine) = 0;
    // The desk: see servo_tick. Null: there is none.
    virtual void set_desk(std::shared_ptr<const HapticScene> desk) = 0;
    virtual void set_tuning(const ServoTuning& tuning) = 0;
    virtual void set_pose(const WorkspacePose& pose) = 0;
    virtual void set_bodies(const BodyFrame& bodies) = 0;
    virtual void set_guidance(const GuidancePath& guidance) = 0;
};

}  // namespace handrail
