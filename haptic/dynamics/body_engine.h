// The engine of the free bodies of one world, as the session and the hands see it: their requests to it, and its
// messages to them. Behind it is Dynamics in its own loop (DynamicsLoop), or a recording (PlayedEngine).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "haptic/render/hand_channel.h"

namespace handrail::dynamics {

class BodyEngine {
public:
    // A request of the app, carried out in the app's order.
    struct Order {
        enum class Kind : std::uint8_t { Restart, Lead, LetGo, Walker, Shove };
        Kind kind = Kind::Restart;
        std::uint32_t body = render::kNoBody;
        Vec3 at_m{0.0};  // Lead: the target; Walker: position of the feet
        double most_n = 0.0;
        Rotation turn{};
        Vec3 speed_m_per_s{0.0};                // for Shove
        double for_s = 0.0;                     // for Shove
        double radius_m = 0.0, height_m = 0.0;  // for Walker; a height of 0: no walker
    };
    // Poses of all driven things; index as in DynamicsScene::driven. Allocated and freed off the servo thread.
    using DrivenPoses = std::shared_ptr<const std::vector<render::BodyPose>>;

    BodyEngine() = default;
    virtual ~BodyEngine() = default;
    BodyEngine(const BodyEngine&) = delete;
    BodyEngine& operator=(const BodyEngine&) = delete;

    // The channel for the servo of hand 0 or 1; its user may keep it beyond the engine's end.
    virtual std::shared_ptr<render::HandChannel> hand(unsigned which) const = 0;

    // App thread. Returns false if the engine's queue is full; the request is then dropped.
    virtual bool order(const Order& order) = 0;
    virtual void drive(const DrivenPoses& poses) = 0;
    virtual bool newer_frame_for_app() = 0;
    virtual const render::DynamicsFrame& frame_for_app() const = 0;
    // Takes the next sound event, in order; returns false if there is none at the moment. If nobody takes them, the
    // oldest stay and newer ones are dropped.
    virtual bool take_event(render::BodyEvent& event) = 0;
};

}  // namespace handrail::dynamics
