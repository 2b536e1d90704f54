#include "haptic/render/liquids.h"

#include <limits>

#include "haptic/render/tick_math.h"

namespace handrail::render {
namespace {

constexpr double kDrag_n_per_m = 400.0;
constexpr double kLargestDrag_n = 4.0;
// Limit of the drag in a flowing liquid. A current is a source of energy, and its power stays below kLargestFlow_n
// times its speed.
constexpr double kLargestFlow_n = 2.0;
constexpr double kRounding_m = 1e-9;
constexpr double kLook_hand_m = 0.1;    // distance, beyond the reach of their forces, within which liquids are searched
constexpr double kFilm_hand_m = 0.004;  // half the thickness of the surface film
// Greatest value of the film's force F = (2 A / w) y exp(-y^2), in units of A / w. It converts the film's greatest
// force, as given in the world file, to A.
constexpr double kFilmSteepest = 0.857763884960707;
constexpr double kFloatRamp_s = 0.100;

// Returns how deep a point is below the surface of a liquid, measured to its exposed faces if it has any; negative
// outside. Sets `all` to a lower bound for the distance of a point outside the volume; zero or negative inside.
double depth_in(const LiquidVolume& liquid, const Vec3& local_m, double& all) noexcept {
    double exposed = -std::numeric_limits<double>::infinity();
    all = exposed;
    for (std::size_t i = 0; i < liquid.planes.size(); ++i) {
        const double out = signed_distance(liquid.planes[i], local_m);
        all = std::max(all, out);
        if (!liquid.hidden[i]) exposed = std::max(exposed, out);
    }
    // Behind a covered face there is no liquid, however deep the point is below the exposed faces.
    const bool any_exposed = exposed > -std::numeric_limits<double>::infinity();
    return any_exposed && all <= 0.0 ? -exposed : -all;
}

// The properties of all volumes within reach of the proxy, weighted by the volumes' shares.
struct Bath {
    double viscosity_ns_per_m = 0.0;
    double weakest_share = 1.0;  // share of the drag's stiffness that is permitted, because other effects act as well
    Vec3 flow_hand_m_per_s{0.0};
};

}  // namespace

void LiquidState::reset() noexcept {
    drag_offset_hand_m_ = Vec3(0.0);
    float_count_ = 0;
}

Vec3 LiquidState::drag_n(const HapticScene& scene, const HandMotion& hand, const Vec3& at, FeatureId& in) noexcept {
    const double reach = kImmersion_hand_m * hand.scale;
    // Overlapping volumes are weighted in reverse order of the list. Where one of them thins out towards its own
    // surface, the next volume gets the remaining weight, so that neighbouring volumes form one pool.
    constexpr std::size_t kMost = 8;
    struct Immersed {
        std::uint32_t volume;
        double share;
    };
    std::array<Immersed, kMost> immersed;
    std::size_t count = 0;
    std::uint32_t inside_of = 0;
    bool inside_any = false;
    looked_from_m_ = at;
    looked_generation_ = scene.generation;
    nearest_m_ = reach + kLook_hand_m * hand.scale;
    scene.liquid_bvh.within(at, nearest_m_, [&](std::uint32_t item, double&) {
        double out = 0.0;
        const double depth = depth_in(scene.liquids[item], at, out);
        nearest_m_ = std::min(nearest_m_, out - kRounding_m);
        if (out <= 0.0 && (!inside_any || item > inside_of)) {
            inside_any = true;
            inside_of = item;
        }
        const double share = smooth_step((depth + reach) / (2.0 * reach));
        if (share <= 0.0 || count == kMost) return;
        std::size_t place = count++;
        for (; place > 0 && immersed[place - 1].volume < item; --place) immersed[place] = immersed[place - 1];
        immersed[place] = {item, share};
    });
    if (inside_any) in = scene.liquids[inside_of].feature;
    double left = 1.0;
    Bath bath;
    for (std::size_t i = 0; i < count; ++i) {
        const LiquidVolume& liquid = scene.liquids[immersed[i].volume];
        const double share = std::min(left, immersed[i].share);
        bath.viscosity_ns_per_m += share * liquid.viscosity_ns_per_m;
        bath.flow_hand_m_per_s += liquid.flow_hand_m_per_s * share;
        if (liquid.crowd_stiffness_n_per_m > hand.stiffest_n_per_m)
            bath.weakest_share = std::min(bath.weakest_share, hand.stiffest_n_per_m / liquid.crowd_stiffness_n_per_m);
        left -= share;
    }
    if (bath.viscosity_ns_per_m <= 0.0) {
        drag_offset_hand_m_ = Vec3(0.0);
        return Vec3(0.0);
    }
    // The dragged point moves by p <- p + (x - p) a with a = u / (1 + u), u = K T / c. With this a, unlike 1 - exp(-u),
    // the steady force is exactly c v. The point moves only along its own force, so the liquid never gives energy. A
    // current moves the point in addition.
    const bool flows = hand.held && bath.flow_hand_m_per_s != Vec3(0.0);
    const double stiffness = kDrag_n_per_m * bath.weakest_share;
    const double u = stiffness * hand.dt_s / bath.viscosity_ns_per_m;
    Vec3 offset = drag_offset_hand_m_ - hand.step_m;
    if (flows) offset += bath.flow_hand_m_per_s * hand.dt_s;
    drag_offset_hand_m_ = shortened(offset * (1.0 / (1.0 + u)), (flows ? kLargestFlow_n : kLargestDrag_n) / stiffness);
    return drag_offset_hand_m_ * stiffness;
}

Vec3 LiquidState::surface_n(const HapticScene& scene, const HandMotion& hand, const Vec3& proxy_local_m) noexcept {
    const double a = kImmersion_hand_m * hand.scale;
    const Vec3 goal = hand.goal_m - scene.origin_m;

    // A pool lifts the hand only while the proxy is in the pool or just above it. The hand alone cannot decide this: it
    // may be deep in the pool's wall or next to the pool.
    const auto carries = [&](const LiquidVolume& liquid) {
        for (std::size_t i = 0; i < liquid.planes.size(); ++i)
            if (signed_distance(liquid.planes[i], proxy_local_m) >
                (static_cast<int>(i) == liquid.surface ? 2.0 * a : 0.0))
                return false;
        return true;
    };
    for (std::size_t k = float_count_; k-- > 0;) {
        if (carries(scene.liquids[floats_[k].volume])) continue;
        floats_[k].gate -= hand.dt_s / kFloatRamp_s;
        if (floats_[k].gate <= 0.0) floats_[k] = floats_[--float_count_];
    }
    Vec3 force(0.0);
    scene.liquid_bvh.within(proxy_local_m, 2.0 * a, [&](std::uint32_t item, double&) {
        const LiquidVolume& liquid = scene.liquids[item];
        if (liquid.surface < 0 || liquid.buoyancy_n <= 0.0 || !carries(liquid)) return;
        std::size_t k = 0;
        while (k < float_count_ && floats_[k].volume != item) ++k;
        if (k == kMostFloats) return;
        if (k == float_count_) floats_[float_count_++] = {item, 0.0};
        // A hand that comes from above feels no buoyancy yet, so the gate may open at once. The work that the hand does
        // on its way down comes back on its way up. Anywhere else, the gate opens gradually.
        const double depth = -signed_distance(liquid.planes[static_cast<std::size_t>(liquid.surface)], goal);
        floats_[k].gate = depth <= -a ? 1.0 : std::min(1.0, floats_[k].gate + hand.dt_s / kFloatRamp_s);
    });
    for (std::size_t k = 0; k < float_count_; ++k) {
        const LiquidVolume& liquid = scene.liquids[floats_[k].volume];
        const Plane& surface = liquid.planes[static_cast<std::size_t>(liquid.surface)];
        const double depth = -signed_distance(surface, goal);
        force += surface.normal * (floats_[k].gate * liquid.buoyancy_n * smooth_step((depth + a) / (2.0 * a)));
    }

    // The film is a potential well that depends on the hand's own position: U = -A W exp(-(h/w)^2), where W fades
    // towards the pool's sides.
    const double w = kFilm_hand_m * hand.scale;
    scene.liquid_bvh.within(goal, 4.0 * w, [&](std::uint32_t item, double&) {
        const LiquidVolume& liquid = scene.liquids[item];
        if (liquid.surface < 0 || liquid.film_n <= 0.0) return;
        const double edge = std::min(a, liquid.inner_radius_m);
        double weight = 1.0;
        Vec3 slope(0.0);  // slope of the weight, per world metre
        for (std::size_t i = 0; i < liquid.planes.size() && weight > 0.0; ++i) {
            const double depth = -signed_distance(liquid.planes[i], goal);
            if (static_cast<int>(i) == liquid.surface || depth >= edge) continue;
            const double s = smooth_step(depth / edge);
            slope = slope * s - liquid.planes[i].normal * (weight * smooth_step_slope(depth / edge) / edge);
            weight *= s;
        }
        if (weight <= 0.0) return;
        const Plane& surface = liquid.planes[static_cast<std::size_t>(liquid.surface)];
        const double y = -signed_distance(surface, goal) / w, bell = exp_minus(y * y);
        const double energy = liquid.film_n * kFilm_hand_m / kFilmSteepest;  // the energy A in the formula above
        force +=
            surface.normal * (energy / kFilm_hand_m * 2.0 * y * bell * weight) + slope * (hand.scale * energy * bell);
    });
    return force;
}

Vec3 LiquidState::force_n(const HapticScene& scene, const HandMotion& hand, const Vec3& proxy_local_m,
                          FeatureId& in) noexcept {
    in = kNoFeature;
    if (scene.liquids.empty() || surely_dry(scene, proxy_local_m, hand.scale)) return Vec3(0.0);
    if (world_ != scene.world || liquids_ != scene.liquids.size()) {
        world_ = scene.world;
        liquids_ = scene.liquids.size();
        float_count_ = 0;
    }
    Vec3 force = drag_n(scene, hand, proxy_local_m, in);
    if (scene.liquid_surfaces) force += surface_n(scene, hand, proxy_local_m);
    return force;
}

}  // namespace handrail::render
