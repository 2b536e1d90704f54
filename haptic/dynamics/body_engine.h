// The engine of what is free to move in one world, as the session and the hands know it: what they ask of it, and what
// it tells. Dynamics lies behind it, in a loop of its own (DynamicsLoop) or as a recording had it (PlayedEngine).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "haptic/render/hand_channel.h"

namespace handrail {

class BodyEngine {
public:
    // What the app asks for, in its order.
    struct Order {
        enum class Kind : std::uint8_t { Restart, Lead, LetGo, Walker, Shove };
        Kind kind = Kind::Restart;
        std::uint32_t body = kNoBody;
        Vec3 at_m{0.0};  // Lead: where to; Walker: the feet
        double most_n = 0.0;
        Rotation turn{};
        Vec3 speed_m_per_s{0.0};                // Shove
        double for_s = 0.0;                     // Shove
        double radius_m = 0.0, height_m = 0.0;  // Walker; a height of 0: nobody
    };
    // Where every driven thing is; index as DynamicsScene::driven. Made and freed off the servo thread.
    using DrivenPoses = std::shared_ptr<const std::vector<BodyPose>>;

    BodyEngine() = default;
    virtual ~BodyEngine() = default;
    BodyEngine(const BodyEngine&) = delete;
    BodyEngine& operator=(const BodyEngine&) = delete;

    // For the servo of a hand, 0 or 1; whoever takes it may keep it beyond the engine's end.
    virtual std::shared_ptr<HandChannel> hand(unsigned which) const = 0;

    // App thread. False: the engine has too much to do already, and nothing was asked.
    virtual bool order(const Order& order) = 0;
    virtual void drive(const DrivenPoses& poses) = 0;
    virtual bool newer_frame_for_app() = 0;
    virtual const DynamicsFrame& frame_for_app() const = 0;
    // What can be heard, in order; false: no more for now. When nobody takes them the oldest stay.
    virtual bool take_event(BodyEvent& event) = 0;
};

}  // namespace handrail
