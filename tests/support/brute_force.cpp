#include "tests/support/brute_force.h"
#include "tests/support/names.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace handrail::test {
namespace {

LVec cross(const LVec& a, const LVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
long double dot(const LVec& a, const LVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
long double length(const LVec& a) { return std::sqrt(dot(a, a)); }

}  // namespace

Nearest nearest_on_segment(const LVec& a, const LVec& b, const LVec& p) {
    const long double length2 = dot(b - a, b - a);
    long double t = length2 > 0.0L ? dot(p - a, b - a) / length2 : 0.0L;
    t = std::min(1.0L, std::max(0.0L, t));
    const LVec q = a * (1.0L - t) + b * t;
    return {q, length(p - q)};
}

Nearest nearest_on_triangle(const LVec& a, const LVec& b, const LVec& c, const LVec& p) {
    Nearest best = nearest_on_segment(a, b, p);
    for (const Nearest& other : {nearest_on_segment(b, c, p), nearest_on_segment(c, a, p)})
        if (other.distance < best.distance) best = other;
    // Barycentric coordinates of the foot of the perpendicular (Cramer's rule). A degenerate triangle has no plane and
    // counts as its three edges.
    const LVec u = b - a, v = c - a, w = p - a;
    const long double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
    const long double det = uu * vv - uv * uv;
    if (det > 1e-30L * uu * vv && det > 0.0L) {
        const long double s = (wu * vv - wv * uv) / det, t = (wv * uu - wu * uv) / det;
        if (s >= 0.0L && t >= 0.0L && s + t <= 1.0L) {
            const LVec q = a + u * s + v * t;
            const long double d = length(p - q);
            if (d < best.distance) best = {q, d};
        }
    }
    return best;
}

Nearest nearest_on_polygon(const std::vector<LVec>& corners, const LVec& p) {
    Nearest best = nearest_on_segment(corners[0], corners[1], p);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Nearest other = nearest_on_triangle(corners[0], corners[i], corners[i + 1], p);
        if (other.distance < best.distance) best = other;
    }
    return best;
}

Nearest nearest_on_capsule(const LVec& a, const LVec& b, long double radius, const LVec& p) {
    const Nearest core = nearest_on_segment(a, b, p);
    if (core.distance == 0.0L) return {core.point, -radius};
    return {core.point + (p - core.point) * (radius / core.distance), core.distance - radius};
}

namespace {

// Returns the direction of the axis. A shape without height may have any direction; in the tests such shapes are discs
// perpendicular to z.
LVec direction_of(const LVec& a, const LVec& b) {
    const long double l = length(b - a);
    return l > 0.0L ? (b - a) / l : LVec(0.0L, 0.0L, 1.0L);
}

}  // namespace

Nearest nearest_on_cylinder(const LVec& a, const LVec& b, long double radius, const LVec& p) {
    const LVec u = direction_of(a, b);
    const long double height = length(b - a), z = dot(p - a, u);
    const LVec w = p - a - u * z;
    const long double rho = length(w);
    const long double inside = std::min({z, height - z, radius - rho});
    if (inside >= 0.0L) return {p, -inside};
    const LVec q = a + u * std::min(height, std::max(0.0L, z)) + (rho > radius ? w * (radius / rho) : w);
    return {q, length(p - q)};
}

Nearest nearest_on_cone(const LVec& a, const LVec& b, long double radius, const LVec& p) {
    const LVec u = direction_of(a, b);
    const long double height = length(b - a), z = dot(p - a, u);
    const LVec w = p - a - u * z;
    const long double rho = length(w), slant = std::sqrt(height * height + radius * radius);
    // In the half-plane through the axis and the point, the cone is a triangle.
    if (slant > 0.0L) {
        const long double inside = std::min(z, ((radius - rho) * height - z * radius) / slant);
        if (inside >= 0.0L) return {p, -inside};
    }
    const Nearest flat =
        nearest_on_triangle({0.0L, 0.0L, 0.0L}, {radius, 0.0L, 0.0L}, {0.0L, height, 0.0L}, {rho, z, 0.0L});
    return {a + u * flat.point.y + (rho > 0.0L ? w * (flat.point.x / rho) : LVec(0.0L)), flat.distance};
}

std::optional<LVec> project_by_enumeration(const std::vector<LHalfSpace>& walls, const LVec& goal,
                                           long double tolerance) {
    std::optional<LVec> best;
    long double best2 = std::numeric_limits<long double>::infinity();
    const auto consider = [&](const LVec& x) {
        const long double d2 = dot(x - goal, x - goal);
        if (!(d2 < best2)) return;
        for (const LHalfSpace& w : walls)
            if (dot(w.normal, x) < w.offset - tolerance) return;
        best = x;
        best2 = d2;
    };
    consider(goal);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const LHalfSpace& a = walls[i];
        consider(goal + a.normal * (a.offset - dot(a.normal, goal)));
        for (std::size_t j = i + 1; j < walls.size(); ++j) {
            const LHalfSpace& b = walls[j];
            const LVec along = cross(a.normal, b.normal);
            const long double det = dot(along, along);
            if (det < 1e-20L) continue;
            const LVec line = (cross(b.normal, along) * a.offset + cross(along, a.normal) * b.offset) / det;
            consider(line + along * (dot(goal - line, along) / det));
            for (std::size_t k = j + 1; k < walls.size(); ++k) {
                const LHalfSpace& c = walls[k];
                const long double volume = dot(along, c.normal);
                if (std::abs(volume) < 1e-12L) continue;
                consider(
                    (cross(b.normal, c.normal) * a.offset + cross(c.normal, a.normal) * b.offset + along * c.offset) /
                    volume);
            }
        }
    }
    return best;
}

Nearest nearest_on_solid(const std::vector<Plane>& planes, const LVec& p) {
    std::vector<LHalfSpace> walls;
    long double deepest = -std::numeric_limits<long double>::infinity();
    LVec normal{0.0L};
    for (const Plane& plane : planes) {
        const LVec n(plane.normal);
        // The planes are relative to p, so that the enumeration works with numbers of few digits.
        const long double out = dot(n, p) - static_cast<long double>(plane.offset_m);
        walls.push_back({-n, out});
        if (out > deepest) {
            deepest = out;
            normal = n;
        }
    }
    if (deepest <= 0.0L) return {p - normal * deepest, deepest};
    const std::optional<LVec> step = project_by_enumeration(walls, LVec(0.0L), 1e-12L);
    if (!step) return {p - normal * deepest, deepest};
    return {p + *step, length(*step)};
}

void BruteForce::add_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    Thing t;
    t.a = LVec(a), t.b = LVec(b), t.c = LVec(c);
    t.centre = (t.a + t.b + t.c) / 3.0L;
    t.reach = std::max({length(t.a - t.centre), length(t.b - t.centre), length(t.c - t.centre)});
    things_.push_back(std::move(t));
}

void BruteForce::add_solid(const std::vector<Plane>& planes, const std::vector<Vec3>& corners) {
    Thing t;
    t.solid = true;
    t.planes = planes;
    for (const Vec3& corner : corners) t.centre += LVec(corner) / static_cast<long double>(corners.size());
    for (const Vec3& corner : corners) t.reach = std::max(t.reach, length(LVec(corner) - t.centre));
    things_.push_back(std::move(t));
}

void BruteForce::add(std::function<Nearest(const LVec&)> nearest, const std::vector<Vec3>& corners, double more) {
    Thing t;
    t.other = std::move(nearest);
    for (const Vec3& corner : corners) t.centre += LVec(corner) / static_cast<long double>(corners.size());
    for (const Vec3& corner : corners) t.reach = std::max(t.reach, length(LVec(corner) - t.centre));
    t.reach += static_cast<long double>(more);
    things_.push_back(std::move(t));
}

Nearest BruteForce::nearest(const Thing& t, const LVec& p) const {
    return t.other ? t.other(p) : t.solid ? nearest_on_solid(t.planes, p) : nearest_on_triangle(t.a, t.b, t.c, p);
}

long double BruteForce::distance(const Vec3& p, long double far) const {
    const LVec lp(p);
    long double best = far;
    for (const Thing& t : things_) {
        if (length(lp - t.centre) - t.reach > best) continue;
        best = std::min(best, nearest(t, lp).distance);
    }
    return best;
}

bool BruteForce::clear(const Vec3& from, const Vec3& to, long double clearance, int samples) const {
    const long double between = length(LVec(to) - LVec(from)) / samples;
    for (int i = 0; i <= samples; ++i) {
        const double t = static_cast<double>(i) / samples;
        const long double d = distance(from + (to - from) * t, clearance + between + 1.0L);
        // Between two samples, the distance can be smaller than at both by at most half their spacing.
        if (d < clearance + between * 0.5L) return false;
    }
    return true;
}

long double BruteForce::residual(const Vec3& c, const Vec3& goal, long double radius) const {
    const LVec lc(c);
    std::vector<LHalfSpace> walls;
    constexpr long double kNear = 1e-4L;
    for (const Thing& t : things_) {
        if (length(lc - t.centre) - t.reach > radius + kNear) continue;
        const Nearest n = nearest(t, lc);
        if (n.distance > radius + kNear || n.distance <= 0.0L) continue;
        const LHalfSpace wall{(lc - n.point) / n.distance, std::min(0.0L, radius - n.distance)};
        bool known = false;
        for (const LHalfSpace& w : walls)
            known = known || (dot(w.normal, wall.normal) > 1.0L - 1e-18L && w.offset >= wall.offset - 1e-12L);
        if (!known) walls.push_back(wall);
    }
    const std::optional<LVec> step = project_by_enumeration(walls, LVec(goal) - lc, 1e-12L);
    return step ? length(*step) : 0.0L;
}

}  // namespace handrail::test
