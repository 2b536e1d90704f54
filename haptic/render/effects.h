// What effect volumes do to the hand, tick by tick. Evaluated at the hand's own place, never at the ball's: a potential
// then stays one while the ball is held by a wall. Owned by TouchState, one thread; fixed size, noexcept, never
// allocates. About 150 ns for each effect the hand is in, nothing where there is none.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "haptic/render/haptic_scene.h"

namespace handrail {

// How a hand moved since the last tick, for media and effects.
struct HandMotion {
    Vec3 goal_m{0.0};  // world
    Vec3 step_m{0.0};  // hand metres, through the world
    double dt_s = 1e-3;
    double scale = 1.0;                // world metres per hand metre
    double stiffest_n_per_m = 1000.0;  // of the device: all effects at one place stay below it together
    bool held = true;                  // false: nobody holds the device, so nothing may drive it
    // Where the scene's bodies are; null, or left out: they stand as the scene has them.
    const BodyPoses* bodies = nullptr;
};

// All media and effects together push no harder; the vector is scaled.
constexpr double kLargestEffect_n = 4.0;

class EffectState {
public:
    // Effects that act at once; of more the first in the table act and `truncated` is set.
    static constexpr std::size_t kMostActive = 16;

    // What was stuck is loose, what swung hangs still: after a jump, a fault or in another scene.
    void reset() noexcept;
    // On the hand, world axes.
    Vec3 force_n(const HapticScene& scene, const HandMotion& hand) noexcept;
    bool truncated() const noexcept { return truncated_; }

private:
    struct Slot {
        std::uint32_t effect = EffectVolume::kNoBody;
        bool fresh = true;
        bool slipping = false;
        double time_s = 0.0;           // since the hand came in
        double turns = 0.0;            // of a vibration
        Vec3 last_m{0.0};              // where the hand was, in the frame of the body that the effect hangs on
        Vec3 offset_hand_m{0.0};       // inner point minus hand
        Vec3 speed_hand_m_per_s{0.0};  // of the inner point
    };

    Slot& slot_of(std::uint32_t effect) noexcept;
    Vec3 one_force(const EffectVolume& effect, Slot& slot, const Vec3& at_m, const HandMotion& hand) noexcept;

    std::array<Slot, kMostActive> slots_{};
    std::size_t used_ = 0;
    std::uint32_t world_ = 0;  // of the scene that the slots belong to, and how many effects it had
    std::size_t effects_ = 0;
    bool truncated_ = false;
};

}  // namespace handrail
