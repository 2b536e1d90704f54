// Finds the nearest place where the proxy fits, for a hand that is inside an obstacle. The search examines growing
// shells and takes up to a few milliseconds, so it is for a command of the person and not for the servo tick. Pure
// function of its arguments; any thread; it allocates the same however large the scene is.
#pragma once

#include <optional>
#include <span>

#include "haptic/render/haptic_scene.h"

namespace handrail::render {

// Signed distance from a place in the world to the nearest obstacle, bodies included. It is negative inside a solid,
// and `far_m` if no obstacle is nearer than that. The feature is that of this obstacle, or of the solid that contains
// the place most deeply.
struct Surrounding {
    double distance_m = 0.0;
    FeatureId feature = kNoFeature;
};
Surrounding surrounding_of(const HapticScene& scene, std::span<const BodyPose> bodies, const Vec3& at_m, double far_m);

// Returns the place nearest to `from_m` that is at least `clearance_m` (> 0) away from every obstacle. If `from_m`
// itself is free, returns `from_m`. The search tries a fixed set of directions and is accurate to a tenth of the
// clearance in each direction. Returns nothing if there is no such place within `farthest_m`. `bodies` are poses in the
// scene's order; if empty, each body has its pose from the scene.
std::optional<Vec3> nearest_free_place(const HapticScene& scene, std::span<const BodyPose> bodies, const Vec3& from_m,
                                       double clearance_m, double farthest_m);

}  // namespace handrail::render
