#include "app/core/workspace_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "haptic/servo/workspace_mover.h"

namespace handrail {
namespace {

constexpr double kLeast = 1.0, kMost = 500.0;  // as workspace.scale

// Whole metres from ten on, below to the decimetre.
std::string metres(double length_m) {
    const double rounded = length_m < 9.95 ? std::round(length_m * 10.0) / 10.0 : std::round(length_m);
    return fmt::format("{:g} {}", rounded, rounded == 1.0 ? "metre" : "metres");
}

}  // namespace

std::string_view name_of(NamedScale scale) {
    switch (scale) {
        case NamedScale::Building:
            return "Building";
        case NamedScale::Floor:
            return "Floor";
        case NamedScale::Room:
            return "Room";
        case NamedScale::Detail:
            return "Detail";
    }
    return "";
}

double world_m_per_hand_m(NamedScale scale, const Aabb& bounds_m, double reach_hand_m) {
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
    return std::clamp(0.5 * std::hypot(size.x, size.y) / (kRimFrom * reach_hand_m), kLeast, kMost);
}

std::string scale_sentence(NamedScale scale, double world_m_per_hand_m, double reach_hand_m, const DistanceWords& how) {
    const double width_m = 2.0 * reach_hand_m * world_m_per_hand_m;
    std::string text = fmt::format("{}, {} wide", name_of(scale), metres(width_m));
    if (how.in_steps) text += ", " + distance_words(width_m, how);
    return text;
}

double ball_radius_m(const Scene& scene, double felt_diameter_m, double world_m_per_hand_m) {
    double radius = 0.5 * std::clamp(felt_diameter_m * 60.0 / world_m_per_hand_m, 0.002, 0.006) * world_m_per_hand_m;
    for (const Feature& feature : scene.features)
        if (feature.kind == FeatureKind::Door) {
            const Vec3 size = feature.bounds_m.size_m();
            radius = std::min(radius, std::max(size.x, size.y) / 6.0);
        }
    return radius;
}

}  // namespace handrail
