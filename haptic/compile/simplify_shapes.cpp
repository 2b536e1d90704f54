#include "haptic/compile/simplify_shapes.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace handrail::compile::doorway {

void include(Range& range, double value) {
    range[0] = std::min(range[0], value);
    range[1] = std::max(range[1], value);
}

void include(Range& range, const Range& other) {
    range[0] = std::min(range[0], other[0]);
    range[1] = std::max(range[1], other[1]);
}

Range along(const ConvexSolid& solid, const Vec3& way) {
    Range range = kNoRange;
    for (const Polygon& face : solid.faces)
        for (const Vec3& p : face.points_m) include(range, glm::dot(way, p));
    return range;
}

std::vector<Plane> box_planes(const Vec3& way, const Range& s, const Range& t, const Range& z) {
    const Vec3 left = left_of(way), up(0.0, 0.0, 1.0);
    return {{way, s[1]}, {-way, -s[0]}, {up, z[1]}, {-up, -z[0]}, {left, t[1]}, {-left, -t[0]}};
}

Aabb box_around(const Vec3& way, const Range& s, const Range& t, const Range& z) {
    Aabb box;
    for (int corner = 0; corner < 8; ++corner)
        box.include(way * s[corner & 1 ? 1 : 0] + left_of(way) * t[corner & 2 ? 1 : 0] +
                    Vec3(0.0, 0.0, z[corner & 4 ? 1 : 0]));
    return box;
}

BuiltSolid built(std::span<const Plane> planes, const Aabb& around) {
    BuiltSolid made =
        solid_from_planes(planes, around.centre_m(), 2.0 * glm::length(around.size_m()) + 1.0, kTolerance);
    if (made.was_inside_out) made.fault = SolidFault::Empty;
    return made;
}

ConvexSolid common(const ConvexSolid& solid, const std::vector<Plane>& planes) {
    std::vector<Plane> all = solid.planes;
    all.insert(all.end(), planes.begin(), planes.end());
    BuiltSolid made = built(all, solid.bounds_m);
    return made.fault == SolidFault::None ? std::move(made.solid) : ConvexSolid{};
}

bool is_kind(const Scene& scene, FeatureId id, FeatureKind kind) {
    const Feature* feature = scene.find(id);
    return feature && feature->kind == kind;
}

bool is_leaf(const Scene& scene, const Solid& solid) { return is_kind(scene, solid.feature, FeatureKind::Door); }

bool is_thing(const Scene& scene, FeatureId id) {
    const Feature* feature = scene.find(id);
    return feature && feature->kind == FeatureKind::Object && !feature->made_name;
}

bool is_wall(const Scene& scene, const Solid& solid) {
    return solid.role == SolidRole::Solid && !solid.soft && std::holds_alternative<std::monostate>(solid.round) &&
           !is_leaf(scene, solid) && !is_thing(scene, solid.feature);
}

bool is_standing(const Scene& scene, const Solid& solid) {
    return (solid.role == SolidRole::Solid || solid.role == SolidRole::Mover) && !is_leaf(scene, solid);
}

}  // namespace handrail::compile::doorway
