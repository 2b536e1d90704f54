#include "worlds/scene/scene.h"

#include "worlds/scene/primitive.h"

namespace handrail {

namespace {

// Returns the text for `name` from that section of the language file, or `name` itself if there is none.
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

namespace {

struct WrongPart {
    std::string message;
    int line = 0;
};
using MaybeWrong = std::optional<WrongPart>;

bool finite_box(const Aabb& box) { return box.empty() || (is_finite(box.min_m) && is_finite(box.max_m)); }

// Checks the parts of a scene in order and stops at the first fault.
class SceneCheck {
public:
    explicit SceneCheck(const Scene& scene) : scene_(scene) {}

    MaybeWrong wrong() const {
        if (scene_.materials.empty()) return WrongPart{phrase("worlds.no_default_material")};
        if (!finite_box(scene_.bounds_m)) return WrongPart{phrase("worlds.size_no_number")};
        if (auto found = first_of(scene_.features)) return found;
        if (auto found = first_of(scene_.solids)) return found;
        if (auto found = first_of(scene_.triangles)) return found;
        if (auto found = first_of(scene_.bodies)) return found;
        if (auto found = first_of(scene_.placed)) return found;
        if (auto found = first_of(scene_.surfaces)) return found;
        return wrong_starts();
    }

private:
    bool known(FeatureId id) const { return !id || id.value < scene_.features.size(); }
    bool is_material(MaterialId id) const { return id < scene_.materials.size(); }

    template <class Part>
    MaybeWrong first_of(const std::vector<Part>& parts) const {
        for (const Part& part : parts)
            if (auto found = wrong(part)) return found;
        return std::nullopt;
    }

    MaybeWrong wrong(const Feature& feature) const {
        const int line = feature.source.line;
        if (!is_material(feature.material))
            return WrongPart{phrase("worlds.unknown_material", {{"name", spoken_name(feature)}}), line};
        if (feature.name.empty()) return WrongPart{phrase("worlds.no_name"), line};
        if (!is_finite(feature.normal) || !finite_box(feature.bounds_m) || !std::isfinite(feature.area_m2))
            return WrongPart{phrase("worlds.place_no_number", {{"name", spoken_name(feature)}}), line};
        return std::nullopt;
    }

    MaybeWrong wrong(const Solid& solid) const {
        const std::size_t faces = solid.shape.planes.size();
        const int line = solid.source.line;
        if (faces < 4 || solid.shape.faces.size() != faces)
            return WrongPart{phrase("worlds.solid_too_few_faces"), line};
        if (solid.face_features.size() != faces || solid.face_materials.size() != faces ||
            solid.face_hidden.size() != faces)
            return WrongPart{phrase("worlds.solid_faces_unsaid"), line};
        if (!(signed_distance(solid.round, solid.shape.bounds_m.centre_m()) > -std::numeric_limits<double>::infinity()))
            return WrongPart{phrase("worlds.round_no_size"), line};
        if (!known(solid.feature)) return WrongPart{phrase("worlds.solid_of_unknown"), line};
        for (std::size_t i = 0; i < faces; ++i)
            if (auto found = wrong_face(solid, i)) return found;
        return std::nullopt;
    }

    MaybeWrong wrong_face(const Solid& solid, std::size_t i) const {
        const int line = solid.source.line;
        const Plane& plane = solid.shape.planes[i];
        const std::vector<Vec3>& corners_m = solid.shape.faces[i].points_m;
        if (!is_finite(plane.normal) || !std::isfinite(plane.offset_m) ||
            std::abs(glm::length(plane.normal) - 1.0) > 1e-9)
            return WrongPart{phrase("worlds.face_no_direction"), line};
        if (corners_m.size() < 3) return WrongPart{phrase("worlds.face_too_few_corners"), line};
        if (!std::all_of(corners_m.begin(), corners_m.end(), [](const Vec3& p) { return is_finite(p); }))
            return WrongPart{phrase("worlds.solid_corner_no_number"), line};
        if (!known(solid.face_features[i])) return WrongPart{phrase("worlds.face_of_unknown"), line};
        if (!is_material(solid.face_materials[i])) return WrongPart{phrase("worlds.face_unknown_material"), line};
        return std::nullopt;
    }

    MaybeWrong wrong(const MeshTriangle& t) const {
        if (!is_finite(t.a_m) || !is_finite(t.b_m) || !is_finite(t.c_m))
            return WrongPart{phrase("worlds.triangle_corner_no_number")};
        if (!known(t.feature) || !is_material(t.material)) return WrongPart{phrase("worlds.triangle_of_unknown")};
        return std::nullopt;
    }

    MaybeWrong wrong(const FreeBody& body) const {
        const bool right = known(body.feature) && body.feature && body.mass_kg >= FreeBody::kLeast_kg &&
                           body.mass_kg <= FreeBody::kMost_kg && is_finite(body.string_at_m) &&
                           body.string_n_per_m >= 0.0;
        return right ? std::nullopt : MaybeWrong{{phrase("worlds.body_no_mass"), body.source.line}};
    }

    MaybeWrong wrong(const PlacedModel& placed) const {
        if (!placed.model) return WrongPart{phrase("worlds.thing_no_shape")};
        if (!known(placed.feature) || !placed.feature || !is_material(placed.material))
            return WrongPart{phrase("worlds.thing_unknown")};
        if (!is_finite(placed.at.position_m) || !(placed.at.scale > 0.0))
            return WrongPart{phrase("worlds.thing_no_place")};
        return std::nullopt;
    }

    MaybeWrong wrong(const SurfacePolygon& surface) const {
        if (surface.polygon.points_m.size() < 3) return WrongPart{phrase("worlds.surface_too_few_corners")};
        if (!known(surface.feature) || !is_material(surface.material))
            return WrongPart{phrase("worlds.surface_of_unknown")};
        return std::nullopt;
    }

    MaybeWrong wrong_starts() const {
        int bases = 0;
        for (const Start& start : scene_.starts) {
            if (!is_finite(start.feet_m) || !std::isfinite(start.heading_rad))
                return WrongPart{phrase("worlds.start_no_place"), start.source.line};
            bases += start.base ? 1 : 0;
        }
        if (bases != (scene_.starts.empty() ? 0 : 1)) return WrongPart{phrase("worlds.one_base")};
        return std::nullopt;
    }

    const Scene& scene_;
};

}  // namespace

Result<void> validate(const Scene& scene) {
    if (const auto wrong = SceneCheck(scene).wrong()) return fail(wrong->message, scene.source_file, wrong->line);
    return {};
}

}  // namespace handrail
