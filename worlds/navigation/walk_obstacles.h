// Makes every solid of a scene into an obstacle: the region in which a walker's soles cannot be. Each solid is grown by
// the walker's size and stored as planes, with which vertical lines are intersected. Only walk_space uses this class.
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
    Aabb box_m;  // bounding box, grown by the walker's size
    FeatureId feature = kNoFeature;
    bool furniture = false;  // true: an object that is lower than a wall
    bool stairs = false;     // true: the obstacle may be part of stairs; see StairRule
};
// A floor on the top of a moving platform, which is there only while the platform stops at it.
struct PassingFloor {
    WalkObstacle shape;
    std::uint32_t mover = 0;
};

class Obstacles {
public:
    // Includes every solid that touches `within` when it is grown by the walker's size. Null: all solids.
    Obstacles(const Scene& scene, const WalkerMeasures& body, const Aabb* within = nullptr);

    // Computes the range of heights, above one place, in which the obstacle excludes a walker's soles. Returns false if
    // there is none. `steep`: nobody can stand on the obstacle's top at that place.
    bool column(const WalkObstacle& o, double x, double y, double& low, double& high, bool& steep) const;

    std::vector<WalkObstacle> all;
    std::vector<PassingFloor> passing;
    std::vector<std::pair<Aabb, std::uint32_t>> doors;  // door leaves that are vertical, each with its mover
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
    std::vector<Plane> planes_;  // shifted outwards by the walker's size
};

std::vector<Aabb> boxes_of(const std::vector<WalkObstacle>& all);
std::vector<Aabb> boxes_of(const std::vector<PassingFloor>& all);

}  // namespace handrail::navigation
