#include "worlds/ifc/body.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>

#include "worlds/geometry/clip.h"
#include "worlds/geometry/mass_properties.h"

namespace handrail::ifc {
namespace {

constexpr CutTolerance kTolerance{1e-6, 1e-5};
constexpr double kLeast_m3 = 1e-9;  // solids with less volume than this are left out

Vec3 snapped(Vec3 normal) {
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(normal[axis]) < 1.0 - 1e-11) continue;
        const double sign = normal[axis] > 0.0 ? 1.0 : -1.0;
        normal = Vec3{0.0};
        normal[axis] = sign;
    }
    return normal;
}

// Sets `plane` to the plane through the middle of the polygon that has the polygon's normal. Returns false if the
// polygon has no area.
bool plane_of(std::span<const Vec3> points_m, Plane& plane) {
    const Vec3 area = area_vector_m2(points_m);
    const double length = glm::length(area);
    if (!(length > 1e-10) || !std::isfinite(length)) return false;
    plane.normal = snapped(area / length);
    double sum = 0.0;
    for (const Vec3& p : points_m) sum += glm::dot(plane.normal, p);
    plane.offset_m = sum / static_cast<double>(points_m.size());
    if (std::max({std::abs(plane.normal.x), std::abs(plane.normal.y), std::abs(plane.normal.z)}) == 1.0)
        plane.offset_m = std::round(plane.offset_m * 1e6) / 1e6;
    return true;
}

Plane turned_round(const Plane& plane) { return {-plane.normal, -plane.offset_m}; }

// Returns the part of the solid behind the plane. Nothing if that part is nowhere thicker than kFlush_m.
std::optional<ConvexSolid> behind(const ConvexSolid& solid, const Plane& plane) {
    const Reach reach = reach_along(solid, plane.normal);
    if (reach.least >= plane.offset_m - kFlush_m) return {};
    if (reach.most <= plane.offset_m + kFlush_m) return solid;
    std::vector<Plane> planes = solid.planes;
    planes.push_back(plane);
    return solid_within(std::move(planes), solid.bounds_m.centre_m(), glm::length(solid.bounds_m.size_m()));
}

// Splits a sheet by a plane. If the sheet is in the plane, both `back` and `front` receive the whole sheet.
void split_sheet(const Polygon& sheet, const Plane& plane, Polygon& back, Polygon& front) {
    split(sheet.points_m, plane, kTolerance.cut_m, back.points_m, front.points_m);
    tidy(back.points_m, kTolerance.merge_m);
    tidy(front.points_m, kTolerance.merge_m);
}

// Returns the box that the axis-aligned planes bound, for a quick rejection test. In unbounded directions the box
// extends very far.
Aabb box_of(std::span<const Plane> planes) {
    Aabb box{Vec3{-1e9}, Vec3{1e9}};
    for (const Plane& p : planes)
        for (int axis = 0; axis < 3; ++axis) {
            if (p.normal[axis] == 1.0) box.max_m[axis] = std::min(box.max_m[axis], p.offset_m);
            if (p.normal[axis] == -1.0) box.min_m[axis] = std::max(box.min_m[axis], -p.offset_m);
        }
    return box;
}

}  // namespace

Aabb Body::bounds_m() const {
    Aabb box;
    for (const ConvexSolid& solid : solids) box.include(solid.bounds_m);
    for (const Polygon& sheet : sheets) box.include(bounds_of(sheet));
    return box;
}

void Body::add(Body other) {
    solids.insert(solids.end(), std::make_move_iterator(other.solids.begin()),
                  std::make_move_iterator(other.solids.end()));
    sheets.insert(sheets.end(), std::make_move_iterator(other.sheets.begin()),
                  std::make_move_iterator(other.sheets.end()));
}

std::optional<ConvexSolid> solid_within(std::vector<Plane> planes, const Vec3& near_m, double reach_m) {
    if (!is_finite(near_m) || !(reach_m > kFlush_m) || reach_m > 1e7 || planes.size() > 2000) return {};
    BuiltSolid built = solid_from_planes(planes, near_m, reach_m, kTolerance);
    if (built.fault != SolidFault::None || built.was_inside_out || built.solid.faces.size() < 4) return {};
    return std::move(built.solid);
}

std::optional<ConvexSolid> prism(const Ring& outline, const Vec3& way_m, const Frame& frame) {
    std::vector<Vec3> low, high;
    for (const Vec2& p : outline) {
        low.push_back(frame.at({p.x, p.y, 0.0}));
        high.push_back(frame.at(Vec3(p.x, p.y, 0.0) + way_m));
    }
    Aabb box;
    for (const std::vector<Vec3>* ring : {&low, &high})
        for (const Vec3& p : *ring) {
            if (!is_finite(p)) return {};
            box.include(p);
        }
    // The centre of the bounding box may be outside a slanted prism, so the direction of each face is derived from the
    // orientation of the outline.
    const bool turned = ((signed_area(outline) < 0.0) != (way_m.z < 0.0)) != frame.mirrored();
    std::vector<Plane> planes;
    std::vector<std::vector<Vec3>> sides;
    const auto add = [&](std::vector<Vec3> face) {
        Plane plane;
        if (plane_of(face, plane)) planes.push_back(turned ? turned_round(plane) : plane);
        sides.push_back(std::move(face));
    };
    add({low.rbegin(), low.rend()});
    add(high);
    for (std::size_t i = 0; i < low.size(); ++i) {
        const std::size_t j = (i + 1) % low.size();
        add({low[i], low[j], high[j], high[i]});
    }
    std::optional<ConvexSolid> built = solid_within(planes, box.centre_m(), glm::length(box.size_m()));
    const double holds_m3 = std::abs(glm::dot(area_vector_m2(low), frame.turned(way_m)));
    if (built || planes.size() != sides.size() || !(holds_m3 > kLeast_m3)) return built;
    // The prism is too thin to be built from its planes, so the given corners are used.
    ConvexSolid exact{std::move(planes), {}, box};
    for (std::vector<Vec3>& side : sides) {
        if (turned) std::reverse(side.begin(), side.end());
        exact.faces.push_back({std::move(side)});
    }
    return exact;
}

std::optional<ConvexSolid> box_solid(const Vec3& least_m, const Vec3& most_m, const Frame& frame) {
    Frame lifted = frame;
    lifted.origin_m = frame.at({0.0, 0.0, least_m.z});
    return prism({{least_m.x, least_m.y}, {most_m.x, least_m.y}, {most_m.x, most_m.y}, {least_m.x, most_m.y}},
                 {0.0, 0.0, most_m.z - least_m.z}, lifted);
}

bool same_body(const Body& a, const Body& b) {
    const auto same_plane = [](const Plane& p, const Plane& q) {
        return p.normal == q.normal && p.offset_m == q.offset_m;
    };
    const auto same_polygon = [](const Polygon& p, const Polygon& q) { return p.points_m == q.points_m; };
    const auto same_solid = [&](const ConvexSolid& p, const ConvexSolid& q) {
        return std::ranges::equal(p.planes, q.planes, same_plane) && std::ranges::equal(p.faces, q.faces, same_polygon);
    };
    return std::ranges::equal(a.solids, b.solids, same_solid) && std::ranges::equal(a.sheets, b.sheets, same_polygon);
}

std::uint64_t number_of(const Body& body) {
    std::uint64_t number = 0xCBF29CE484222325U;
    const auto put = [&number](double value) {
        number = (number ^ std::bit_cast<std::uint64_t>(value + 0.0)) * 0x100000001B3U;  // adding 0.0 turns -0 into 0
        number ^= number >> 29;
    };
    for (const ConvexSolid& solid : body.solids)
        for (const Plane& plane : solid.planes)
            for (const double value : {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset_m}) put(value);
    for (const Polygon& sheet : body.sheets)
        for (const Vec3& p : sheet.points_m)
            for (int axis = 0; axis < 3; ++axis) put(p[axis]);
    return number;
}

double volume_m3(const Body& body) {
    double sum = 0.0;
    for (const ConvexSolid& solid : body.solids) sum += mass_properties(solid).volume_m3;
    double six_volumes = 0.0;
    for (const Polygon& sheet : body.sheets)
        six_volumes += 2.0 * glm::dot(area_vector_m2(sheet.points_m), sheet.points_m[0] - body.sheets[0].points_m[0]);
    return sum + std::abs(six_volumes) / 6.0;
}

std::optional<double> enclosed_m3(const std::vector<FlatFace>& faces) {
    using Corner = std::array<long long, 3>;
    const auto corner = [](const Vec3& p) {
        const Vec3 scaled = glm::clamp(p * 1e5, Vec3(-9e17), Vec3(9e17));
        return Corner{std::llround(scaled.x), std::llround(scaled.y), std::llround(scaled.z)};
    };
    // For each edge, the number of times the faces use it in one direction, minus the number in the other direction.
    std::map<std::pair<Corner, Corner>, int> edges;
    double six_volumes = 0.0;
    const Vec3* origin = nullptr;
    for (const FlatFace& face : faces) {
        Vec3 outer{0.0};
        for (std::size_t r = 0; r < face.rings.size(); ++r) {
            std::vector<Vec3> ring = face.rings[r];
            if (ring.size() < 3) continue;
            if (!std::all_of(ring.begin(), ring.end(), [](const Vec3& p) { return is_finite(p); })) return {};
            Vec3 area = area_vector_m2(ring);
            if (r == 0) outer = area;
            else if (glm::dot(area, outer) > 0.0) std::reverse(ring.begin(), ring.end()), area = -area;
            if (!origin) origin = &face.rings[r][0];
            six_volumes += 2.0 * glm::dot(area, ring[0] - *origin);
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Corner a = corner(ring[i]), b = corner(ring[(i + 1) % ring.size()]);
                if (a != b) edges[std::minmax(a, b)] += a < b ? 1 : -1;
            }
        }
    }
    if (std::any_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second != 0; })) return {};
    return std::abs(six_volumes) / 6.0;
}

Body transformed(const Body& body, const Frame& frame) {
    Body moved;
    for (const ConvexSolid& solid : body.solids) {
        Aabb box;
        for (const Polygon& face : solid.faces)
            for (const Vec3& p : face.points_m) box.include(frame.at(p));
        if (box.empty() || !is_finite(box.min_m) || !is_finite(box.max_m)) continue;
        std::vector<Plane> planes;
        for (const Polygon& face : solid.faces) {
            std::vector<Vec3> points;
            for (const Vec3& p : face.points_m) points.push_back(frame.at(p));
            Plane plane;
            if (!plane_of(points, plane)) continue;
            planes.push_back(frame.mirrored() ? turned_round(plane) : plane);
        }
        if (std::optional<ConvexSolid> built =
                solid_within(std::move(planes), box.centre_m(), glm::length(box.size_m())))
            moved.solids.push_back(std::move(*built));
    }
    for (const Polygon& sheet : body.sheets) {
        Polygon there;
        for (const Vec3& p : sheet.points_m) there.points_m.push_back(frame.at(p));
        if (std::all_of(there.points_m.begin(), there.points_m.end(), [](const Vec3& p) { return is_finite(p); }))
            moved.sheets.push_back(std::move(there));
    }
    return moved;
}

int drop_far(Body& body) {
    const auto far = [](const Aabb& box) {
        const Vec3 size = glm::max(glm::abs(box.min_m), glm::abs(box.max_m));
        return !(std::max({size.x, size.y, size.z}) <= kFarthestPart_m);
    };
    const auto solids = std::erase_if(body.solids, [&](const ConvexSolid& solid) { return far(solid.bounds_m); });
    const auto sheets = std::erase_if(body.sheets, [&](const Polygon& sheet) { return far(bounds_of(sheet)); });
    return static_cast<int>(solids + sheets);
}

Reach reach_along(const ConvexSolid& solid, const Vec3& direction) {
    Reach reach{1e300, -1e300};
    for (const Polygon& face : solid.faces)
        for (const Vec3& p : face.points_m) {
            reach.least = std::min(reach.least, glm::dot(p, direction));
            reach.most = std::max(reach.most, glm::dot(p, direction));
        }
    return reach;
}

std::optional<Reach> reach_along(const Body& body, const Vec3& direction) {
    if (body.empty()) return {};
    Reach reach{1e300, -1e300};
    for (const ConvexSolid& solid : body.solids) {
        const Reach one = reach_along(solid, direction);
        reach = {std::min(reach.least, one.least), std::max(reach.most, one.most)};
    }
    for (const Polygon& sheet : body.sheets)
        for (const Vec3& p : sheet.points_m)
            reach = {std::min(reach.least, glm::dot(p, direction)), std::max(reach.most, glm::dot(p, direction))};
    return reach;
}

bool cut_away(Body& body, std::span<const Plane> planes) {
    constexpr std::size_t kMostPieces = 5000;
    const Aabb box = grown(box_of(planes), kFlush_m);
    bool changed = false;
    std::vector<ConvexSolid> left;
    for (ConvexSolid& solid : body.solids) {
        std::optional<ConvexSolid> rest;
        if (overlap(box, solid.bounds_m) && left.size() < kMostPieces) rest = solid;
        for (const Plane& plane : planes)
            if (rest) rest = behind(*rest, plane);
        if (!rest) {  // the solid and the cutter do not overlap
            left.push_back(std::move(solid));
            continue;
        }
        changed = true;
        ConvexSolid inner = std::move(solid);
        for (const Plane& plane : planes) {
            if (std::optional<ConvexSolid> outside = behind(inner, turned_round(plane)))
                left.push_back(std::move(*outside));
            std::optional<ConvexSolid> within = behind(inner, plane);
            if (!within) break;
            inner = std::move(*within);
        }
    }
    body.solids = std::move(left);
    std::vector<Polygon> sheets;
    for (Polygon& sheet : body.sheets) {
        if (!overlap(box, bounds_of(sheet))) {
            sheets.push_back(std::move(sheet));
            continue;
        }
        std::vector<Polygon> outside;
        Polygon inner = sheet, back, front;
        for (const Plane& plane : planes) {
            split_sheet(inner, plane, back, front);
            if (front.points_m.size() >= 3) outside.push_back(front);
            inner = back;
            if (inner.points_m.size() < 3) break;
        }
        if (inner.points_m.size() < 3) {
            sheets.push_back(std::move(sheet));
            continue;
        }
        changed = true;
        sheets.insert(sheets.end(), outside.begin(), outside.end());
    }
    body.sheets = std::move(sheets);
    return changed;
}

void keep_within(Body& body, std::span<const Plane> planes) {
    std::vector<ConvexSolid> solids;
    for (const ConvexSolid& solid : body.solids) {
        std::optional<ConvexSolid> rest = solid;
        for (const Plane& plane : planes)
            if (rest) rest = behind(*rest, plane);
        if (rest) solids.push_back(std::move(*rest));
    }
    body.solids = std::move(solids);
    std::vector<Polygon> sheets;
    for (const Polygon& sheet : body.sheets) {
        Polygon inner = sheet, back, front;
        for (const Plane& plane : planes) {
            split_sheet(inner, plane, back, front);
            inner = back;
            if (inner.points_m.size() < 3) break;
        }
        if (inner.points_m.size() >= 3) sheets.push_back(std::move(inner));
    }
    body.sheets = std::move(sheets);
}

bool crosses(const Body& body, const Vec3& low, const Vec3& high) {
    const Vec3 way = high - low;
    for (const ConvexSolid& solid : body.solids) {
        double from = 0.0, to = 1.0;
        for (const Plane& plane : solid.planes) {
            const double at = signed_distance(plane, low), slope = glm::dot(plane.normal, way);
            if (std::abs(slope) < 1e-12) to = at > 0.0 ? -1.0 : to;
            else if (slope > 0.0) to = std::min(to, -at / slope);
            else from = std::max(from, -at / slope);
        }
        if (from <= to) return true;
    }
    for (const Polygon& sheet : body.sheets) {
        Ring ring;
        for (const Vec3& p : sheet.points_m) ring.emplace_back(p.x, p.y);
        const Vec3 area = area_vector_m2(sheet.points_m);
        if (std::abs(area.z) < 1e-9 || !inside({ring}, {low.x, low.y})) continue;
        const double z = sheet.points_m[0].z -
                         (area.x * (low.x - sheet.points_m[0].x) + area.y * (low.y - sheet.points_m[0].y)) / area.z;
        if (z >= low.z && z <= high.z) return true;
    }
    return false;
}

bool meets(const Body& body, const ConvexSolid& shape) {
    const Aabb box = grown(shape.bounds_m, -kFlush_m);
    for (const ConvexSolid& solid : body.solids) {
        if (!overlap(box, solid.bounds_m)) continue;
        std::optional<ConvexSolid> rest = solid;
        for (const Plane& plane : shape.planes)
            if (rest) rest = behind(*rest, plane);
        if (rest) return true;
    }
    for (const Polygon& sheet : body.sheets) {
        if (!overlap(box, bounds_of(sheet))) continue;
        Polygon inner = sheet, back, front;
        for (const Plane& plane : shape.planes) {
            split_sheet(inner, {plane.normal, plane.offset_m - kFlush_m}, back, front);
            inner = back;
            if (inner.points_m.size() < 3) break;
        }
        if (inner.points_m.size() >= 3) return true;
    }
    return false;
}

}  // namespace handrail::ifc
