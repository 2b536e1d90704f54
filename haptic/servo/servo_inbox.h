// The inputs that the owner of a session gives to a servo. ServoLoop takes them on its own thread, or when its owner
// steps it. PlayedServo numbers them, to replay a recording. Call from the app thread.
#pragma once

#include <memory>

#include "haptic/servo/hand_body_servo.h"
#include "haptic/servo/servo_tick.h"

namespace handrail::servo {

class ServoInbox {
public:
    virtual ~ServoInbox() = default;
    // Takes effect from the next tick on. scene: null for none. engine: this hand's side of the free bodies; null:
    // there are none. No two servos may use the same engine at the same time.
    virtual void set_scene(std::shared_ptr<const render::HapticScene> scene, std::shared_ptr<HandBodyServo> engine) = 0;
    // The scene of the desk; see servo_tick. Null: there is none.
    virtual void set_desk(std::shared_ptr<const render::HapticScene> desk) = 0;
    virtual void set_tuning(const ServoTuning& tuning) = 0;
    virtual void set_pose(const WorkspacePose& pose) = 0;
    virtual void set_bodies(const BodyFrame& bodies) = 0;
    virtual void set_guidance(const GuidancePath& guidance) = 0;
};

}  // namespace handrail::servo
