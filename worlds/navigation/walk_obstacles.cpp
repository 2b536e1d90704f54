#include "worlds/navigation/walk_obstacles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "worlds/base/human_measures.h"
#include "worlds/geometry/clip.h"

namespace handrail::navigation {
namespace {

constexpr double kFlatMost_m = 1.5;   // a door that lies flat and is no thicker than this may be a bridge
constexpr double kWideThing_m = 5.0;  // an object at least this wide is a floor or platform, not furniture
constexpr double kTallThing_m = 2.3;  // an object at least this high is treated as a wall
// An object at least as high as a door is treated as a wall if the wall above rests on it.
constexpr double kDoorHigh_m = 1.8;
constexpr double kRests_m = 0.02;  // greatest gap between a support and what rests on it

// Distinguishes furniture from walls.
class Furniture {
public:
    explicit Furniture(const Scene& scene) : scene_(scene) {
        for (const Solid& solid : scene.solids)
            if (solid.role == SolidRole::Solid) by_foot_.push_back(&solid.shape.bounds_m);
        std::sort(by_foot_.begin(), by_foot_.end(),
                  [](const Aabb* a, const Aabb* b) { return a->min_m.z < b->min_m.z; });
    }

    bool is(FeatureId id) const {
        const Feature* feature = scene_.find(id);
        if (!feature || feature->kind != FeatureKind::Object || feature->bounds_m.empty()) return false;
        const Vec3 size = feature->bounds_m.size_m();
        return size.z < kTallThing_m && std::max(size.x, size.y) < kWideThing_m &&
               (size.z < kDoorHigh_m || !carries_wall(feature->bounds_m));
    }

private:
    // Returns whether a wall rests on the object. The pieces of a wall on both sides of a door carry their lintel,
    // which is a separate piece.
    bool carries_wall(const Aabb& thing) const {
        const auto lower = [](const Aabb* box, double z) { return box->min_m.z < z; };
        for (auto it = std::lower_bound(by_foot_.begin(), by_foot_.end(), thing.max_m.z - kRests_m, lower);
             it != by_foot_.end() && (*it)->min_m.z <= thing.max_m.z + kRests_m; ++it) {
            const Aabb& over = **it;
            if (over.max_m.z - thing.min_m.z >= kTallThing_m && over.min_m.x < thing.max_m.x &&
                over.max_m.x > thing.min_m.x && over.min_m.y < thing.max_m.y && over.max_m.y > thing.min_m.y)
                return true;
        }
        return false;
    }

    const Scene& scene_;
    std::vector<const Aabb*> by_foot_;
};

}  // namespace

Obstacles::Obstacles(const Scene& scene, const WalkerMeasures& body, const Aabb* within)
    : body_(body), within_(within), stairs_(scene) {
    std::vector<int> mover_of_feature(scene.features.size(), -1);
    for (std::size_t m = 0; m < scene.movers.size(); ++m)
        if (scene.movers[m].feature.value < mover_of_feature.size() && scene.movers[m].moves())
            mover_of_feature[scene.movers[m].feature.value] = static_cast<int>(m);
    // Objects that walkers push aside do not block anyone, so they are left out.
    std::vector<bool> gives_way(scene.features.size(), false);
    for (const FreeBody& free : scene.bodies)
        if (free.feature.value < gives_way.size()) gives_way[free.feature.value] = free.gives_way_to_walkers();
    const auto pushed_aside = [&](FeatureId feature) {
        return feature.value < gives_way.size() && gives_way[feature.value];
    };
    const Furniture things(scene);
    std::size_t marked = 0;
    const auto mark = [&](bool furniture) {
        for (; marked < all.size(); ++marked) all[marked].furniture = furniture;
    };
    for (const Solid& solid : scene.solids) {
        if (!is_looked_at(solid.shape.bounds_m)) continue;
        const int mover = solid.role == SolidRole::Mover && solid.feature.value < mover_of_feature.size()
                              ? mover_of_feature[solid.feature.value]
                              : -1;
        const bool furniture = things.is(solid.feature);
        if (mover >= 0 && passes(scene, static_cast<std::uint32_t>(mover), solid)) continue;
        if (solid.role == SolidRole::Mover && pushed_aside(solid.feature)) continue;
        add_solid(solid, nullptr, solid.feature, all);
        mark(furniture);
    }
    for (const MeshTriangle& triangle : scene.triangles) add_triangle(triangle, nullptr, triangle.feature);
    mark(false);
    for (const PlacedModel& placed : scene.placed) {
        if (pushed_aside(placed.feature)) continue;
        const bool furniture = things.is(placed.feature);
        const PlacedFrame frame(placed.at);
        for (const Solid& solid : placed.model->solids) add_solid(solid, &frame, placed.feature, all);
        for (const MeshTriangle& triangle : placed.model->triangles) add_triangle(triangle, &frame, placed.feature);
        mark(furniture);
    }
    for (const Solid& solid : scene.solids)
        if (solid.role == SolidRole::Liquid) liquids.push_back(&solid);
}

bool Obstacles::is_looked_at(const Aabb& box) const {
    return !within_ || overlap(grown(*within_, body_.radius_m + body_.height_m), box);
}

bool Obstacles::column(const WalkObstacle& o, double x, double y, double& low, double& high, bool& steep) const {
    low = -std::numeric_limits<double>::infinity();
    high = -low;
    double top_normal = 1.0;
    for (std::uint32_t k = o.first_plane; k < o.first_plane + o.plane_count; ++k) {
        const Plane& p = planes_[k];
        const double level = p.offset_m - p.normal.x * x - p.normal.y * y;
        if (std::abs(p.normal.z) < 1e-9) {
            if (level <= kWalkRounding_m) return false;
        } else if (p.normal.z > 0.0) {
            if (const double z = level / p.normal.z; z < high) {
                high = z;
                top_normal = p.normal.z;
            }
        } else {
            low = std::max(low, level / p.normal.z);
        }
    }
    steep = top_normal < kWalkableNormalZ;
    return low < high;
}

double Obstacles::support(const Vec3& n, bool narrow) const {
    const double radius_m = narrow ? StairRule::reach_m(body_.radius_m) : body_.radius_m,
                 height_m = narrow ? StairRule::height_m(body_.height_m) : body_.height_m;
    return radius_m * std::sqrt(n.x * n.x + n.y * n.y) + std::max(0.0, -n.z * height_m);
}

// Adds an obstacle. `stands`: it is a part of the building that does not move, so it may belong to stairs.
void Obstacles::finish(std::vector<Plane>& bounds, const Aabb& box, FeatureId feature, bool stands,
                       std::vector<WalkObstacle>& into) {
    // Adds the planes of the bounding box. Without these planes, a sharp solid that is grown by the walker's radius
    // would stick out far.
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            Vec3 normal{0.0};
            normal[axis] = sign;
            if (std::none_of(bounds.begin(), bounds.end(),
                             [&](const Plane& b) { return glm::dot(b.normal, normal) > 1.0 - 1e-9; }))
                bounds.push_back({normal, sign > 0 ? box.max_m[axis] : -box.min_m[axis]});
        }
    WalkObstacle made{static_cast<std::uint32_t>(planes_.size()), static_cast<std::uint32_t>(bounds.size()), box,
                      feature};
    const bool narrow = stands && stairs_.narrow(feature, box);
    const double radius_m = narrow ? StairRule::reach_m(body_.radius_m) : body_.radius_m;
    made.stairs = stands && stairs_.is_stairs(feature);
    made.box_m.min_m -= Vec3(radius_m, radius_m, body_.height_m);
    made.box_m.max_m += Vec3(radius_m, radius_m, 0.0);
    for (Plane b : bounds) {
        b.offset_m += support(b.normal, narrow);
        planes_.push_back(b);
    }
    into.push_back(made);
}

void Obstacles::add_solid(const Solid& solid, const PlacedFrame* frame, FeatureId feature,
                          std::vector<WalkObstacle>& into) {
    if (solid.role != SolidRole::Solid && solid.role != SolidRole::Mover && solid.role != SolidRole::BodyClip) return;
    std::vector<Plane> bounds = solid.shape.planes;
    Aabb box = solid.shape.bounds_m;
    if (frame) {
        box = {};
        for (const Polygon& face : solid.shape.faces)
            for (const Vec3& p : face.points_m) box.include(frame->to_world(p));
        for (Plane& plane : bounds) {
            const double own = plane.offset_m;
            plane.normal = frame->turned(plane.normal);
            plane.offset_m = own * frame->scale + glm::dot(plane.normal, frame->position_m);
        }
    }
    if (!box.empty() && is_finite(box.min_m) && is_finite(box.max_m) && is_looked_at(box))
        finish(bounds, box, feature, !frame, into);
}

void Obstacles::add_triangle(const MeshTriangle& t, const PlacedFrame* frame, FeatureId feature) {
    const auto at = [frame](const Vec3& p) { return frame ? frame->to_world(p) : p; };
    const Vec3 corners[3] = {at(t.a_m), at(t.b_m), at(t.c_m)};
    const Vec3 area = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = glm::length(area);
    if (!(length > 0.0) || !std::isfinite(length)) return;
    const Vec3 n = area / length;
    std::vector<Plane> bounds{{n, glm::dot(n, corners[0])}, {-n, -glm::dot(n, corners[0])}};
    Aabb box;
    for (int e = 0; e < 3; ++e) {
        box.include(corners[e]);
        const Vec3 side = glm::cross(corners[(e + 1) % 3] - corners[e], n);
        if (const double l = glm::length(side); l > 0.0) bounds.push_back({side / l, glm::dot(side / l, corners[e])});
    }
    if (is_looked_at(box)) finish(bounds, box, feature, !frame, all);
}

// Returns true if walkers can pass the mover; false if it blocks them like a wall. All doors are passable. The floor of
// a moving platform is added at all its stops.
bool Obstacles::passes(const Scene& scene, std::uint32_t mover, const Solid& solid) {
    const Mover& m = scene.movers[mover];
    const Feature& feature = scene.features[m.feature.value];
    if (!m.stops.empty()) return true;  // a train comes and goes, and waits for people in its path
    if (feature.kind != FeatureKind::Door && feature.kind != FeatureKind::Lift) return false;
    const Vec3 size = feature.bounds_m.size_m();
    const bool flat = size.z <= kFlatMost_m && size.z < 0.5 * std::min(size.x, size.y);
    if (flat || feature.kind == FeatureKind::Lift || m.slide_m.z != 0.0) {
        for (const double part : m.halts.empty() ? std::vector<double>{0.0, 1.0} : m.halts) {
            PassingFloor floor;
            floor.mover = mover;
            const PlacedFrame frame(Placement{m.slide_m * part, {}, 1.0});
            std::vector<WalkObstacle> made;
            add_solid(solid, &frame, m.feature, made);
            if (made.empty()) continue;
            floor.shape = made.front();
            passing.push_back(floor);
        }
    }
    if (feature.kind == FeatureKind::Door && !flat) doors.emplace_back(solid.shape.bounds_m, mover);
    return true;
}

std::vector<Aabb> boxes_of(const std::vector<WalkObstacle>& all) {
    std::vector<Aabb> found;
    found.reserve(all.size());
    for (const WalkObstacle& o : all) found.push_back(o.box_m);
    return found;
}

std::vector<Aabb> boxes_of(const std::vector<PassingFloor>& all) {
    std::vector<Aabb> found;
    found.reserve(all.size());
    for (const PassingFloor& o : all) found.push_back(o.shape.box_m);
    return found;
}

}  // namespace handrail::navigation
