// The way out for a hand that is inside something: the nearest place where the ball fits. A search over growing shells,
// for a command and not for the servo tick: up to some milliseconds. Pure function of its arguments; any thread; never
// allocates in proportion to the scene.
#pragma once

#include <optional>
#include <span>

#include "haptic/render/haptic_scene.h"

namespace handrail {

// Signed distance from a world place to the nearest obstacle, bodies included, negative inside a solid; `far_m` where
// nothing is nearer than that. Names the obstacle's feature, the deepest of several.
struct Surrounding {
    double distance_m = 0.0;
    FeatureId feature = kNoFeature;
};
Surrounding surrounding_of(const HapticScene& scene, std::span<const BodyPose> bodies, const Vec3& at_m, double far_m);

// The place nearest to `from_m`, to within a tenth of the clearance in the directions that were tried, that is at least
// clearance_m (> 0) away from every obstacle; `from_m` itself where it is so. Nothing within farthest_m: none. bodies:
// poses in the scene's order, or empty for the scene's own.
std::optional<Vec3> nearest_free_place(const HapticScene& scene, std::span<const BodyPose> bodies, const Vec3& from_m,
                                       double clearance_m, double farthest_m);

}  // namespace handrail
