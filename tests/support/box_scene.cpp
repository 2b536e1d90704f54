#include "tests/support/box_scene.h"
#include "tests/support/names.h"

namespace handrail::test {
namespace {

// Adds the plane of one face and its polygon to a solid.
void add_face(ConvexSolid& solid, const Vec3& normal, std::vector<Vec3> points) {
    const Vec3 unit = normal / glm::length(normal);
    for (const Vec3& p : points) solid.bounds_m.include(p);
    solid.planes.push_back({unit, glm::dot(unit, points.front())});
    solid.faces.push_back({std::move(points)});
}

}  // namespace

SceneBuilder::SceneBuilder() {
    scene_.name = "test world";
    scene_.materials.emplace_back();
}

FeatureId SceneBuilder::add(ConvexSolid shape, const std::string& name, SolidRole role, const std::string& material,
                            FeatureKind kind) {
    const FeatureId id{static_cast<std::uint32_t>(scene_.features.size())};
    MaterialId material_id = kDefaultMaterial;
    if (const MaterialSpec* spec = find_material(material)) {
        Material made;
        made.name = spec->name;
        made.sound = spec->sound;
        material_id = static_cast<MaterialId>(scene_.materials.size());
        scene_.materials.push_back(made);
    }
    Feature feature;
    feature.kind = kind;
    feature.name = name;
    feature.material = material_id;
    feature.bounds_m = shape.bounds_m;
    scene_.features.push_back(feature);
    scene_.bounds_m.include(shape.bounds_m);
    Solid solid;
    solid.role = role;
    solid.feature = id;
    solid.face_features.assign(shape.planes.size(), id);
    solid.face_materials.assign(shape.planes.size(), material_id);
    solid.face_hidden.assign(shape.planes.size(), false);
    solid.shape = std::move(shape);
    scene_.solids.push_back(std::move(solid));
    return id;
}

FeatureId SceneBuilder::box(const Vec3& a, const Vec3& b, const std::string& name, SolidRole role,
                            const std::string& material, FeatureKind kind) {
    ConvexSolid s;
    add_face(s, {1, 0, 0}, {{b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}, {b.x, a.y, b.z}});
    add_face(s, {-1, 0, 0}, {{a.x, b.y, a.z}, {a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}});
    add_face(s, {0, 1, 0}, {{b.x, b.y, a.z}, {a.x, b.y, a.z}, {a.x, b.y, b.z}, {b.x, b.y, b.z}});
    add_face(s, {0, -1, 0}, {{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}});
    add_face(s, {0, 0, 1}, {{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}});
    add_face(s, {0, 0, -1}, {{a.x, b.y, a.z}, {b.x, b.y, a.z}, {b.x, a.y, a.z}, {a.x, a.y, a.z}});
    return add(std::move(s), name, role, material, kind);
}

FeatureId SceneBuilder::prism(const std::vector<Vec2>& outline_m, double low_m, double high_m,
                              const std::string& name) {
    ConvexSolid s;
    std::vector<Vec3> top, bottom;
    for (std::size_t i = 0; i < outline_m.size(); ++i) {
        const Vec2 &a = outline_m[i], &b = outline_m[(i + 1) % outline_m.size()];
        add_face(s, {b.y - a.y, a.x - b.x, 0.0}, {{a, low_m}, {b, low_m}, {b, high_m}, {a, high_m}});
        top.emplace_back(a, high_m);
        bottom.emplace(bottom.begin(), a, low_m);
    }
    add_face(s, {0, 0, 1}, top);
    add_face(s, {0, 0, -1}, bottom);
    return add(std::move(s), name, SolidRole::Solid, {}, FeatureKind::Object);
}

FeatureId SceneBuilder::ramp(const Vec3& a, const Vec3& b, const std::string& name) {
    ConvexSolid s;
    add_face(s, {1, 0, 0}, {{b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}});
    add_face(s, {-1, 0, 0}, {{a.x, b.y, a.z}, {a.x, a.y, a.z}, {a.x, b.y, b.z}});
    add_face(s, {0, 1, 0}, {{b.x, b.y, a.z}, {a.x, b.y, a.z}, {a.x, b.y, b.z}, {b.x, b.y, b.z}});
    add_face(s, {0, 0, -1}, {{a.x, b.y, a.z}, {b.x, b.y, a.z}, {b.x, a.y, a.z}, {a.x, a.y, a.z}});
    add_face(s, {0, -(b.z - a.z), b.y - a.y}, {{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}});
    return add(std::move(s), name, SolidRole::Solid, {}, FeatureKind::Slope);
}

void SceneBuilder::start(const Vec3& feet_m, double heading_rad) {
    Start s;
    s.feet_m = feet_m;
    s.heading_rad = heading_rad;
    s.base = scene_.starts.empty();
    scene_.starts.push_back(s);
}

std::shared_ptr<const Scene> SceneBuilder::share() const { return std::make_shared<Scene>(scene_); }

}  // namespace handrail::test
