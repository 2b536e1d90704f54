// Holding a thing by a device's hand: by its button, or by the key that uses things while the hand touches one. The
// servo holds it; here it is asked for, and told what is held, let go and too heavy. App thread only.
#pragma once

#include <array>
#include <cstdint>

#include "app/core/context/session_part.h"
#include "haptic/render/dynamics_scene.h"

namespace handrail {

class HandGrip : SessionPart {
public:
    // It tells the servos by `hands`.
    HandGrip(const SessionContext& context, HandsState& hands) : SessionPart(context), hands_(hands) {}

    void enter_world();
    // Taking hold of what a hand touches, letting go, turning by quarters. False: it is another's.
    bool act(Command command, const DynamicsScene& scene, double now_s);
    void tick(const DynamicsScene& scene, double now_s);
    // The hand's; kNoBody: nothing. 0: the only or right hand, 1: the left one.
    std::uint32_t held(std::size_t which) const { return sides_[which].held; }

private:
    struct Side {
        std::uint32_t held = kNoBody, heavies = 0;
        bool heavies_known = false;
        double asked_s = -1e9;
    };
    const ToolState& tool(std::size_t which) const { return which == 0 ? hands_.tool : hands_.left_tool; }
    BodyTuning& tuning(std::size_t which) { return which == 0 ? hands_.tuning.bodies : hands_.left_bodies; }
    void told_held(const DynamicsScene& scene, std::uint32_t body, double now_s);

    HandsState& hands_;
    std::array<Side, 2> sides_;
    bool gain_told_ = false;
};

}  // namespace handrail
