#include "app/core/world/mover_meeting.h"

#include <algorithm>
#include <vector>

#include "app/core/world/walker.h"
#include "worlds/scene/models.h"

namespace handrail::core {
namespace {

constexpr double kOnIt_m = 0.05;  // a walker stands on a thing if its soles are at most this far above the thing

// Makes a world that contains only this thing.
WalkerWorld alone(const std::shared_ptr<const Scene>& model, const Placement& at) {
    auto scene = std::make_shared<Scene>();
    scene->materials.emplace_back();
    scene->placed.push_back({kNoFeature, model, kDefaultMaterial, at});
    return WalkerWorld(std::move(scene));
}

// A convex part of a thing, in world coordinates.
struct Part {
    std::vector<Plane> planes;
    std::vector<Vec3> points_m;
    Aabb box_m;
};

std::vector<Part> parts_of(const Scene& model, const Placement& at) {
    const PlacedFrame frame(at);
    std::vector<Part> parts;
    for (const Solid& solid : model.solids) {
        if (solid.role != SolidRole::Solid && solid.role != SolidRole::Mover) continue;
        Part part;
        for (std::size_t i = 0; i < solid.shape.planes.size(); ++i) {
            const Vec3 normal = frame.turned(solid.shape.planes[i].normal);
            part.planes.push_back(
                {normal, solid.shape.planes[i].offset_m * frame.scale + glm::dot(normal, frame.position_m)});
        }
        for (const Polygon& face : solid.shape.faces)
            for (const Vec3& p : face.points_m) part.points_m.push_back(frame.to_world(p));
        for (const Vec3& p : part.points_m) part.box_m.include(p);
        parts.push_back(std::move(part));
    }
    for (const MeshTriangle& t : model.triangles) {
        Part part;
        part.points_m = {frame.to_world(t.a_m), frame.to_world(t.b_m), frame.to_world(t.c_m)};
        const Vec3 area = glm::cross(part.points_m[1] - part.points_m[0], part.points_m[2] - part.points_m[0]);
        const double length = glm::length(area);
        if (!(length > 0.0)) continue;
        for (const double sign : {1.0, -1.0}) {
            const Vec3 normal = area * (sign / length);
            part.planes.push_back({normal, glm::dot(normal, part.points_m[0])});
        }
        for (const Vec3& p : part.points_m) part.box_m.include(p);
        parts.push_back(std::move(part));
    }
    return parts;
}

bool apart(const Aabb& a, const Aabb& b) {
    const Vec3 gap = glm::max(a.min_m - b.max_m, b.min_m - a.max_m);
    return std::max({gap.x, gap.y, gap.z}) > -kMeetingDepth_m;
}

bool parted_by_planes(const Part& a, const Part& b) {
    return std::any_of(a.planes.begin(), a.planes.end(), [&](const Plane& plane) {
        return std::all_of(b.points_m.begin(), b.points_m.end(),
                           [&](const Vec3& p) { return signed_distance(plane, p) > -kMeetingDepth_m; });
    });
}

}  // namespace

bool meets_walker(const std::shared_ptr<const Scene>& model, const Placement& at, const Vec3& feet_m,
                  const WalkerShape& body) {
    return alone(model, at).blocked(feet_m, body);
}

bool things_meet(const Scene& a, const Placement& a_at, const Scene& b, const Placement& b_at) {
    const std::vector<Part> of_a = parts_of(a, a_at), of_b = parts_of(b, b_at);
    for (const Part& p : of_a)
        for (const Part& q : of_b)
            if (!apart(p.box_m, q.box_m) && !parted_by_planes(p, q) && !parted_by_planes(q, p)) return true;
    return false;
}

bool boxes_meet(const Aabb& a, const Aabb& b) {
    return a.min_m.x < b.max_m.x && b.min_m.x < a.max_m.x && a.min_m.y < b.max_m.y && b.min_m.y < a.max_m.y &&
           a.min_m.z < b.max_m.z && b.min_m.z < a.max_m.z;
}

Riding riding(const std::shared_ptr<const Scene>& model, const Placement& at, const Vec3& feet_m,
              const WalkerShape& body) {
    const WalkerWorld thing = alone(model, at);
    const Vec3 above = feet_m + Vec3(0.0, 0.0, kOnIt_m), below = feet_m - Vec3(0.0, 0.0, kOnIt_m);
    const auto stands = [&](const WalkerShape& shape) {
        const TraceHit hit = thing.trace(above, below, shape);
        return hit.hit && hit.normal.z >= kWalkableNormalZ;
    };
    if (stands({})) return Riding::ByMiddle;
    return stands({body.radius_m, 0.0}) ? Riding::ByRim : Riding::Not;
}

Vec3 carried(const Vec3& point_m, const Placement& from, const Placement& to) {
    return PlacedFrame(to).to_world(PlacedFrame(from).to_own(point_m));
}

Vec3 onto_thing(const Aabb& thing_m, const Vec3& feet_m, double radius_m) {
    Vec3 by{0.0};
    for (int axis = 0; axis < 2; ++axis) {
        // The walker must be clear of another solid that is flush with the edge of the thing.
        const double clear_m = radius_m + 2.0 * WalkerWorld::kContactGap_m;
        const double low = thing_m.min_m[axis] + clear_m, high = thing_m.max_m[axis] - clear_m;
        if (low <= high) by[axis] = std::clamp(feet_m[axis], low, high) - feet_m[axis];
    }
    return by;
}

bool step_in(Vec3 feet_m, const Aabb& lift_m, const std::function<bool(const Vec3& to_m)>& fits) {
    constexpr double kStep_m = 0.05, kMost_m = 0.6;
    if (fits(feet_m)) return true;
    const Vec3 middle_m = lift_m.centre_m(), inwards{middle_m.x - feet_m.x, middle_m.y - feet_m.y, 0.0};
    const double far_m = glm::length(inwards);
    for (double by_m = kStep_m; by_m < std::min(far_m, kMost_m); by_m += kStep_m)
        if (fits(feet_m + inwards * (by_m / far_m))) return true;
    return false;
}

}  // namespace handrail::core
