#include "haptic/render/free_place.h"

#include <algorithm>
#include <cmath>

namespace handrail::render {
namespace {

constexpr int kDirections = 128;
constexpr double kShellGrowth = 1.25;

// Returns point i of a set that is spread evenly over the unit sphere. Source: Gonzalez, Measurement of areas on a
// sphere using Fibonacci and latitude-longitude lattices, 2010.
Vec3 direction(int i) {
    const double golden_turn = kPi * (3.0 - std::sqrt(5.0));
    const double z = 1.0 - 2.0 * (i + 0.5) / kDirections, ring = std::sqrt(1.0 - z * z), angle = golden_turn * i;
    return {ring * std::cos(angle), ring * std::sin(angle), z};
}

void look_in(const HapticScene& shape, const Vec3& own_m, double scale, Surrounding& nearest) {
    shape.obstacle_bvh.within(own_m - shape.origin_m, std::max(0.0, nearest.distance_m) / scale,
                              [&](std::uint32_t item, double&) {
                                  const ClosestPoint found = shape.closest(item, own_m - shape.origin_m);
                                  if (found.distance_m * scale >= nearest.distance_m) return;
                                  nearest = {found.distance_m * scale, shape.surface(item, found.normal).feature};
                              });
}

}  // namespace

Surrounding surrounding_of(const HapticScene& scene, std::span<const BodyPose> bodies, const Vec3& at_m, double far_m) {
    Surrounding nearest{far_m, kNoFeature};
    look_in(scene, at_m, 1.0, nearest);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        const HapticBody& body = scene.bodies[b];
        const BodyPose pose = b < bodies.size() ? bodies[b] : BodyPose{body.start, body.present};
        if (pose.present) look_in(*body.shape, PlacedFrame(pose.at).to_own(at_m), pose.at.scale, nearest);
    }
    return nearest;
}

std::optional<Vec3> nearest_free_place(const HapticScene& scene, std::span<const BodyPose> bodies, const Vec3& from_m,
                                       double clearance_m, double farthest_m) {
    const auto clear = [&](const Vec3& p) {
        return surrounding_of(scene, bodies, p, clearance_m).distance_m >= clearance_m;
    };
    if (clear(from_m)) return from_m;
    double inner = 0.0;
    for (double outer = 0.5 * clearance_m; inner < farthest_m; inner = outer, outer *= kShellGrowth) {
        std::optional<Vec3> best;
        double best_m = std::min(outer, farthest_m);
        for (int i = 0; i < kDirections; ++i) {
            const Vec3 way = direction(i);
            if (!clear(from_m + way * best_m)) continue;
            // Moves the place back towards the start as far as it stays free.
            double blocked = inner, free = best_m;
            while (free - blocked > 0.1 * clearance_m) {
                const double middle = 0.5 * (free + blocked);
                (clear(from_m + way * middle) ? free : blocked) = middle;
            }
            if (best && free >= best_m) continue;
            best = from_m + way * free;
            best_m = free;
        }
        if (best) return best;
    }
    return std::nullopt;
}

}  // namespace handrail::render
