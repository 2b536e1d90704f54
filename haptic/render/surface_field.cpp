#include "haptic/render/surface_field.h"

#include <algorithm>
#include <cmath>

#include "haptic/render/tick_math.h"

namespace handrail::render {
namespace {

// Least cosine between the normals of a hold and its face; below it, the proxy is at an edge.
constexpr double kFlat = 1.0 - 1e-12;

// Adds the distances along this face to the other faces of the solid. A border is ignored if the solid continues under
// another solid there.
void borders_of_box(const HapticScene& shape, const Obstacle& o, std::uint32_t face, const Vec3& at,
                    ReliefBorder& border) noexcept {
    const Aabb& box = shape.boxes[o.shape];
    const double rounding = shape.rounding_m(o);  // the rounded margin does not belong to the flat face
    for (std::uint32_t side = 0; side < 6; ++side) {
        if (side / 2 == face / 2 || shape.labels[o.first_label + side].hidden) continue;
        const auto axis = static_cast<int>(side / 2);
        Vec3 away(0.0);
        away[axis] = side % 2 == 1 ? -1.0 : 1.0;
        border.add((side % 2 == 1 ? box.max_m[axis] - at[axis] : at[axis] - box.min_m[axis]) - rounding, away);
    }
}

void borders_of_brush(const HapticScene& shape, const Obstacle& o, std::uint32_t face, const Vec3& at,
                      ReliefBorder& border) noexcept {
    const Plane& own = shape.planes[o.shape + face];
    const Vec3 on_face = at - own.normal * signed_distance(own, at);
    const double rounding = shape.rounding_m(o);
    for (std::uint32_t side = 0; side < o.planes; ++side) {
        if (side == face || shape.labels[o.first_label + side].hidden) continue;
        const Plane& other = shape.planes[o.shape + side];
        const double turn = glm::dot(other.normal, own.normal);
        const Vec3 along = other.normal - own.normal * turn;
        const double sine = std::sqrt(glm::dot(along, along));
        if (sine < 1e-6) continue;  // skips the opposite face
        border.add((-signed_distance(other, on_face) - rounding * (1.0 - turn)) / sine, along / -sine);
    }
}

// Depth of press over which the shading rises to its full strength, so that a touch begins without a jump. The depth is
// greater if facets rise high.
constexpr double kShadingSetsIn_hand_m = 1e-3;
constexpr double kSetInPerRise = 4.0;
// Least squared cosine between the normals of hold and facet; below it, the proxy is at an edge or corner.
constexpr double kFlatFacet = 1.0 - 1e-10;

struct Rise {
    double height_m = 0.0;
    Vec3 slope{0.0};
};

Rise rise_over_facet(const std::array<Vec3, 3>& p, const MeshShading::Facet& facet, const Vec3& across,
                     const Vec3& at) noexcept {
    const double size2 = glm::dot(across, across);
    std::array<Vec3, 3> slope;
    std::array<double, 3> share;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        slope[i] = glm::cross(across, p[(i + 2) % 3] - p[next]) / size2;
        share[i] = glm::dot(slope[i], at - p[next]);
    }
    Rise rise;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        const double four = 4.0 * static_cast<double>(facet.sagitta_m[i]);
        rise.height_m += four * share[i] * share[next];
        rise.slope += (slope[i] * share[next] + slope[next] * share[i]) * four;
    }
    return rise;
}

// Returns the rise while the proxy rolls round a smooth edge. A term is added to the potential that makes it depend
// only on the distance along the edge's own normal m, so the force stays along m. Let d be the vector from the edge to
// the hand, rho = d.n the distance, and c the cosine from m to the facets. Then the term is rho - d.m / c, which is 0
// where the facets begin. It fades towards the edge's ends, because round a corner the proxy simply rolls.
Rise rise_over_edge(const HapticScene& shape, const std::array<Vec3, 3>& p, const MeshShading::Facet& facet,
                    const Vec3& across, double side, const FieldRequest& request) noexcept {
    constexpr double kRunOut = 0.1;  // share of the edge's length, at each end, over which the added term fades
    const Vec3 foot = request.proxy_m - request.normal * request.radius_m;
    std::size_t edge = 0;
    double nearest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 along = p[(k + 1) % 3] - p[k], from = foot - p[k];
        const double length2 = glm::dot(along, along);
        if (length2 <= 0.0) return {};
        const Vec3 off = from - along * (std::clamp(glm::dot(from, along) / length2, 0.0, 1.0));
        const double distance2 = glm::dot(off, off);
        if (k == 0 || distance2 < nearest) {
            nearest = distance2;
            edge = k;
        }
    }
    if (facet.across[edge] == MeshShading::kNone) return {};
    const Vec3 along = p[(edge + 1) % 3] - p[edge], from = request.hand_m - p[edge];
    const double length2 = glm::dot(along, along), t = glm::dot(from, along) / length2;
    if (t <= 0.0 || t >= 1.0) return {};
    const double four = 4.0 * side * static_cast<double>(facet.sagitta_m[edge]);
    Rise rise{four * t * (1.0 - t), along * (four * (1.0 - 2.0 * t) / length2)};

    const Corners& other = shape.mesh.triangles[facet.across[edge]];
    const Vec3& a = shape.mesh.points_m[other[0]];
    const Vec3 other_across = glm::cross(shape.mesh.points_m[other[1]] - a, shape.mesh.points_m[other[2]] - a);
    const Vec3 one = across * (side / std::sqrt(glm::dot(across, across))),
               two = other_across * (side / std::sqrt(glm::dot(other_across, other_across)));
    const Vec3 middle = (one + two) / std::sqrt(glm::dot(one + two, one + two));
    const double cosine = glm::dot(middle, one);
    const Vec3 d = from - along * t;
    const double term = glm::dot(d, request.normal) - glm::dot(d, middle) / cosine;
    const double begun = smooth_step(t / kRunOut), left = smooth_step((1.0 - t) / kRunOut), weight = begun * left;
    const double weight_slope =
        (smooth_step_slope(t / kRunOut) * left - smooth_step_slope((1.0 - t) / kRunOut) * begun) / kRunOut;
    rise.height_m += weight * term;
    rise.slope += (request.normal - middle / cosine) * weight + along * (weight_slope * term / length2);
    return rise;
}

void add_shading(const HapticScene& shape, const Obstacle& o, const FieldRequest& request,
                 SurfaceField& field) noexcept {
    const MeshShading::Facet& facet = shape.shading.facets[o.shape];
    const Corners& t = shape.mesh.triangles[o.shape];
    const std::array<Vec3, 3> p{shape.mesh.points_m[t[0]], shape.mesh.points_m[t[1]], shape.mesh.points_m[t[2]]};
    const Vec3 across = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double size2 = glm::dot(across, across), facing = glm::dot(across, request.normal);
    if (!(size2 > 0.0)) return;
    const double side = facing >= 0.0 ? 1.0 : -1.0;
    Rise rise;
    if (facing * facing >= kFlatFacet * size2) {
        rise = rise_over_facet(p, facet, across, request.hand_m);
        rise.height_m *= side;
        rise.slope *= side;
    } else {
        rise = rise_over_edge(shape, p, facet, across, side, request);
    }
    const double sets_in =
        std::max(kShadingSetsIn_hand_m * request.world_m_per_hand_m, kSetInPerRise * shape.shading.highest_m);
    const double part = smooth_step(request.press_m / sets_in);
    field.shift_m -= part * rise.height_m;
    field.gradient +=
        request.normal * (rise.height_m * smooth_step_slope(request.press_m / sets_in) / sets_in) - rise.slope * part;
}

}  // namespace

SurfaceField surface_field(const HapticScene& scene, const HapticScene& shape, const FieldRequest& request) noexcept {
    SurfaceField field;
    const Obstacle& o = shape.obstacles[request.obstacle];
    const SurfaceLabel& label = shape.label(request.obstacle, request.face);
    const std::int32_t index = scene.material(label.material).relief;
    if (index >= 0) {
        const Relief& relief = scene.reliefs[static_cast<std::size_t>(index)];
        Vec3 onto(0.0);
        switch (o.kind) {
            case ObstacleKind::Box:
                onto[static_cast<int>(request.face / 2)] = request.face % 2 == 1 ? 1.0 : -1.0;
                break;
            case ObstacleKind::Brush:
                onto = shape.planes[o.shape + request.face].normal;
                break;
            case ObstacleKind::Triangle:
            case ObstacleKind::Polygon:
                onto[label.feature.value < scene.relief_axis.size() ? scene.relief_axis[label.feature.value] : 2] = 1.0;
                break;
            case ObstacleKind::Sphere:
            case ObstacleKind::Capsule:
            case ObstacleKind::Cylinder:
            case ObstacleKind::Cone:
            case ObstacleKind::Custom:
                onto.z = 1.0;  // projects straight from above
                break;
        }
        const bool has_borders = o.kind == ObstacleKind::Box || o.kind == ObstacleKind::Brush;
        // At an edge the surface is plain, because textures have faded out at the border of a face.
        if (has_borders && glm::dot(onto, request.normal) < kFlat) return field;
        ReliefValue value = relief_at(relief, relief_axes(onto), request.hand_m, request.world_m_per_hand_m,
                                      request.stiffness_n_per_m, request.swing);
        if (has_borders && value.depth_m > 0.0) {
            ReliefBorder border(value, request.world_m_per_hand_m);
            if (o.kind == ObstacleKind::Box) borders_of_box(shape, o, request.face, request.hand_m, border);
            else borders_of_brush(shape, o, request.face, request.hand_m, border);
            border.apply();
        }
        field.shift_m = value.depth_m;
        field.gradient = value.gradient;
        field.friction = value.friction;
        field.swing_to_shift = value.swing_to_depth;
    }
    if (o.kind == ObstacleKind::Triangle && !shape.shading.facets.empty()) add_shading(shape, o, request, field);
    return field;
}

}  // namespace handrail::render
