#include "worlds/geometry/clip.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/contract.h"

namespace handrail {
namespace {

constexpr double kAxisSnap = 1e-12;       // a normal that differs from an axis by less than this becomes that axis
constexpr double kSameDirection = 1e-10;  // two normals are equal if their dot product differs from 1 by less than this

// Moves the point onto an axis-aligned plane by setting the one coordinate that the plane determines.
void snap_to(Vec3& point_m, const Plane& plane) noexcept {
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(plane.normal[axis]) == 1.0)
            point_m[axis] = plane.normal[axis] * plane.offset_m + 0.0;  // adding 0.0 turns minus zero into zero
}

// Returns a square on the plane, counter-clockwise seen from the front.
std::vector<Vec3> start_square(const Plane& plane, const Vec3& near_m, double half_m) {
    const Vec3 n = plane.normal;
    const Vec3 helper = std::abs(n.z) < 0.7 ? Vec3{0.0, 0.0, 1.0} : Vec3{1.0, 0.0, 0.0};
    const Vec3 u = glm::normalize(glm::cross(helper, n)) * half_m;
    const Vec3 v = glm::normalize(glm::cross(n, u)) * half_m;
    const Vec3 middle = near_m - n * signed_distance(plane, near_m);
    std::vector<Vec3> square{middle - u - v, middle + u - v, middle + u + v, middle - u + v};
    for (Vec3& corner : square) snap_to(corner, plane);
    return square;
}

void cut(std::span<const Vec3> points_m, const Plane& plane, double cut_m, std::vector<Vec3>& back_m,
         std::vector<Vec3>* front_m) {
    back_m.clear();
    if (front_m) front_m->clear();
    const std::size_t count = points_m.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3& a = points_m[i];
        const Vec3& b = points_m[(i + 1) % count];
        const double da = signed_distance(plane, a), db = signed_distance(plane, b);
        if (da <= cut_m) back_m.push_back(a);
        if (front_m && da >= -cut_m) front_m->push_back(a);
        if (!((da < -cut_m && db > cut_m) || (da > cut_m && db < -cut_m))) continue;
        Vec3 crossing = a + (b - a) * (da / (da - db));
        snap_to(crossing, plane);
        back_m.push_back(crossing);
        if (front_m) front_m->push_back(crossing);
    }
}

bool repeats(const Plane& a, const Plane& b, double cut_m) noexcept {
    return glm::dot(a.normal, b.normal) > 1.0 - kSameDirection && std::abs(a.offset_m - b.offset_m) <= cut_m;
}

void intersect(std::span<const Plane> planes, const Vec3& near_m, double half_m, const CutTolerance& tolerance,
               BuiltSolid& out) {
    out.solid = {};
    out.plane_index.clear();
    std::vector<Vec3> points, scratch;
    for (std::uint32_t i = 0; i < planes.size(); ++i) {
        const auto repeats_this = [&](const Plane& other) { return repeats(planes[i], other, tolerance.cut_m); };
        if (std::any_of(planes.begin(), planes.begin() + i, repeats_this)) continue;
        points = start_square(planes[i], near_m, half_m);
        for (std::uint32_t j = 0; j < planes.size() && points.size() >= 3; ++j)
            if (j != i && !repeats(planes[i], planes[j], tolerance.cut_m))
                keep_back(points, planes[j], tolerance.cut_m, scratch);
        tidy(points, tolerance.merge_m);
        if (points.size() < 3) continue;
        out.solid.planes.push_back(planes[i]);
        out.plane_index.push_back(i);
        for (const Vec3& p : points) out.solid.bounds_m.include(p);
        out.solid.faces.push_back(Polygon{points});
    }
    out.planes_without_face = static_cast<int>(planes.size() - out.plane_index.size());
}

SolidFault fault_of(const ConvexSolid& solid, const Vec3& near_m, double half_m, double merge_m) {
    if (solid.faces.empty()) return SolidFault::Empty;
    const Vec3 reach = glm::max(glm::abs(solid.bounds_m.max_m - near_m), glm::abs(solid.bounds_m.min_m - near_m));
    if (std::max({reach.x, reach.y, reach.z}) > half_m * 0.5) return SolidFault::Open;
    if (solid.faces.size() < 4) return SolidFault::Empty;
    double volume = 0.0;
    for (std::size_t i = 0; i < solid.faces.size(); ++i)
        volume += area_m2(solid.faces[i]) * -signed_distance(solid.planes[i], solid.bounds_m.centre_m()) / 3.0;
    const Vec3 size = solid.bounds_m.size_m();
    return volume > merge_m * merge_m * std::max({size.x, size.y, size.z}) ? SolidFault::None : SolidFault::Empty;
}

}  // namespace

Vec3 area_vector_m2(std::span<const Vec3> points_m) noexcept {
    Vec3 sum{0.0};
    for (std::size_t i = 1; i + 1 < points_m.size(); ++i)
        sum += glm::cross(points_m[i] - points_m[0], points_m[i + 1] - points_m[0]);
    return 0.5 * sum;
}

Aabb bounds_of(const Polygon& polygon) noexcept {
    Aabb box;
    for (const Vec3& p : polygon.points_m) box.include(p);
    return box;
}

Vec3 centre_of(const Polygon& polygon) noexcept {
    Vec3 sum{0.0};
    for (const Vec3& p : polygon.points_m) sum += p;
    return sum / static_cast<double>(polygon.points_m.size());
}

Aabb grown(const Aabb& box, double by_m) noexcept { return {box.min_m - Vec3{by_m}, box.max_m + Vec3{by_m}}; }

bool overlap(const Aabb& a, const Aabb& b) noexcept {
    for (int axis = 0; axis < 3; ++axis)
        if (a.min_m[axis] > b.max_m[axis] || b.min_m[axis] > a.max_m[axis]) return false;
    return true;
}

Side side_of(std::span<const Vec3> points_m, const Plane& plane, double cut_m) noexcept {
    bool back = false, front = false;
    for (const Vec3& p : points_m) {
        const double d = signed_distance(plane, p);
        if (d > cut_m) front = true;
        else if (d < -cut_m) back = true;
    }
    if (front) return back ? Side::Across : Side::Front;
    return back ? Side::Back : Side::On;
}

void split(std::span<const Vec3> points_m, const Plane& plane, double cut_m, std::vector<Vec3>& back_m,
           std::vector<Vec3>& front_m) {
    contract_pre(cut_m >= 0.0);
    contract_pre(&back_m != &front_m);
    cut(points_m, plane, cut_m, back_m, &front_m);
}

void keep_back(std::vector<Vec3>& points_m, const Plane& plane, double cut_m, std::vector<Vec3>& scratch) {
    contract_pre(cut_m >= 0.0);
    contract_pre(&points_m != &scratch);
    const Side side = side_of(points_m, plane, cut_m);
    if (side == Side::Front) points_m.clear();
    if (side != Side::Across) return;
    cut(points_m, plane, cut_m, scratch, nullptr);
    points_m.swap(scratch);
}

void tidy(std::vector<Vec3>& points_m, double merge_m) {
    contract_pre(merge_m >= 0.0);
    const auto near_each_other = [merge_m](const Vec3& a, const Vec3& b) {
        return glm::dot(a - b, a - b) <= merge_m * merge_m;
    };
    points_m.erase(std::unique(points_m.begin(), points_m.end(), near_each_other), points_m.end());
    while (points_m.size() > 1 && near_each_other(points_m.front(), points_m.back())) points_m.pop_back();
    double longest_m = 0.0;
    for (std::size_t i = 1; i < points_m.size(); ++i)
        longest_m = std::max(longest_m, glm::length(points_m[i] - points_m[0]));
    if (points_m.size() < 3 || area_m2(points_m) <= longest_m * merge_m) points_m.clear();
}

bool plane_from_clockwise(const Vec3& p0_m, const Vec3& p1_m, const Vec3& p2_m, Plane& plane) noexcept {
    const Vec3 a = p0_m - p1_m, b = p2_m - p1_m;
    const Vec3 normal = glm::cross(a, b);
    const double length = glm::length(normal);
    if (!(length > 1e-12 * glm::length(a) * glm::length(b)) || !std::isfinite(length)) return false;
    plane.normal = normal / length;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(plane.normal[axis]) < 1.0 - kAxisSnap) continue;
        const double sign = plane.normal[axis] > 0.0 ? 1.0 : -1.0;
        plane.normal = Vec3{0.0};
        plane.normal[axis] = sign;
    }
    plane.offset_m = glm::dot(plane.normal, p0_m) + 0.0;
    return true;
}

BuiltSolid solid_from_planes(std::span<const Plane> planes, const Vec3& near_m, double reach_m,
                             const CutTolerance& tolerance) {
    contract_pre(is_finite(near_m));
    contract_pre(reach_m > 0.0 && std::isfinite(reach_m));
    BuiltSolid out;
    std::vector<Plane> used(planes.begin(), planes.end());
    const double half_m = 2.0 * reach_m;
    intersect(used, near_m, half_m, tolerance, out);
    out.fault = fault_of(out.solid, near_m, half_m, tolerance.merge_m);
    if (out.fault == SolidFault::Empty) {
        std::vector<Plane> turned = used;
        for (Plane& plane : turned) plane = {-plane.normal, -plane.offset_m};
        BuiltSolid other;
        intersect(turned, near_m, half_m, tolerance, other);
        if (fault_of(other.solid, near_m, half_m, tolerance.merge_m) == SolidFault::None) {
            out = std::move(other);
            out.was_inside_out = true;
            used.swap(turned);
        }
    }
    if (out.fault != SolidFault::None) return out;
    // Cuts a second time, starting from squares of the solid's own size. So the rounding errors of the corners depend
    // on the solid's size and not on `reach_m`.
    const Aabb box = out.solid.bounds_m;
    intersect(used, box.centre_m(), 2.0 * glm::length(box.size_m()), tolerance, out);
    if (out.solid.faces.size() < 4) out.fault = SolidFault::Empty;
    return out;
}

}  // namespace handrail
