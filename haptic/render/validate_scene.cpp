#include "haptic/render/validate_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace handrail::render {
namespace {

bool is_unit(const Vec3& direction) { return std::abs(glm::length(direction) - 1.0) < 1e-6; }
bool is_box(const Aabb& box) { return is_finite(box.min_m) && is_finite(box.max_m) && !box.empty(); }
bool are_planes(std::span<const Plane> planes) {
    return std::all_of(planes.begin(), planes.end(),
                       [](const Plane& plane) { return is_unit(plane.normal) && std::isfinite(plane.offset_m); });
}
bool is_size(double length_m) { return length_m >= 0.0 && std::isfinite(length_m); }

// The result of examining one obstacle: its number of labels, and the fault of its shape.
struct Looked {
    std::size_t labels = 1;
    const char* fault = nullptr;
};

Looked look_at_mesh(const HapticScene& scene, const Obstacle& o) {
    if (o.shape >= scene.mesh.triangles.size()) return {1, "a triangle that is not there"};
    for (const std::uint32_t corner : scene.mesh.triangles[o.shape]) {
        if (corner >= scene.mesh.points_m.size()) return {1, "a triangle with a corner that is not there"};
        if (!is_finite(scene.mesh.points_m[corner])) return {1, "a corner that is not finite"};
    }
    return {1, nullptr};
}

Looked look_at_polygon(const HapticScene& scene, const Obstacle& o) {
    if (o.shape >= scene.polygons.size()) return {2, "a polygon that is not there"};
    const PolygonRange& range = scene.polygons[o.shape];
    if (range.corners < 3 || range.corners > scene.polygon_corners.size() ||
        range.first_corner > scene.polygon_corners.size() - range.corners)
        return {2, "a polygon with corners that are not there"};
    return {2, is_unit(range.normal) ? nullptr : "a polygon whose normal is none"};
}

Looked look_at_brush(const HapticScene& scene, const Obstacle& o) {
    if (o.planes < 4 || o.planes > scene.planes.size() || o.shape > scene.planes.size() - o.planes)
        return {o.planes, "a brush with planes that are not there"};
    return {o.planes, are_planes(std::span(scene.planes).subspan(o.shape, o.planes))
                          ? nullptr
                          : "a brush with a plane that is none"};
}

Looked look_at(const HapticScene& scene, const Obstacle& o) {
    switch (o.kind) {
        case ObstacleKind::Triangle:
            return look_at_mesh(scene, o);
        case ObstacleKind::Polygon:
            return look_at_polygon(scene, o);
        case ObstacleKind::Box:
            return {6, o.shape < scene.boxes.size() && is_box(scene.boxes[o.shape]) ? nullptr : "a box that is none"};
        case ObstacleKind::Brush:
            return look_at_brush(scene, o);
        case ObstacleKind::Sphere:
            return {1, o.shape < scene.spheres.size() && is_box(bounds_of(scene.spheres[o.shape]))
                           ? nullptr
                           : "a sphere that is none"};
        case ObstacleKind::Capsule:
            return {1, o.shape < scene.capsules.size() && is_box(bounds_of(scene.capsules[o.shape]))
                           ? nullptr
                           : "a capsule that is none"};
        case ObstacleKind::Cylinder:
            return {3, o.shape < scene.cylinders.size() && is_box(bounds_of(scene.cylinders[o.shape]))
                           ? nullptr
                           : "a cylinder that is none"};
        case ObstacleKind::Cone:
            return {2, o.shape < scene.cones.size() && is_box(bounds_of(scene.cones[o.shape])) ? nullptr
                                                                                               : "a cone that is none"};
        case ObstacleKind::Custom:
            return {1, o.shape < scene.customs.size() && scene.customs[o.shape].closest
                           ? nullptr
                           : "a custom obstacle without a function"};
    }
    return {1, "an obstacle of no kind"};
}

const char* fault_of_tables(const HapticScene& scene) {
    if (!is_finite(scene.origin_m)) return "an origin that is not finite";
    if (scene.materials.empty()) return "no default material";
    if (scene.roundings_m.empty() || scene.roundings_m.front() != 0.0) return "no sharp edge among the roundings";
    if (!std::all_of(scene.roundings_m.begin(), scene.roundings_m.end(), is_size)) return "a rounding that is none";
    for (const HapticMaterial& material : scene.materials)
        if (material.relief >= static_cast<std::int32_t>(scene.reliefs.size()))
            return "a material with a relief that is not there";
    for (const LiquidVolume& liquid : scene.liquids)
        if (!are_planes(liquid.planes) || liquid.hidden.size() != liquid.planes.size() ||
            liquid.surface >= static_cast<int>(liquid.planes.size()))
            return "a liquid that does not hold together";
    for (const std::uint32_t effect : scene.hanging_effects)
        if (effect >= scene.effects.size()) return "a hanging effect that is not there";
    return nullptr;
}

}  // namespace

Result<void> validate(const HapticScene& scene) {
    if (const char* fault = fault_of_tables(scene)) return fail(fmt::format("HapticScene has {}", fault));
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
        const Obstacle& o = scene.obstacles[i];
        const Looked looked = look_at(scene, o);
        if (looked.fault) return fail(fmt::format("HapticScene has {}, obstacle {}", looked.fault, i));
        if (looked.labels > scene.labels.size() || o.first_label > scene.labels.size() - looked.labels)
            return fail(fmt::format("HapticScene has an obstacle with labels that are not there, obstacle {}", i));
        if (o.rounding >= scene.roundings_m.size())
            return fail(fmt::format("HapticScene has an obstacle with a rounding that is not there, obstacle {}", i));
    }
    for (const HapticBody& body : scene.bodies) {
        if (!body.shape) return fail("HapticScene has a body without a shape");
        if (!is_finite(body.start.position_m) || !(body.start.scale > 0.0) || !is_size(body.reach_m))
            return fail("HapticScene has a body that stands nowhere");
        if (auto inner = validate(*body.shape); !inner) return inner;
    }
    return {};
}

}  // namespace handrail::render
