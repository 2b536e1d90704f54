// Lets the hand of a device hold a thing. The person presses the device's button, or the Use key while the hand touches
// the thing. The servo holds the thing. This class sends the servo the request and announces which thing is held,
// released or too heavy. Use it on the app thread only.
#pragma once

#include <array>
#include <cstdint>

#include "app/core/context/session_part.h"
#include "haptic/render/dynamics_scene.h"

namespace handrail::core {

class DeviceGrip : SessionPart {
public:
    // Sends requests to the servos through `hands`.
    DeviceGrip(const SessionContext& context, HandsState& hands) : SessionPart(context), hands_(hands) {}

    void enter_world();
    // Carries out the commands that take hold of the touched thing, release it or turn it by 90 degrees. Returns false
    // if the command belongs to another feature.
    bool act(Command command, const render::DynamicsScene& scene, double now_s);
    void tick(const render::DynamicsScene& scene, double now_s);
    // Returns the body that hand `which` holds, or kNoBody. 0 is the only or right hand, 1 the left hand.
    std::uint32_t held(std::size_t which) const { return sides_[which].held; }

private:
    struct Side {
        std::uint32_t held = render::kNoBody, heavies = 0;
        bool heavies_known = false;
        double requested_s = -1e9;
    };
    const servo::ToolState& tool(std::size_t which) const { return which == 0 ? hands_.tool : hands_.left_tool; }
    servo::BodyTuning& tuning(std::size_t which) { return which == 0 ? hands_.tuning.bodies : hands_.left_bodies; }
    void announce_held(const render::DynamicsScene& scene, std::uint32_t body, double now_s);

    HandsState& hands_;
    std::array<Side, 2> sides_;
    bool gain_announced_ = false;
};

}  // namespace handrail::core
