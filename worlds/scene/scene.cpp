#include "worlds/scene/scene.h"

#include <fmt/format.h>

#include "worlds/scene/primitive.h"

namespace handrail {

std::string spoken_name(const Scene& scene, FeatureId id) {
    const Feature* feature = scene.find(id);
    if (!feature) return {};
    const std::string& material = scene.material(feature->material).name;
    if (material.empty()) return feature->name;
    if (feature->name.empty()) return material;
    return feature->name + ", " + material;
}

MaterialId material_id(Scene& scene, const Material& material) {
    const auto found = std::find(scene.materials.begin(), scene.materials.end(), material);
    if (found != scene.materials.end()) return static_cast<MaterialId>(found - scene.materials.begin());
    if (scene.materials.size() >= std::numeric_limits<MaterialId>::max()) return kDefaultMaterial;
    scene.materials.push_back(material);
    return static_cast<MaterialId>(scene.materials.size() - 1);
}

Result<void> validate(const Scene& scene) {
    const auto wrong = [&](const std::string& message, int line) { return fail(message, scene.source_file, line); };
    const auto known = [&](FeatureId id) { return !id || id.value < scene.features.size(); };
    const auto finite_box = [](const Aabb& box) { return box.empty() || (is_finite(box.min_m) && is_finite(box.max_m)); };
    if (scene.materials.empty()) return wrong("This world has no default material.", 0);
    if (!finite_box(scene.bounds_m)) return wrong("The size of this world is no number.", 0);
    for (const Feature& feature : scene.features) {
        if (feature.material >= scene.materials.size()) return wrong(fmt::format("{} has an unknown material.", feature.name), feature.source.line);
        if (feature.name.empty()) return wrong("Something here has no name.", feature.source.line);
        if (!is_finite(feature.normal) || !finite_box(feature.bounds_m) || !std::isfinite(feature.area_m2))
            return wrong(fmt::format("The place or size of {} is no number.", feature.name), feature.source.line);
    }
    for (const Solid& solid : scene.solids) {
        const std::size_t faces = solid.shape.planes.size();
        const int line = solid.source.line;
        if (faces < 4 || solid.shape.faces.size() != faces) return wrong("A solid has too few faces.", line);
        if (solid.face_features.size() != faces || solid.face_materials.size() != faces || solid.face_hidden.size() != faces)
            return wrong("A solid does not say for every face what it is.", line);
        if (!(signed_distance(solid.round, solid.shape.bounds_m.centre_m()) > -std::numeric_limits<double>::infinity()))
            return wrong("A round solid has no proper size.", line);
        if (!known(solid.feature)) return wrong("A solid belongs to something unknown.", line);
        for (std::size_t i = 0; i < faces; ++i) {
            const Plane& plane = solid.shape.planes[i];
            if (!is_finite(plane.normal) || !std::isfinite(plane.offset_m) || std::abs(glm::length(plane.normal) - 1.0) > 1e-9)
                return wrong("A face of a solid has no proper direction.", line);
            if (solid.shape.faces[i].points_m.size() < 3) return wrong("A face of a solid has fewer than three corners.", line);
            for (const Vec3& p : solid.shape.faces[i].points_m)
                if (!is_finite(p)) return wrong("A corner of a solid is no number.", line);
            if (!known(solid.face_features[i])) return wrong("A face of a solid belongs to something unknown.", line);
            if (solid.face_materials[i] >= scene.materials.size()) return wrong("A face of a solid has an unknown material.", line);
        }
    }
    for (const MeshTriangle& t : scene.triangles) {
        if (!is_finite(t.a_m) || !is_finite(t.b_m) || !is_finite(t.c_m)) return wrong("A corner of a triangle is no number.", 0);
        if (!known(t.feature) || t.material >= scene.materials.size()) return wrong("A triangle belongs to something unknown.", 0);
    }
    for (const PlacedModel& placed : scene.placed) {
        if (!placed.model) return wrong("A thing that is set down has no shape.", 0);
        if (!known(placed.feature) || !placed.feature || placed.material >= scene.materials.size()) return wrong("A thing that is set down is unknown.", 0);
        if (!is_finite(placed.at.position_m) || !(placed.at.scale > 0.0)) return wrong("A thing is set down at no proper place.", 0);
    }
    for (const SurfacePolygon& surface : scene.surfaces) {
        if (surface.polygon.points_m.size() < 3) return wrong("A surface has fewer than three corners.", 0);
        if (!known(surface.feature) || surface.material >= scene.materials.size()) return wrong("A surface belongs to something unknown.", 0);
    }
    int bases = 0;
    for (const Start& start : scene.starts) {
        if (!is_finite(start.feet_m) || !std::isfinite(start.heading_rad)) return wrong("A start is at no proper place.", start.source.line);
        bases += start.base ? 1 : 0;
    }
    if (bases != (scene.starts.empty() ? 0 : 1)) return wrong("Exactly one start must be the base.", 0);
    return {};
}

}  // namespace handrail
