// Defines the interface to the engine that moves the free bodies of one world. The session and the servos of the hands
// send it requests and receive its messages. The implementation is Dynamics in its own loop (DynamicsLoop), or a
// recording (PlayedEngine).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "haptic/render/hand_channel.h"

namespace handrail::dynamics {

class BodyEngine {
public:
    // A request of the app. The engine carries out requests in the order in which the app sent them.
    struct Order {
        enum class Kind : std::uint8_t { Restart, Lead, LetGo, Walker, Shove };
        Kind kind = Kind::Restart;
        std::uint32_t body = render::kNoBody;
        Vec3 at_m{0.0};  // for Lead: the target; for Walker: the position of the feet
        double most_n = 0.0;
        Rotation turn{};
        Vec3 speed_m_per_s{0.0};  // for Shove: velocity towards which the walker pushes
        double for_s = 0.0;       // for Shove: duration in seconds
        // For Walker: size of the capsule; a height of 0 means that there is no walker.
        double radius_m = 0.0, height_m = 0.0;
    };
    // Poses of all driven things, with the indices of DynamicsScene::driven. The servo thread neither allocates nor
    // frees them.
    using DrivenPoses = std::shared_ptr<const std::vector<render::BodyPose>>;

    BodyEngine() = default;
    virtual ~BodyEngine() = default;
    BodyEngine(const BodyEngine&) = delete;
    BodyEngine& operator=(const BodyEngine&) = delete;

    // Returns the channel for the servo of hand 0 or 1. The servo may keep the channel after the engine has ended.
    virtual std::shared_ptr<render::HandChannel> hand(unsigned which) const = 0;

    // App thread. Sends a request. Returns false and drops the request if the engine's queue is full.
    virtual bool order(const Order& order) = 0;
    virtual void drive(const DrivenPoses& poses) = 0;
    virtual bool newer_frame_for_app() = 0;
    virtual const render::DynamicsFrame& frame_for_app() const = 0;
    // Removes the oldest sound event from the queue and stores it in `event`. Returns false if there is none at the
    // moment. If the queue is full because nobody calls take_event(), the engine drops newer events.
    virtual bool take_event(render::BodyEvent& event) = 0;
};

}  // namespace handrail::dynamics
