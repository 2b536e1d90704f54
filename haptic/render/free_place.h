// Finds the way out for a hand that is inside an obstacle: the nearest place where the proxy fits. It searches growing
// shells and takes up to a few milliseconds, so it is meant for a command and not for the servo tick. Pure function of
// its arguments; any thread; its allocations do not depend on the size of the scene.
#pragma once

#include <optional>
#include <span>

#include "haptic/render/haptic_scene.h"

namespace handrail::render {

// Signed distance from a world place to the nearest obstacle, bodies included; negative inside a solid. `far_m` if
// nothing is nearer than that. Names the feature of the obstacle, or of the deepest of several.
struct Surrounding {
    double distance_m = 0.0;
    FeatureId feature = kNoFeature;
};
Surrounding surrounding_of(const HapticScene& scene, std::span<const BodyPose> bodies, const Vec3& at_m, double far_m);

// Returns the place nearest to `from_m` that is at least clearance_m (> 0) away from every obstacle; `from_m` itself if
// it is free. Accurate to a tenth of the clearance in the tried directions. Returns nothing if there is no such place
// within farthest_m. bodies: poses in the scene's order, or empty for the scene's own.
std::optional<Vec3> nearest_free_place(const HapticScene& scene, std::span<const BodyPose> bodies, const Vec3& from_m,
                                       double clearance_m, double farthest_m);

}  // namespace handrail::render
