// Every solid of a scene, grown by the walker's body, as planes that vertical columns are cut from: where the soles
// cannot be. Used by walk_space only.
#pragma once

#include <cstdint>
#include <vector>

#include "worlds/geometry/placement.h"
#include "worlds/navigation/walk_space.h"
#include "worlds/scene/stair_rule.h"

namespace handrail::navigation {

inline constexpr double kWalkRounding_m = 1e-6;

struct WalkObstacle {
    std::uint32_t first_plane = 0, plane_count = 0;
    Aabb box_m;  // grown by the walker's body
    FeatureId feature = kNoFeature;
    bool furniture = false;  // an object lower than a wall
    bool stairs = false;     // see StairRule
};
// The top of a moving platform that comes and goes.
struct PassingFloor {
    WalkObstacle shape;
    std::uint32_t mover = 0;
};

class Obstacles {
public:
    // Includes everything that touches `within`, grown by the walker's body; null: everything.
    Obstacles(const Scene& scene, const WalkerMeasures& body, const Aabb* within = nullptr);

    // The heights above one place that an obstacle denies to the soles. Returns false if it denies none. `steep`:
    // nobody can stand on its top there.
    bool column(const WalkObstacle& o, double x, double y, double& low, double& high, bool& steep) const;

    std::vector<WalkObstacle> all;
    std::vector<PassingFloor> passing;
    std::vector<std::pair<Aabb, std::uint32_t>> doors;  // vertical leaves and their movers
    std::vector<const Solid*> liquids;

private:
    double support(const Vec3& n, bool narrow) const;
    void finish(std::vector<Plane>& bounds, const Aabb& box, FeatureId feature, bool stands,
                std::vector<WalkObstacle>& into);
    void add_solid(const Solid& solid, const PlacedFrame* frame, FeatureId feature, std::vector<WalkObstacle>& into);
    void add_triangle(const MeshTriangle& t, const PlacedFrame* frame, FeatureId feature);
    bool passes(const Scene& scene, std::uint32_t mover, const Solid& solid);
    bool is_looked_at(const Aabb& box) const;

    WalkerMeasures body_;
    const Aabb* within_;
    StairRule stairs_;
    std::vector<Plane> planes_;  // pushed outwards by the walker's body
};

std::vector<Aabb> boxes_of(const std::vector<WalkObstacle>& all);
std::vector<Aabb> boxes_of(const std::vector<PassingFloor>& all);

}  // namespace handrail::navigation
