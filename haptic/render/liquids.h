// The forces of liquids on the hand: drag at the proxy; buoyancy and a surface film at the hand; a stream that carries
// it. Drag is a point pulled behind the hand by a spring, which yields as fast as the liquid allows (a Maxwell
// element). No speed is measured, and the steady force is exactly viscosity times hand speed at every tick length.
// Buoyancy and film are potentials of the depth below the open surface. Owned by TouchState, one thread; fixed size,
// noexcept, never allocates.
#pragma once

#include <array>

#include "haptic/render/effects.h"

namespace handrail::render {

class LiquidState {
public:
    void reset() noexcept;
    // ball_local_m: centre of the proxy in the scene's own coordinates. `in`: the volume that contains the proxy; where
    // volumes overlap, the last one listed.
    Vec3 force_n(const HapticScene& scene, const HandMotion& hand, const Vec3& ball_local_m, FeatureId& in) noexcept;
    // Returns true, at little cost, if force_n would find and change nothing: the proxy is still where the last look
    // found no liquid near. May miss such cases.
    bool surely_dry(const HapticScene& scene, const Vec3& ball_local_m, double scale) const noexcept {
        const Vec3 way = ball_local_m - looked_from_m_;
        const double free = nearest_m_ - kImmersion_hand_m * scale;
        return free > 0.0 && glm::dot(way, way) < free * free && looked_generation_ == scene.generation &&
               !scene.liquid_surfaces;
    }

private:
    // Half the depth over which the force of a liquid sets in at its surface.
    static constexpr double kImmersion_hand_m = 0.01;
    static constexpr std::size_t kMostFloats = 8;  // most volumes at once whose buoyancy rises, holds or fades
    struct Float {
        std::uint32_t volume = 0;
        double gate = 0.0;  // rises over 100 ms while the proxy is in the pool, falls while it is not
    };

    Vec3 drag_n(const HapticScene& scene, const HandMotion& hand, const Vec3& ball_local_m, FeatureId& in) noexcept;
    Vec3 surface_n(const HapticScene& scene, const HandMotion& hand, const Vec3& ball_local_m) noexcept;

    Vec3 drag_offset_hand_m_{0.0};  // dragged point minus hand; zero if no liquid is near
    Vec3 looked_from_m_{0.0};       // no liquid of the scene looked_generation_ is nearer to this place than nearest_m_
    double nearest_m_ = 0.0;
    std::uint32_t looked_generation_ = 0;
    std::array<Float, kMostFloats> floats_{};
    std::size_t float_count_ = 0;
    std::uint32_t world_ = 0;  // the world that the floats belong to, and how many liquids it had
    std::size_t liquids_ = 0;
};

}  // namespace handrail::render
