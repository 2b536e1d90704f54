#include "app/window/draw_mesh.h"

#include <map>
#include <tuple>
#include <unordered_map>

namespace handrail::window {
namespace {

// Greatest distance of points from a line on which they are. It is far above the rounding of file coordinates, and far
// too small to be visible.
constexpr double kSameLine_m = 1e-4;
constexpr double kAngleCell_rad = 1e-3;
constexpr double kOffsetCell_m = 1e-3;

// Two perpendicular unit vectors in a plane: u is level, and v is as upright as the plane allows.
struct PlaneAxes {
    Vec3 u, v;
};

// Returns the axes in which the patterns of a surface are drawn, so that stripes look upright or level in the room.
PlaneAxes axes_of(const Vec3& normal) {
    const Vec3 level = glm::cross(Vec3(0.0, 0.0, 1.0), normal);
    const double length = glm::length(level);
    const Vec3 u = length > 1e-6 ? level / length : Vec3(1.0, 0.0, 0.0);
    return {u, glm::cross(normal, u)};
}

// An edge of a polygon as a piece of a line in the polygon's plane. The direction of the line has an angle in [0, pi).
// t is the position along the line.
struct PlaneEdge {
    Vec3 a_m, b_m;
    double angle_rad = 0.0;
    double offset_m = 0.0;  // distance of the line from the origin of the plane's axes
    double t_from_m = 0.0, t_to_m = 0.0;
    bool forward = true;  // true if the polygon's corners follow the line's direction
};

PlaneEdge plane_edge(const Vec3& a_m, const Vec3& b_m, const PlaneAxes& axes) {
    const Vec2 a(glm::dot(a_m, axes.u), glm::dot(a_m, axes.v));
    const Vec2 b(glm::dot(b_m, axes.u), glm::dot(b_m, axes.v));
    PlaneEdge edge{a_m, b_m};
    edge.angle_rad = std::atan2(b.y - a.y, b.x - a.x);
    if (edge.angle_rad < 0.0 || edge.angle_rad >= kPi) {
        edge.angle_rad += edge.angle_rad < 0.0 ? kPi : -kPi;
        edge.forward = false;
    }
    const Vec2 along(std::cos(edge.angle_rad), std::sin(edge.angle_rad));
    edge.offset_m = a.x * -along.y + a.y * along.x;
    edge.t_from_m = std::min(glm::dot(a, along), glm::dot(b, along));
    edge.t_to_m = std::max(glm::dot(a, along), glm::dot(b, along));
    return edge;
}

// Finds the outline of coplanar pieces: the parts of their edges across which no other piece continues.
class Outline {
public:
    void add(const Polygon& polygon, const PlaneAxes& axes, const Vec3& origin_m) {
        const auto& points = polygon.points_m;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec3 a = points[i] - origin_m, b = points[(i + 1) % points.size()] - origin_m;
            if (glm::distance(a, b) < kSameLine_m) continue;
            edges_.push_back(plane_edge(a, b, axes));
        }
    }

    void append_open_edges(std::vector<DrawEdge>& out) const {
        std::unordered_map<std::int64_t, std::vector<std::uint32_t>> cells;
        for (std::uint32_t i = 0; i < edges_.size(); ++i)
            cells[cell(edges_[i].angle_rad, edges_[i].offset_m, 0, 0)].push_back(i);
        std::vector<std::pair<double, double>> covered;
        for (const PlaneEdge& edge : edges_) {
            covered.clear();
            for (int da = -1; da <= 1; ++da)
                for (int d_offset = -1; d_offset <= 1; ++d_offset)
                    if (const auto found = cells.find(cell(edge.angle_rad, edge.offset_m, da, d_offset));
                        found != cells.end())
                        for (const std::uint32_t i : found->second) cover(edge, edges_[i], covered);
            append_rest(edge, covered, out);
        }
    }

private:
    static std::int64_t cell(double angle_rad, double offset_m, int d_angle, int d_offset) {
        const std::int64_t angles = std::llround(kPi / kAngleCell_rad);
        std::int64_t angle = std::llround(angle_rad / kAngleCell_rad) + d_angle;
        double offset = offset_m;
        // Angles of lines repeat after pi, but with the opposite direction. So an angle outside the range moves to the
        // other end, and the offset changes its sign.
        if (angle < 0 || angle >= angles) {
            angle += angle < 0 ? angles : -angles;
            offset = -offset;
        }
        return angle * (std::int64_t{1} << 40) + std::llround(offset / kOffsetCell_m) + d_offset;
    }

    static void cover(const PlaneEdge& edge, const PlaneEdge& other, std::vector<std::pair<double, double>>& covered) {
        const double turned = std::abs(edge.angle_rad - other.angle_rad) > kPi / 2 ? -1.0 : 1.0;
        // The other piece is on the same side of the edge, so the surface does not continue there.
        if (edge.forward == (other.forward == (turned > 0.0))) return;
        const Vec3 along = (edge.b_m - edge.a_m) / glm::distance(edge.a_m, edge.b_m);
        for (const Vec3& p : {other.a_m, other.b_m}) {
            const Vec3 to = p - edge.a_m;
            if (glm::length(to - along * glm::dot(to, along)) > kSameLine_m) return;
        }
        const double from = glm::dot(other.a_m - edge.a_m, along), to = glm::dot(other.b_m - edge.a_m, along);
        covered.emplace_back(std::min(from, to), std::max(from, to));
    }

    static void append_rest(const PlaneEdge& edge, std::vector<std::pair<double, double>>& covered,
                            std::vector<DrawEdge>& out) {
        std::sort(covered.begin(), covered.end());
        const double length = glm::distance(edge.a_m, edge.b_m);
        const Vec3 along = (edge.b_m - edge.a_m) / length;
        const auto emit = [&](double from, double to) {
            if (to - from < 2.0 * kSameLine_m) return;
            const Vec3 a = edge.a_m + along * from, b = edge.a_m + along * to;
            out.push_back({{static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)},
                           {static_cast<float>(b.x), static_cast<float>(b.y), static_cast<float>(b.z)}});
        };
        double open_from = 0.0;
        for (const auto& [from, to] : covered) {
            emit(open_from, std::min(from, length));
            open_from = std::max(open_from, to);
        }
        emit(open_from, length);
    }

    std::vector<PlaneEdge> edges_;
};

class MeshBuilder {
public:
    explicit MeshBuilder(const Vec3& origin_m) { mesh_.origin_m = origin_m; }

    void add(const Polygon& polygon, const Vec3& normal, FeatureId feature, const DrawLook& look, bool both_sides) {
        const auto& points = polygon.points_m;
        if (points.size() < 3) return;
        const PlaneAxes axes = axes_of(normal);
        const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
        Aabb bounds;
        for (const Vec3& point : points) {
            const Vec3 p = point - mesh_.origin_m;
            bounds.include(p);
            mesh_.vertices.push_back(
                {{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
                 {static_cast<float>(glm::dot(p, axes.u)), static_cast<float>(glm::dot(p, axes.v))},
                 look.rgb,
                 look.pattern});
        }
        Part& part = part_at(bounds.centre_m());
        if (!look.translucent) part.bounds_m.include(bounds);
        auto& indices = look.translucent ? mesh_.translucent : part.opaque;
        for (std::uint32_t i = 1; i + 1 < points.size(); ++i) {
            indices.insert(indices.end(), {first, first + i, first + i + 1});
            if (both_sides) indices.insert(indices.end(), {first, first + i + 1, first + i});
        }

        // Because of rounding, two coplanar pieces can have different keys. A line is then drawn between them, which is
        // harmless.
        const Vec3 local = points.front() - mesh_.origin_m;
        const auto rounded = [](double value) { return std::llround(value * 1000.0); };
        const auto key = std::tuple(feature.value, rounded(normal.x), rounded(normal.y), rounded(normal.z),
                                    rounded(glm::dot(normal, local)));
        outlines_[key].add(polygon, axes, mesh_.origin_m);
    }

    DrawMesh finish() {
        std::vector<DrawEdge> edges;
        for (const auto& [key, outline] : outlines_) outline.append_open_edges(edges);
        for (const DrawEdge& edge : edges) {
            const Vec3 a(edge.a_m[0], edge.a_m[1], edge.a_m[2]), b(edge.b_m[0], edge.b_m[1], edge.b_m[2]);
            Part& part = part_at(0.5 * (a + b));
            part.bounds_m.include(a);
            part.bounds_m.include(b);
            part.edges.push_back(edge);
        }
        for (const auto& [cell, part] : parts_) {
            if (part.bounds_m.empty()) continue;
            mesh_.chunks.push_back({part.bounds_m, static_cast<std::uint32_t>(mesh_.opaque.size()),
                                    static_cast<std::uint32_t>(part.opaque.size()),
                                    static_cast<std::uint32_t>(mesh_.edges.size()),
                                    static_cast<std::uint32_t>(part.edges.size())});
            mesh_.opaque.insert(mesh_.opaque.end(), part.opaque.begin(), part.opaque.end());
            mesh_.edges.insert(mesh_.edges.end(), part.edges.begin(), part.edges.end());
        }
        return std::move(mesh_);
    }

private:
    struct Part {
        Aabb bounds_m;
        std::vector<std::uint32_t> opaque;
        std::vector<DrawEdge> edges;
    };
    Part& part_at(const Vec3& local_m) {
        const glm::dvec3 cell = glm::floor(local_m / kChunk_m);
        return parts_[{std::llround(cell.x), std::llround(cell.y), std::llround(cell.z)}];
    }

    DrawMesh mesh_;
    std::map<std::array<std::int64_t, 3>, Part> parts_;
    std::map<std::tuple<std::uint32_t, std::int64_t, std::int64_t, std::int64_t, std::int64_t>, Outline> outlines_;
};

std::array<std::uint8_t, 3> grey(double level) {
    const auto value = static_cast<std::uint8_t>(std::lround(255.0 * level));
    return {value, value, value};
}

}  // namespace

DrawLook look_of(FeatureKind kind, SolidRole role, const Vec3& normal) {
    if (role == SolidRole::Liquid || kind == FeatureKind::Liquid) return {{60, 130, 190}, DrawPattern::Slanted, true};
    switch (kind) {
        case FeatureKind::Door:
            return {{255, 240, 120}, DrawPattern::UprightStripes, false};
        case FeatureKind::Lift:
        case FeatureKind::Mover:
            return {{190, 230, 255}, DrawPattern::LevelStripes, false};
        case FeatureKind::Button:
        case FeatureKind::Teleport:
            return {{255, 255, 255}, DrawPattern::Checks, false};
        default:
            break;
    }
    if (role == SolidRole::Mover) return {{190, 230, 255}, DrawPattern::LevelStripes, false};
    const bool object = kind == FeatureKind::Object;
    if (normal.z > 0.9)
        return {object ? std::array<std::uint8_t, 3>{150, 110, 70} : std::array<std::uint8_t, 3>{34, 42, 66},
                DrawPattern::Plain, false};
    if (normal.z < -0.9) return {grey(object ? 0.30 : 0.36), DrawPattern::Plain, false};
    if (normal.z > 0.2) return {{56, 66, 90}, DrawPattern::Plain, false};
    // Walls that face east and west are lighter than those that face north and south. So the corner between two walls
    // is visible even without an outline.
    const double level = 0.64 + 0.14 * std::abs(normal.x);
    if (!object) return {grey(level), DrawPattern::Plain, false};
    return {{static_cast<std::uint8_t>(std::lround(255.0 * (level + 0.15))),
             static_cast<std::uint8_t>(std::lround(255.0 * (level - 0.08))),
             static_cast<std::uint8_t>(std::lround(255.0 * (level - 0.30)))},
            DrawPattern::Plain,
            false};
}

double luminance(const std::array<std::uint8_t, 3>& rgb) { return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]; }

DrawMesh build_draw_mesh(const Scene& scene, const std::function<bool(FeatureId)>& drawn) {
    const auto left_out = [&](FeatureId id) { return drawn && !drawn(id); };
    const auto kind_of = [&](FeatureId id) {
        const Feature* feature = scene.find(id);
        return feature ? feature->kind : FeatureKind::Wall;
    };
    Aabb bounds;
    for (const SurfacePolygon& surface : scene.surfaces)
        if (!left_out(surface.feature))
            for (const Vec3& p : surface.polygon.points_m) bounds.include(p);
    for (const MeshTriangle& triangle : scene.triangles)
        if (!left_out(triangle.feature))
            for (const Vec3& p : {triangle.a_m, triangle.b_m, triangle.c_m}) bounds.include(p);

    MeshBuilder builder(bounds.empty() ? Vec3(0.0) : bounds.centre_m());
    for (const SurfacePolygon& surface : scene.surfaces) {
        if (surface.role == SolidRole::Trigger || surface.role == SolidRole::BodyClip || left_out(surface.feature))
            continue;
        builder.add(surface.polygon, surface.normal, surface.feature,
                    look_of(kind_of(surface.feature), surface.role, surface.normal), false);
    }
    for (const MeshTriangle& triangle : scene.triangles) {
        const Vec3 across = glm::cross(triangle.b_m - triangle.a_m, triangle.c_m - triangle.a_m);
        const double twice_area_m2 = glm::length(across);
        // Leave out degenerate triangles, which are invisible.
        if (twice_area_m2 < 1e-12 || left_out(triangle.feature)) continue;
        const Vec3 normal = across / twice_area_m2;
        builder.add({{triangle.a_m, triangle.b_m, triangle.c_m}}, normal, triangle.feature,
                    look_of(kind_of(triangle.feature), SolidRole::Solid, normal), true);
    }
    return builder.finish();
}

}  // namespace handrail::window
