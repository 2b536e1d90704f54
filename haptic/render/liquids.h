// What liquids do to the hand: drag where the ball is, buoyancy and a surface film where the hand is, a stream that
// carries it. Drag is a point pulled behind the hand by a spring, yielding as fast as the liquid lets it (a Maxwell
// element), so no speed is measured and the steady force is viscosity times hand speed, exactly, at every tick length.
// Buoyancy and film are potentials of the depth below the open surface. Owned by TouchState, one thread; fixed size,
// noexcept, never allocates.
#pragma once

#include <array>

#include "haptic/render/effects.h"

namespace handrail {

class LiquidState {
public:
    void reset() noexcept;
    // ball_local_m: in the scene's own coordinates. `in`: the volume that holds the ball, the last one listed where
    // they overlap.
    Vec3 force_n(const HapticScene& scene, const HandMotion& hand, const Vec3& ball_local_m, FeatureId& in) noexcept;
    // True, at little cost, only where force_n would find nothing and change nothing: the ball is still where the last
    // look found no liquid near.
    bool surely_dry(const HapticScene& scene, const Vec3& ball_local_m, double scale) const noexcept {
        const Vec3 way = ball_local_m - looked_from_m_;
        const double free = nearest_m_ - kImmersion_hand_m * scale;
        return free > 0.0 && glm::dot(way, way) < free * free && looked_generation_ == scene.generation &&
               !scene.liquid_surfaces;
    }

private:
    static constexpr double kImmersion_hand_m = 0.01;  // half the depth over which a liquid's surface sets in
    static constexpr std::size_t kMostFloats = 8;      // volumes at once whose buoyancy sets in, holds or fades
    struct Float {
        std::uint32_t volume = 0;
        double gate = 0.0;  // rises over 100 ms where the ball is in the pool, falls where it is not
    };

    Vec3 drag_n(const HapticScene& scene, const HandMotion& hand, const Vec3& ball_local_m, FeatureId& in) noexcept;
    Vec3 surface_n(const HapticScene& scene, const HandMotion& hand, const Vec3& ball_local_m) noexcept;

    Vec3 drag_offset_hand_m_{0.0};  // dragged point minus hand; zero where no liquid is near
    Vec3 looked_from_m_{0.0};       // no liquid of the scene of looked_generation_ is nearer to here than nearest_m_
    double nearest_m_ = 0.0;
    std::uint32_t looked_generation_ = 0;
    std::array<Float, kMostFloats> floats_{};
    std::size_t float_count_ = 0;
    std::uint32_t world_ = 0;  // of the scene that the floats belong to, and how many liquids it had
    std::size_t liquids_ = 0;
};

}  // namespace handrail
