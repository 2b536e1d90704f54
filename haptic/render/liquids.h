// What liquids do to the hand: drag where the ball is, buoyancy and a surface film where the hand is, a stream that carries it.
// Drag is a point pulled behind the hand by a spring, yielding as fast as the liquid lets it (a Maxwell element), so no speed is measured and the
// steady force is viscosity times hand speed, exactly, at every tick length. Buoyancy and film are potentials of the depth below the open surface.
// Owned by TouchState, one thread; fixed size, noexcept, never allocates.
#pragma once

#include <array>

#include "haptic/render/effects.h"

namespace handrail {

class LiquidState {
public:
    void reset() noexcept;
    // ball_local_m: in the scene's own coordinates. `in`: the volume that holds the ball, the last one listed where they overlap.
    Vec3 force_n(const HapticScene& scene, const HandMotion& hand, const Vec3& ball_local_m, FeatureId& in) noexcept;

private:
    static constexpr std::size_t kMostFloats = 8;  // volumes at once whose buoyancy sets in, holds or fades
    struct Float {
        std::uint32_t volume = 0;
        double gate = 0.0;  // rises over 100 ms where the ball is in the pool, falls where it is not
    };

    Vec3 drag_n(const HapticScene& scene, const HandMotion& hand, const Vec3& ball_local_m, FeatureId& in) noexcept;
    Vec3 surface_n(const HapticScene& scene, const HandMotion& hand, const Vec3& ball_local_m) noexcept;

    Vec3 drag_offset_hand_m_{0.0};  // dragged point minus hand
    std::array<Float, kMostFloats> floats_{};
    std::size_t float_count_ = 0;
    std::uint32_t world_ = 0;  // of the scene that the floats belong to, and how many liquids it had
    std::size_t liquids_ = 0;
};

}  // namespace handrail
