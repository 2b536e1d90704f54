#include "worlds/scene/primitive.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/language.h"
#include "worlds/base/overloaded.h"
#include "worlds/geometry/clip.h"

namespace handrail {
namespace {

constexpr int kSides = 24;        // number of flat faces around a cylinder or cone
constexpr int kSphereSides = 16;  // number of flat faces around a sphere or capsule
constexpr int kSphereBands = 8;   // number of bands of faces of a sphere or capsule, from pole to pole

bool differ(double a, double b) { return std::abs(a - b) > 1e-9 * std::max(std::abs(a), std::abs(b)); }

// Returns the reason why the sizes do not give this shape. Empty if they do.
std::string refusal(const Primitive& p, const Vec3& size) {
    const std::string name = spoken_kind(kPrimitiveNames[static_cast<std::size_t>(p.kind)]);
    const Rotation& q = p.at.rotation;
    if (!is_finite(size) || !is_finite(p.at.position_m) || !std::isfinite(p.at.scale) ||
        !std::isfinite(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z))
        return phrase("worlds.shape_no_number", {{"shape", name}});
    if (!(std::min({p.size_m.x, p.size_m.y, p.size_m.z, p.stretch.x, p.stretch.y, p.stretch.z, p.at.scale}) > 0.0))
        return phrase("worlds.shape_above_zero", {{"shape", name}});
    if (p.kind == PrimitiveKind::Box) return {};
    if (differ(size.x, size.y) || (p.kind == PrimitiveKind::Sphere && differ(size.x, size.z)))
        return phrase("worlds.shape_stays_round", {{"shape", name}});
    if (p.kind == PrimitiveKind::Capsule && size.z < size.x && differ(size.x, size.z))
        return phrase("worlds.capsule_long");
    return {};
}

// Returns the planes of the flat-faced solid around the shape, in the shape's own frame.
std::vector<Plane> planes_of(PrimitiveKind kind, const Vec3& size) {
    std::vector<Plane> planes;
    const double radius = 0.5 * size.x, half = 0.5 * size.z;
    const auto around = [](int k, int sides) { return 2.0 * kPi * k / sides; };
    const auto exact = [](double v) {
        return std::abs(v) < 1e-15 ? 0.0 : std::abs(std::abs(v) - 1.0) < 1e-15 ? std::copysign(1.0, v) : v;
    };
    const auto direction = [&](double turn, double out, double up) {
        return Vec3(exact(out * std::cos(turn)), exact(out * std::sin(turn)), up);
    };
    if (kind == PrimitiveKind::Box) {
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0}) {
                Vec3 normal(0.0);
                normal[axis] = side;
                planes.push_back({normal, 0.5 * size[axis]});
            }
    } else if (kind == PrimitiveKind::Cylinder || kind == PrimitiveKind::Cone) {
        const bool cone = kind == PrimitiveKind::Cone;
        const ConeShape profile = make_cone({0, 0, -half}, {0, 0, 1}, size.z, radius);
        planes.push_back({{0, 0, -1}, half});
        if (!cone) planes.push_back({{0, 0, 1}, half});
        for (int k = 0; k < kSides; ++k)
            planes.push_back(
                cone ? Plane{direction(around(k, kSides), profile.slant_out, profile.slant_up), half * profile.slant_up}
                     : Plane{direction(around(k, kSides), 1.0, 0.0), radius});
    } else {
        const double straight = kind == PrimitiveKind::Capsule ? std::max(0.0, half - radius) : 0.0;
        for (int band = 0; band <= kSphereBands; ++band) {
            const double tilt = kPi * (static_cast<double>(band) / kSphereBands - 0.5);
            const bool pole = band == 0 || band == kSphereBands;
            for (int k = 0; k < (pole ? 1 : kSphereSides); ++k) {
                const Vec3 normal =
                    pole ? Vec3(0, 0, band == 0 ? -1 : 1)
                         : glm::normalize(direction(around(k, kSphereSides), std::cos(tilt), exact(std::sin(tilt))));
                planes.push_back({normal, radius + straight * std::abs(normal.z)});
            }
        }
    }
    return planes;
}

RoundShape round_of(PrimitiveKind kind, const Vec3& size, const PlacedFrame& frame) {
    const double radius = 0.5 * size.x;
    const Vec3 axis = glm::normalize(frame.axes[2]);
    const auto along = [&](double z) { return frame.position_m + axis * z; };
    switch (kind) {
        case PrimitiveKind::Sphere:
            return SphereShape{frame.position_m, radius};
        case PrimitiveKind::Cylinder:
            return CylinderShape{along(-0.5 * size.z), axis, size.z, radius};
        case PrimitiveKind::Cone:
            return make_cone(along(-0.5 * size.z), axis, size.z, radius);
        case PrimitiveKind::Capsule: {
            const double straight = std::max(0.0, size.z - size.x);
            return CapsuleShape{along(-0.5 * straight), axis, straight, radius};
        }
        case PrimitiveKind::Box:
            break;
    }
    return {};
}

}  // namespace

Result<Solid> make_solid(const Primitive& primitive, MaterialId material) {
    const Vec3 size = primitive.size_m * primitive.stretch * primitive.at.scale;
    if (std::string why = refusal(primitive, size); !why.empty()) return fail(std::move(why));
    const PlacedFrame frame(Placement{primitive.at.position_m, normalized(primitive.at.rotation), 1.0});
    // Faces are computed at a size of 1, for which the tolerances are made, and then scaled and placed.
    const double unit = std::max({size.x, size.y, size.z});
    BuiltSolid built = solid_from_planes(planes_of(primitive.kind, size / unit), Vec3(0.0), 4.0);
    if (built.fault != SolidFault::None)
        built = solid_from_planes(planes_of(PrimitiveKind::Box, size / unit), Vec3(0.0), 4.0, {0.0, 0.0});
    if (built.fault != SolidFault::None)
        return fail(phrase("worlds.shape_too_thin",
                           {{"shape", spoken_kind(kPrimitiveNames[static_cast<std::size_t>(primitive.kind)])}}));
    Solid solid;
    solid.shape = std::move(built.solid);
    solid.shape.bounds_m = {};
    for (Polygon& face : solid.shape.faces)
        for (Vec3& p : face.points_m) {
            p = frame.to_world(p * unit);
            solid.shape.bounds_m.include(p);
        }
    for (Plane& plane : solid.shape.planes) {
        plane.normal = glm::normalize(frame.turned(plane.normal));
        plane.offset_m = plane.offset_m * unit + glm::dot(plane.normal, frame.position_m);
    }
    solid.round = round_of(primitive.kind, size, frame);
    solid.face_features.assign(solid.shape.planes.size(), kNoFeature);
    solid.face_materials.assign(solid.shape.planes.size(), material);
    solid.face_hidden.assign(solid.shape.planes.size(), false);
    return solid;
}

double signed_distance(const RoundShape& round, const Vec3& point_m) noexcept {
    return std::visit(Overloaded{[](std::monostate) { return std::numeric_limits<double>::infinity(); },
                                 [&](const auto& shape) { return closest_point(shape, point_m).distance_m; }},
                      round);
}

}  // namespace handrail
