// Computes the forces of liquids on the hand: drag at the proxy, buoyancy and a surface film at the hand, and a current
// that pushes the hand. The drag pulls a point behind the hand by a spring, and the point yields as fast as the liquid
// permits (a Maxwell element). No speed is measured, and the steady force is exactly viscosity times hand speed at
// every tick length. Buoyancy and film are potentials of the depth below the open surface. TouchState owns LiquidState;
// one thread; fixed size, noexcept, never allocates.
#pragma once

#include <array>

#include "haptic/render/effects.h"

namespace handrail::render {

class LiquidState {
public:
    void reset() noexcept;
    // Returns the force on the hand. `proxy_local_m` is the centre of the proxy in the scene's own coordinates. Sets
    // `in` to the volume that contains the proxy. If several volumes contain it, `in` is the last one listed.
    Vec3 force_n(const HapticScene& scene, const HandMotion& hand, const Vec3& proxy_local_m, FeatureId& in) noexcept;
    // Returns true, at little cost, if the proxy is still near the place where the last search found no liquid.
    // force_n() would then find no liquid and change nothing. May return false even if force_n() would find none.
    bool surely_dry(const HapticScene& scene, const Vec3& proxy_local_m, double scale) const noexcept {
        const Vec3 way = proxy_local_m - looked_from_m_;
        const double free = nearest_m_ - kImmersion_hand_m * scale;
        return free > 0.0 && glm::dot(way, way) < free * free && looked_generation_ == scene.generation &&
               !scene.liquid_surfaces;
    }

private:
    // Half the depth over which the force of a liquid rises below its surface.
    static constexpr double kImmersion_hand_m = 0.01;
    // Greatest number of volumes whose buoyancy can rise, act or fade at once.
    static constexpr std::size_t kMostFloats = 8;
    struct Float {
        std::uint32_t volume = 0;
        double gate = 0.0;  // rises over 100 ms while the proxy is in the pool, and falls while it is outside
    };

    Vec3 drag_n(const HapticScene& scene, const HandMotion& hand, const Vec3& proxy_local_m, FeatureId& in) noexcept;
    Vec3 surface_n(const HapticScene& scene, const HandMotion& hand, const Vec3& proxy_local_m) noexcept;

    Vec3 drag_offset_hand_m_{0.0};  // position of the dragged point relative to the hand; zero if no liquid is near
    // In the scene with generation looked_generation_, no liquid is nearer to looked_from_m_ than nearest_m_.
    Vec3 looked_from_m_{0.0};
    double nearest_m_ = 0.0;
    std::uint32_t looked_generation_ = 0;
    std::array<Float, kMostFloats> floats_{};
    std::size_t float_count_ = 0;
    std::uint32_t world_ = 0;  // the world that floats_ belongs to, and its number of liquids
    std::size_t liquids_ = 0;
};

}  // namespace handrail::render
