// Declares the inputs that the owner of a session passes to a servo. ServoLoop processes them on its own thread, or
// when its owner steps it. PlayedServo numbers them in order to replay a recording. Call these functions from the app
// thread.
#pragma once

#include <memory>

#include "haptic/servo/hand_body_servo.h"
#include "haptic/servo/servo_tick.h"

namespace handrail::servo {

class ServoInbox {
public:
    virtual ~ServoInbox() = default;
    // Sets the scene from the next tick on; null: none. `engine` is this hand's data for the free bodies; null: there
    // are no free bodies. Two servos must never use the same `engine` at the same time.
    virtual void set_scene(std::shared_ptr<const render::HapticScene> scene, std::shared_ptr<HandBodyServo> engine) = 0;
    // Sets the scene of the desk (see servo_tick); null: none.
    virtual void set_desk(std::shared_ptr<const render::HapticScene> desk) = 0;
    virtual void set_tuning(const ServoTuning& tuning) = 0;
    virtual void set_pose(const WorkspacePose& pose) = 0;
    virtual void set_bodies(const BodyFrame& bodies) = 0;
    virtual void set_guidance(const GuidancePath& guidance) = 0;
};

}  // namespace handrail::servo
