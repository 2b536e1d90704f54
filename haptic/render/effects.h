// Computes the force of effect volumes on the hand in each tick. The laws use the hand's own position, not the proxy's,
// so a potential remains a potential while a wall holds the proxy back. TouchState owns EffectState; one thread; fixed
// size, noexcept, never allocates. Costs about 150 ns for each effect that contains the hand, nothing outside all
// effects.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "haptic/render/haptic_scene.h"

namespace handrail::render {

// The hand's motion since the last tick, used by liquids, soft patches and effects.
struct HandMotion {
    Vec3 goal_m{0.0};  // position of the hand, world
    Vec3 step_m{0.0};  // displacement through the world, hand metres
    double dt_s = 1e-3;
    double scale = 1.0;  // world metres per hand metre
    // The device's greatest stiffness; the effects at one place together stay below it.
    double stiffest_n_per_m = 1000.0;
    bool held = true;  // false: nobody holds the device, so no effect may drive it
    // Poses of the scene's bodies. If it is null or does not contain a body, that body has its start pose from the
    // scene.
    const BodyPoses* bodies = nullptr;
};

// Limit for the combined force of all liquids, soft patches and effects. A larger vector is scaled down to it.
constexpr double kLargestEffect_n = 4.0;

class EffectState {
public:
    // Greatest number of effects that act at once. If the hand is in more, the first ones in the table act and
    // truncated() returns true.
    static constexpr std::size_t kMostActive = 16;

    // Releases held points and stops moving masses. Call it after a jump, after a fault or for another scene.
    void reset() noexcept;
    // Returns the force on the hand, world axes.
    Vec3 force_n(const HapticScene& scene, const HandMotion& hand) noexcept;
    bool truncated() const noexcept { return truncated_; }

private:
    struct Slot {
        std::uint32_t effect = EffectVolume::kNoBody;
        bool fresh = true;
        bool slipping = false;
        double time_s = 0.0;      // time since the hand entered
        double turns = 0.0;       // phase of a vibration, in turns
        Vec3 last_m{0.0};         // last position of the hand, in the frame of the body to which the effect is attached
        Vec3 offset_hand_m{0.0};  // position of the inner point relative to the hand
        Vec3 speed_hand_m_per_s{0.0};  // velocity of the inner point
    };

    Slot& slot_of(std::uint32_t effect) noexcept;
    Vec3 one_force(const EffectVolume& effect, Slot& slot, const Vec3& at_m, const HandMotion& hand) noexcept;

    std::array<Slot, kMostActive> slots_{};
    std::size_t used_ = 0;
    std::uint32_t world_ = 0;  // the world that the slots belong to, and its number of effects
    std::size_t effects_ = 0;
    bool truncated_ = false;
};

}  // namespace handrail::render
