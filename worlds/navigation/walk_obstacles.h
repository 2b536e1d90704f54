// Every solid of a scene grown by a body, as planes that upright columns are cut from: where the soles of the body
// cannot be. For walk_space only.
#pragma once

#include <cstdint>
#include <vector>

#include "worlds/geometry/placement.h"
#include "worlds/navigation/walk_space.h"
#include "worlds/scene/stair_rule.h"

namespace handrail {

inline constexpr double kWalkRounding_m = 1e-6;

struct WalkObstacle {
    std::uint32_t first_plane = 0, plane_count = 0;
    Aabb box_m;  // grown
    FeatureId feature = kNoFeature;
    bool furniture = false;  // a thing lower than a wall
    bool stairs = false;     // see StairRule
};
// The top of something that comes and goes.
struct PassingFloor {
    WalkObstacle shape;
    std::uint32_t mover = 0;
};

class Obstacles {
public:
    // Of what touches `within`, grown by the body; null: of everything.
    Obstacles(const Scene& scene, const WalkBody& body, const Aabb* within = nullptr);

    // The heights over one place that an obstacle takes from the soles; false where it takes none. `steep`: its top
    // there cannot be stood on.
    bool column(const WalkObstacle& o, double x, double y, double& low, double& high, bool& steep) const;

    std::vector<WalkObstacle> all;
    std::vector<PassingFloor> passing;
    std::vector<std::pair<Aabb, std::uint32_t>> doors;  // upright leaves and their movers
    std::vector<const Solid*> liquids;

private:
    double support(const Vec3& n, bool narrow) const;
    void finish(std::vector<Plane>& bounds, const Aabb& box, FeatureId feature, bool stands,
                std::vector<WalkObstacle>& into);
    void add_solid(const Solid& solid, const PlacedFrame* frame, FeatureId feature, std::vector<WalkObstacle>& into);
    void add_triangle(const MeshTriangle& t, const PlacedFrame* frame, FeatureId feature);
    bool passes(const Scene& scene, std::uint32_t mover, const Solid& solid);
    bool is_looked_at(const Aabb& box) const;

    WalkBody body_;
    const Aabb* within_;
    StairRule stairs_;
    std::vector<Plane> planes_;  // pushed out by the body
};

std::vector<Aabb> boxes_of(const std::vector<WalkObstacle>& all);
std::vector<Aabb> boxes_of(const std::vector<PassingFloor>& all);

}  // namespace handrail
