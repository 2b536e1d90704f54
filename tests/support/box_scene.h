// Makes scenes of axis-aligned boxes and ramps, in metres, for tests that need no file. Every box has its own named
// feature.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/support/names.h"
#include "worlds/scene/scene.h"

namespace handrail::test {

class SceneBuilder {
public:
    SceneBuilder();
    // Adds a box between two corners and returns its feature. `material` is a name in the material library, or empty.
    FeatureId box(const Vec3& min_m, const Vec3& max_m, const std::string& name = "block",
                  SolidRole role = SolidRole::Solid, const std::string& material = {},
                  FeatureKind kind = FeatureKind::Object);
    // Adds an upright prism over a convex outline, whose corners run counter-clockwise as seen from above.
    FeatureId prism(const std::vector<Vec2>& outline_m, double low_m, double high_m, const std::string& name = "block");
    // Adds a ramp over [min, max] whose top rises from min.z in the south to max.z in the north.
    FeatureId ramp(const Vec3& min_m, const Vec3& max_m, const std::string& name = "ramp");
    void start(const Vec3& feet_m, double heading_rad);
    Scene& scene() { return scene_; }
    std::shared_ptr<const Scene> share() const;

private:
    FeatureId add(ConvexSolid shape, const std::string& name, SolidRole role, const std::string& material,
                  FeatureKind kind);
    Scene scene_;
};

}  // namespace handrail::test
