#include "app/core/context/workspace_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "haptic/servo/workspace_mover.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kLeast = 1.0, kMost = 500.0;  // limits of the setting workspace.scale

// Returns the length in words: whole metres from 10 m on, otherwise rounded to decimetres.
std::string metres(double length_m) {
    return phrase("words.metres",
                  {{"metres", length_m < 9.95 ? std::round(length_m * 10.0) / 10.0 : std::round(length_m)}});
}

}  // namespace

std::string name_of(NamedScale scale) {
    constexpr std::array kNames{"session.scale_building", "session.scale_floor", "session.scale_room",
                                "session.scale_detail"};  // keys of the texts, in the order of NamedScale
    return phrase(kNames.at(static_cast<std::size_t>(scale)));
}

double world_m_per_hand_m(NamedScale scale, const Aabb& bounds_m, double reach_hand_m) {
    contract_pre(reach_hand_m > 0.0);
    switch (scale) {
        case NamedScale::Floor:
            return 120.0;
        case NamedScale::Detail:
            return 15.0;
        case NamedScale::Room:
            return 60.0;
        case NamedScale::Building:
            break;
    }
    if (bounds_m.empty() || !(reach_hand_m > 0.0)) return 120.0;
    const Vec3 size = bounds_m.size_m();
    return std::clamp(0.5 * std::hypot(size.x, size.y) / (servo::kRimFrom * reach_hand_m), kLeast, kMost);
}

std::string scale_sentence(NamedScale scale, double world_m_per_hand_m, double reach_hand_m, const DistanceWords& how) {
    const double width_m = 2.0 * reach_hand_m * world_m_per_hand_m;
    const std::string text = phrase("session.scale_wide", {{"scale", name_of(scale)}, {"metres", metres(width_m)}});
    return how.in_steps ? joined(text, distance_words(width_m, how)) : text;
}

double proxy_radius_m(const Scene& scene, double felt_diameter_m, double world_m_per_hand_m,
                      const compile::Simplification& plan) {
    contract_pre(felt_diameter_m > 0.0 && world_m_per_hand_m > 0.0);
    double radius = 0.5 * std::clamp(felt_diameter_m * 60.0 / world_m_per_hand_m, 0.002, 0.006) * world_m_per_hand_m;
    for (std::uint32_t i = 0; i < scene.features.size(); ++i)
        if (scene.features[i].kind == FeatureKind::Door) {
            const Vec3 size = scene.features[i].bounds_m.size_m();
            const compile::NarrowOpening* widened = plan.of_door(FeatureId{i});
            radius = std::min(radius, std::max(size.x, size.y) * (widened ? widened->times() : 1.0) / 6.0);
        }
    return radius;
}

}  // namespace handrail::core
