#include "worlds/scene/scene.h"

#include "worlds/scene/primitive.h"

namespace handrail {

namespace {

// A text under the name's own key, or the name.
std::string said(std::string_view section, std::string_view name) {
    std::string key(section);
    for (const char c : name) key += c == ' ' || c == '-' ? '_' : c;
    return has_phrase(key) ? phrase(key) : std::string(name);
}

}  // namespace

std::string spoken_kind(std::string_view name) { return said("kind.", name); }
std::string spoken_material(std::string_view name) { return said("material.", name); }

std::string spoken_name(const Feature& feature) {
    return in_spoken_language(feature.made_name ? spoken_kind(feature.name) : feature.name, feature.name_in);
}
std::string spoken_name(const SoundSource& sound) {
    return in_spoken_language(sound.made_name ? phrase(sound.name) : sound.name, sound.name_in);
}
std::string spoken_name(const Scene& scene) { return in_spoken_language(scene.name, scene.name_in); }
std::string spoken_message(const Feature& feature) {
    return in_spoken_language(feature.made_message ? phrase(feature.message) : feature.message, feature.message_in);
}

std::string spoken_name(const Scene& scene, FeatureId id) {
    const Feature* feature = scene.find(id);
    if (!feature) return {};
    const std::string name = spoken_name(*feature), material = spoken_material(scene.material(feature->material).name);
    if (name.empty() || material.empty()) return name.empty() ? material : name;
    return phrase("kind.with_material", {{"name", name}, {"material", material}});
}

std::string stored_name(const Scene& scene, FeatureId id) {
    const Feature* feature = scene.find(id);
    if (!feature) return {};
    const std::string& material = scene.material(feature->material).name;
    if (feature->name.empty() || material.empty()) return feature->name.empty() ? material : feature->name;
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
    const auto finite_box = [](const Aabb& box) {
        return box.empty() || (is_finite(box.min_m) && is_finite(box.max_m));
    };
    if (scene.materials.empty()) return wrong(phrase("worlds.no_default_material"), 0);
    if (!finite_box(scene.bounds_m)) return wrong(phrase("worlds.size_no_number"), 0);
    for (const Feature& feature : scene.features) {
        if (feature.material >= scene.materials.size())
            return wrong(phrase("worlds.unknown_material", {{"name", spoken_name(feature)}}), feature.source.line);
        if (feature.name.empty()) return wrong(phrase("worlds.no_name"), feature.source.line);
        if (!is_finite(feature.normal) || !finite_box(feature.bounds_m) || !std::isfinite(feature.area_m2))
            return wrong(phrase("worlds.place_no_number", {{"name", spoken_name(feature)}}), feature.source.line);
    }
    for (const Solid& solid : scene.solids) {
        const std::size_t faces = solid.shape.planes.size();
        const int line = solid.source.line;
        if (faces < 4 || solid.shape.faces.size() != faces) return wrong(phrase("worlds.solid_too_few_faces"), line);
        if (solid.face_features.size() != faces || solid.face_materials.size() != faces ||
            solid.face_hidden.size() != faces)
            return wrong(phrase("worlds.solid_faces_unsaid"), line);
        if (!(signed_distance(solid.round, solid.shape.bounds_m.centre_m()) > -std::numeric_limits<double>::infinity()))
            return wrong(phrase("worlds.round_no_size"), line);
        if (!known(solid.feature)) return wrong(phrase("worlds.solid_of_unknown"), line);
        for (std::size_t i = 0; i < faces; ++i) {
            const Plane& plane = solid.shape.planes[i];
            if (!is_finite(plane.normal) || !std::isfinite(plane.offset_m) ||
                std::abs(glm::length(plane.normal) - 1.0) > 1e-9)
                return wrong(phrase("worlds.face_no_direction"), line);
            if (solid.shape.faces[i].points_m.size() < 3) return wrong(phrase("worlds.face_too_few_corners"), line);
            for (const Vec3& p : solid.shape.faces[i].points_m)
                if (!is_finite(p)) return wrong(phrase("worlds.solid_corner_no_number"), line);
            if (!known(solid.face_features[i])) return wrong(phrase("worlds.face_of_unknown"), line);
            if (solid.face_materials[i] >= scene.materials.size())
                return wrong(phrase("worlds.face_unknown_material"), line);
        }
    }
    for (const MeshTriangle& t : scene.triangles) {
        if (!is_finite(t.a_m) || !is_finite(t.b_m) || !is_finite(t.c_m))
            return wrong(phrase("worlds.triangle_corner_no_number"), 0);
        if (!known(t.feature) || t.material >= scene.materials.size())
            return wrong(phrase("worlds.triangle_of_unknown"), 0);
    }
    for (const FreeBody& body : scene.bodies)
        if (!known(body.feature) || !body.feature || !(body.mass_kg >= FreeBody::kLeast_kg) ||
            !(body.mass_kg <= FreeBody::kMost_kg) || !is_finite(body.string_at_m) || !(body.string_n_per_m >= 0.0))
            return wrong(phrase("worlds.body_no_mass"), body.source.line);
    for (const PlacedModel& placed : scene.placed) {
        if (!placed.model) return wrong(phrase("worlds.thing_no_shape"), 0);
        if (!known(placed.feature) || !placed.feature || placed.material >= scene.materials.size())
            return wrong(phrase("worlds.thing_unknown"), 0);
        if (!is_finite(placed.at.position_m) || !(placed.at.scale > 0.0))
            return wrong(phrase("worlds.thing_no_place"), 0);
    }
    for (const SurfacePolygon& surface : scene.surfaces) {
        if (surface.polygon.points_m.size() < 3) return wrong(phrase("worlds.surface_too_few_corners"), 0);
        if (!known(surface.feature) || surface.material >= scene.materials.size())
            return wrong(phrase("worlds.surface_of_unknown"), 0);
    }
    int bases = 0;
    for (const Start& start : scene.starts) {
        if (!is_finite(start.feet_m) || !std::isfinite(start.heading_rad))
            return wrong(phrase("worlds.start_no_place"), start.source.line);
        bases += start.base ? 1 : 0;
    }
    if (bases != (scene.starts.empty() ? 0 : 1)) return wrong(phrase("worlds.one_base"), 0);
    return {};
}

}  // namespace handrail
