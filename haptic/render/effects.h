// Computes the force of effect volumes on the hand in each tick. Evaluated at the hand's own position, never at the
// proxy's. A potential thus stays a potential while a wall holds the proxy. Owned by TouchState, one thread; fixed
// size, noexcept, never allocates. Costs about 150 ns for each effect that the hand is in, nothing outside all effects.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "haptic/render/haptic_scene.h"

namespace handrail::render {

// How a hand moved since the last tick, for liquids, soft patches and effects.
struct HandMotion {
    Vec3 goal_m{0.0};  // world
    Vec3 step_m{0.0};  // hand metres, through the world
    double dt_s = 1e-3;
    double scale = 1.0;                // world metres per hand metre
    double stiffest_n_per_m = 1000.0;  // of the device: all effects at one place together stay below it
    bool held = true;                  // false: nobody holds the device, so no effect may drive it
    // Poses of the scene's bodies; null, or no entry for a body: the pose that the scene has.
    const BodyPoses* bodies = nullptr;
};

// Limit for the force of all liquids, soft patches and effects together; a larger vector is scaled down.
constexpr double kLargestEffect_n = 4.0;

class EffectState {
public:
    // Most effects that act at once. If there are more, the first ones in the table act and `truncated` is set.
    static constexpr std::size_t kMostActive = 16;

    // Releases what was stuck and stops what was swinging: after a jump, a fault or in another scene.
    void reset() noexcept;
    // Returns the force on the hand, world axes.
    Vec3 force_n(const HapticScene& scene, const HandMotion& hand) noexcept;
    bool truncated() const noexcept { return truncated_; }

private:
    struct Slot {
        std::uint32_t effect = EffectVolume::kNoBody;
        bool fresh = true;
        bool slipping = false;
        double time_s = 0.0;      // since the hand entered
        double turns = 0.0;       // phase of a vibration
        Vec3 last_m{0.0};         // last position of the hand, in the frame of the body that the effect is attached to
        Vec3 offset_hand_m{0.0};  // inner point minus hand
        Vec3 speed_hand_m_per_s{0.0};  // speed of the inner point
    };

    Slot& slot_of(std::uint32_t effect) noexcept;
    Vec3 one_force(const EffectVolume& effect, Slot& slot, const Vec3& at_m, const HandMotion& hand) noexcept;

    std::array<Slot, kMostActive> slots_{};
    std::size_t used_ = 0;
    std::uint32_t world_ = 0;  // the world that the slots belong to, and how many effects it had
    std::size_t effects_ = 0;
    bool truncated_ = false;
};

}  // namespace handrail::render
