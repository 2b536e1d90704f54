#include "worlds/floorplan/upright.h"

#include <algorithm>

namespace handrail::floorplan {
namespace {

constexpr double kLeast_m = 1e-4, kLeastArea_m2 = 1e-6;

Ring without_short_edges(const Ring& ring) {
    Ring kept;
    for (const Vec2& p : ring)
        if (kept.empty() || glm::length(p - kept.back()) > kLeast_m) kept.push_back(p);
    while (kept.size() > 1 && glm::length(kept.front() - kept.back()) <= kLeast_m) kept.pop_back();
    return kept;
}

// Splits a convex outline into the parts to the left and to the right of a line.
void part(const Ring& ring, const Vec2& at, const Vec2& along, Ring& left, Ring& right) {
    left.clear();
    right.clear();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        const double da = cross(along, a - at), db = cross(along, b - at);
        if (da >= 0.0) left.push_back(a);
        if (da <= 0.0) right.push_back(a);
        if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) {
            const Vec2 met = a + (b - a) * (da / (da - db));
            left.push_back(met);
            right.push_back(met);
        }
    }
}

bool has_area(const Ring& ring) { return ring.size() >= 3 && signed_area(ring) > kLeastArea_m2; }

}  // namespace

std::optional<ConvexSolid> upright(const Ring& outline, double from_m, double to_m) {
    const Ring ring = without_short_edges(outline);
    if (!has_area(ring) || !(to_m - from_m > kLeast_m)) return {};
    ConvexSolid solid;
    Polygon low, high;
    for (const Vec2& p : ring) {
        if (!is_finite({p.x, p.y, 0.0})) return {};
        low.points_m.emplace_back(p.x, p.y, from_m);
        high.points_m.emplace_back(p.x, p.y, to_m);
        solid.bounds_m.include(low.points_m.back());
        solid.bounds_m.include(high.points_m.back());
    }
    std::reverse(low.points_m.begin(), low.points_m.end());
    solid.planes = {{{0.0, 0.0, -1.0}, -from_m}, {{0.0, 0.0, 1.0}, to_m}};
    solid.faces = {low, high};
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        const Vec2 along = (b - a) / glm::length(b - a);
        Vec3 out{along.y, -along.x, 0.0};
        for (int axis = 0; axis < 2; ++axis)
            if (std::abs(out[axis]) < 1e-12) out[axis] = 0.0;
        solid.planes.push_back({out, std::max(glm::dot(out, Vec3(a, 0.0)), glm::dot(out, Vec3(b, 0.0)))});
        solid.faces.push_back({{Vec3(a, from_m), Vec3(b, from_m), Vec3(b, to_m), Vec3(a, to_m)}});
    }
    return solid;
}

Ring strip(const Vec2& from, const Vec2& to, double half_width_m) {
    const double length = glm::length(to - from);
    const Vec2 side = left_of(length > 0.0 ? (to - from) / length : Vec2(1.0, 0.0)) * half_width_m;
    return {from - side, to - side, to + side, from + side};
}

std::vector<Ring> without(const Ring& ring, const Ring& cutter) {
    std::vector<Ring> kept;
    Ring rest = ring, left, right;
    for (std::size_t i = 0; i < cutter.size() && has_area(rest); ++i) {
        const Vec2 &a = cutter[i], &b = cutter[(i + 1) % cutter.size()];
        if (glm::length(b - a) <= kLeast_m) continue;
        part(rest, a, (b - a) / glm::length(b - a), left, right);
        if (has_area(right)) kept.push_back(right);
        rest = left;
    }
    if (!has_area(rest)) return {ring};
    return kept;
}

NearestOfOutline nearest_of_outline(const std::vector<Ring>& rings, const Vec2& at) {
    NearestOfOutline found;
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 &a = ring[i], along = ring[(i + 1) % ring.size()] - a;
            const double part = std::clamp(glm::dot(at - a, along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
            const double distance_m = glm::length(at - a - along * part);
            if (distance_m >= found.distance_m) continue;
            found = {distance_m, a + along * part, along / std::max(glm::length(along), 1e-12)};
        }
    return found;
}

double distance_to_outline(const std::vector<Ring>& rings, const Vec2& at) {
    return nearest_of_outline(rings, at).distance_m;
}

}  // namespace handrail::floorplan
