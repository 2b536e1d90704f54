#include "worlds/exports/solid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>

namespace handrail::exports {
namespace {

// Returns twice the area of a triangle, positive if it is counter-clockwise. A plate is less than 2 m wide, so the
// product does not overflow.
std::int64_t turn(const PlatePoint& a, const PlatePoint& b, const PlatePoint& c) {
    return (std::int64_t{b.x_um} - a.x_um) * (std::int64_t{c.y_um} - a.y_um) -
           (std::int64_t{b.y_um} - a.y_um) * (std::int64_t{c.x_um} - a.x_um);
}

std::int64_t squared(const PlatePoint& a, const PlatePoint& b) {
    const std::int64_t x = std::int64_t{b.x_um} - a.x_um, y = std::int64_t{b.y_um} - a.y_um;
    return x * x + y * y;
}

bool between(const PlatePoint& a, const PlatePoint& b, const PlatePoint& at) {
    return turn(a, b, at) == 0 && std::min(a.x_um, b.x_um) <= at.x_um && at.x_um <= std::max(a.x_um, b.x_um) &&
           std::min(a.y_um, b.y_um) <= at.y_um && at.y_um <= std::max(a.y_um, b.y_um);
}

// Returns whether the side a-b of a ring crosses or touches the bridge p-q, other than at an end of the bridge.
bool in_the_way(const PlatePoint& a, const PlatePoint& b, const PlatePoint& p, const PlatePoint& q) {
    for (const PlatePoint& end : {a, b})
        if (end != p && end != q && between(p, q, end)) return true;
    if (a == p || b == p || a == q || b == q) return false;
    if (between(a, b, p) || between(a, b, q)) return true;
    return (turn(p, q, a) > 0) != (turn(p, q, b) > 0) && (turn(a, b, p) > 0) != (turn(a, b, q) > 0) &&
           turn(p, q, a) != 0 && turn(p, q, b) != 0;
}

// Returns whether the direction from corner `at` of the ring to q leads into the area inside the ring.
bool looks_in(const PlateRing& ring, std::size_t at, const PlatePoint& q) {
    const PlatePoint &before = ring[(at + ring.size() - 1) % ring.size()], &here = ring[at];
    const PlatePoint& after = ring[(at + 1) % ring.size()];
    if (turn(before, here, after) >= 0) return turn(here, q, before) > 0 && turn(here, after, q) > 0;
    return !(turn(here, q, after) >= 0 && turn(here, before, q) >= 0);
}

bool free_sight(const PlateRing& ring, const PlatePoint& p, const PlatePoint& q) {
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (in_the_way(ring[i], ring[(i + 1) % ring.size()], p, q)) return false;
    return true;
}

// Makes a hole part of the ring by a bridge: two coinciding lines from the ring to the hole and back. Returns false if
// no corner of the ring has a free line to the hole.
bool join(PlateRing& ring, const std::vector<PlateRing>& holes, std::size_t which) {
    const PlateRing& hole = holes[which];
    const auto right = std::max_element(hole.begin(), hole.end(), [](const PlatePoint& a, const PlatePoint& b) {
        return a.x_um < b.x_um || (a.x_um == b.x_um && a.y_um < b.y_um);
    });
    const PlatePoint p = *right;
    std::vector<std::size_t> order(ring.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return squared(ring[a], p) < squared(ring[b], p); });
    for (const std::size_t i : order) {
        const PlatePoint q = ring[i];
        if (!looks_in(ring, i, p) || !free_sight(ring, p, q)) continue;
        bool seen = true;
        for (std::size_t k = which; seen && k < holes.size(); ++k) seen = free_sight(holes[k], p, q);
        if (!seen) continue;
        PlateRing joined(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        joined.insert(joined.end(), right, hole.end());
        joined.insert(joined.end(), hole.begin(), right);
        joined.push_back(p);
        joined.insert(joined.end(), ring.begin() + static_cast<std::ptrdiff_t>(i), ring.end());
        ring = std::move(joined);
        return true;
    }
    return false;
}

bool inside(const PlateRing& ring, const PlatePoint& at) {
    bool in = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const PlatePoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
        if ((a.y_um > at.y_um) == (b.y_um > at.y_um)) continue;
        if ((turn(a, b, at) > 0) == (b.y_um > a.y_um)) in = !in;
    }
    return in;
}

double area_um2(const PlateRing& ring) {
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const PlatePoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
        twice += static_cast<double>(a.x_um) * b.y_um - static_cast<double>(b.x_um) * a.y_um;
    }
    return 0.5 * twice;
}

PlateRing reversed(PlateRing ring) {
    std::reverse(ring.begin(), ring.end());
    return ring;
}

class Builder {
public:
    bool flat(const PlateArea& area, std::int32_t z_um, bool up) {
        const auto faces = triangulated(area);
        if (!faces) return false;
        for (const auto& face : *faces) {
            const auto at = [&](std::size_t i) {
                return std::array<std::int32_t, 3>{face[i].x_um, face[i].y_um, z_um};
            };
            if (up) made.push_back({{at(0), at(1), at(2)}});
            else made.push_back({{at(0), at(2), at(1)}});
        }
        return true;
    }

    // Adds the vertical sides along a ring, between two heights. The solid is on the left of the ring.
    void sides(const PlateRing& ring, std::int32_t low_um, std::int32_t high_um) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const PlatePoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
            made.push_back({{{{a.x_um, a.y_um, low_um}, {b.x_um, b.y_um, low_um}, {b.x_um, b.y_um, high_um}}}});
            made.push_back({{{{a.x_um, a.y_um, low_um}, {b.x_um, b.y_um, high_um}, {a.x_um, a.y_um, high_um}}}});
        }
    }

    std::vector<SolidTriangle> made;
};

}  // namespace

std::optional<std::vector<std::array<PlatePoint, 3>>> triangulated(const PlateArea& area) {
    PlateRing ring = area.rim;
    std::vector<PlateRing> holes = area.holes;
    const auto rightmost = [](const PlateRing& hole) {
        return std::max_element(hole.begin(), hole.end(),
                                [](const PlatePoint& a, const PlatePoint& b) { return a.x_um < b.x_um; })
            ->x_um;
    };
    std::stable_sort(holes.begin(), holes.end(),
                     [&](const PlateRing& a, const PlateRing& b) { return rightmost(a) > rightmost(b); });
    for (std::size_t i = 0; i < holes.size(); ++i)
        if (!join(ring, holes, i)) return std::nullopt;
    std::vector<std::array<PlatePoint, 3>> faces;
    std::vector<std::size_t> next(ring.size()), last(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
        next[i] = (i + 1) % ring.size();
        last[i] = (i + ring.size() - 1) % ring.size();
    }
    const auto is_ear = [&](std::size_t i) {
        const PlatePoint &a = ring[last[i]], &b = ring[i], &c = ring[next[i]];
        if (turn(a, b, c) <= 0) return false;
        for (std::size_t k = next[next[i]]; k != last[i]; k = next[k]) {
            const PlatePoint& p = ring[k];
            if (p == a || p == b || p == c) continue;
            if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
        }
        return true;
    };
    std::size_t i = 0, misses = 0, left = ring.size();
    while (left > 3) {
        const std::size_t a = last[i], c = next[i];
        // True if this corner only leads back along a bridge, because both lines of the bridge are used up.
        const bool back = ring[a] == ring[c];
        if (!back && !is_ear(i)) {
            if (++misses > left) return std::nullopt;
            i = c;
            continue;
        }
        if (!back) faces.push_back({ring[a], ring[i], ring[c]});
        next[a] = c;
        last[c] = a;
        --left;
        misses = 0;
        i = c;
    }
    if (turn(ring[last[i]], ring[i], ring[next[i]]) != 0) faces.push_back({ring[last[i]], ring[i], ring[next[i]]});
    return faces;
}

std::optional<std::vector<SolidTriangle>> plate_with(std::int32_t wide_um, std::int32_t deep_um, std::int32_t thick_um,
                                                     std::span<const RaisedArea> raised) {
    // The horizontal surfaces between the raised areas: that of the plate, and one in each hole of a raised area.
    std::vector<PlateArea> floors{{{{0, 0}, {wide_um, 0}, {wide_um, deep_um}, {0, deep_um}}, {}}};
    const PlateArea bottom = floors.front();
    for (const RaisedArea& one : raised)
        for (const PlateRing& hole : one.area.holes) floors.push_back({reversed(hole), {}});
    for (const RaisedArea& one : raised) {
        std::size_t best = 0;
        for (std::size_t i = 1; i < floors.size(); ++i)
            if (inside(floors[i].rim, one.area.rim.front()) && area_um2(floors[i].rim) > area_um2(one.area.rim) &&
                (best == 0 || area_um2(floors[i].rim) < area_um2(floors[best].rim)))
                best = i;
        floors[best].holes.push_back(reversed(one.area.rim));
    }
    Builder builder;
    if (!builder.flat(bottom, 0, false)) return std::nullopt;
    builder.sides(bottom.rim, 0, thick_um);
    for (const PlateArea& floor : floors)
        if (!builder.flat(floor, thick_um, true)) return std::nullopt;
    for (const RaisedArea& one : raised) {
        if (!builder.flat(one.area, thick_um + one.height_um, true)) return std::nullopt;
        builder.sides(one.area.rim, thick_um, thick_um + one.height_um);
        for (const PlateRing& hole : one.area.holes) builder.sides(hole, thick_um, thick_um + one.height_um);
    }
    return std::move(builder.made);
}

SolidCheck check_solid(std::span<const SolidTriangle> triangles) {
    using Corner = std::array<std::int32_t, 3>;
    std::map<std::pair<Corner, Corner>, int> edges;
    SolidCheck check;
    for (const SolidTriangle& triangle : triangles) {
        double p[3][3];
        for (std::size_t i = 0; i < 3; ++i) {
            ++edges[{triangle.corners_um[i], triangle.corners_um[(i + 1) % 3]}];
            for (std::size_t axis = 0; axis < 3; ++axis) p[i][axis] = 1e-3 * triangle.corners_um[i][axis];
        }
        const double cross[3] = {p[1][1] * p[2][2] - p[1][2] * p[2][1], p[1][2] * p[2][0] - p[1][0] * p[2][2],
                                 p[1][0] * p[2][1] - p[1][1] * p[2][0]};
        check.volume_mm3 += (p[0][0] * cross[0] + p[0][1] * cross[1] + p[0][2] * cross[2]) / 6.0;
        double side[2][3], area[3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            side[0][axis] = p[1][axis] - p[0][axis];
            side[1][axis] = p[2][axis] - p[0][axis];
        }
        for (std::size_t axis = 0; axis < 3; ++axis)
            area[axis] =
                side[0][(axis + 1) % 3] * side[1][(axis + 2) % 3] - side[0][(axis + 2) % 3] * side[1][(axis + 1) % 3];
        check.flat += area[0] * area[0] + area[1] * area[1] + area[2] * area[2] < 1e-18 ? 1 : 0;
    }
    for (const auto& [edge, count] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        if (back == edges.end()) ++check.open_edges;
        else if (count != 1 || back->second != 1) ++check.crowded_edges;
    }
    return check;
}

std::string stl_of(std::span<const SolidTriangle> triangles) {
    std::string out(80, '\0');
    const auto number = [&out](std::uint32_t value, int bytes) {
        for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i) & 0xFFU);
    };
    const auto real = [&](double value) { number(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4); };
    number(static_cast<std::uint32_t>(triangles.size()), 4);
    for (const SolidTriangle& triangle : triangles) {
        double side[2][3], normal[3];
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t i = 0; i < 2; ++i)
                side[i][axis] = static_cast<double>(triangle.corners_um[i + 1][axis]) - triangle.corners_um[0][axis];
        for (std::size_t axis = 0; axis < 3; ++axis)
            normal[axis] =
                side[0][(axis + 1) % 3] * side[1][(axis + 2) % 3] - side[0][(axis + 2) % 3] * side[1][(axis + 1) % 3];
        const double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        for (const double part : normal) real(length > 0.0 ? part / length : 0.0);
        for (const auto& corner : triangle.corners_um)
            for (const std::int32_t part : corner) real(1e-3 * part);
        number(0, 2);
    }
    return out;
}

}  // namespace handrail::exports
