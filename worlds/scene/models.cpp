#include "worlds/scene/models.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <variant>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

// Returns the bounds of the touchable parts of a model, in the model's own frame.
Aabb touchable_bounds(const Scene& model) {
    Aabb bounds;
    for (const Solid& solid : model.solids)
        if (solid.role == SolidRole::Solid || solid.role == SolidRole::Mover) bounds.include(solid.shape.bounds_m);
    for (const MeshTriangle& t : model.triangles)
        for (const Vec3& p : {t.a_m, t.b_m, t.c_m}) bounds.include(p);
    return bounds;
}

// Adds the drawn surfaces of a placed object.
void draw_placed(Scene& world, const PlacedModel& placed) {
    const PlacedFrame frame(placed.at);
    const auto add = [&](std::vector<Vec3> points, const Vec3& normal) {
        for (Vec3& p : points) p = frame.to_world(p);
        world.surfaces.push_back(
            {Polygon{std::move(points)}, frame.turned(normal), placed.feature, placed.material, SolidRole::Solid});
    };
    for (const Solid& solid : placed.model->solids)
        if (solid.role == SolidRole::Solid || solid.role == SolidRole::Mover)
            for (std::size_t face = 0; face < solid.shape.faces.size(); ++face)
                add(solid.shape.faces[face].points_m, solid.shape.planes[face].normal);
    for (const MeshTriangle& t : placed.model->triangles) {
        const Vec3 area = glm::cross(t.b_m - t.a_m, t.c_m - t.a_m);
        if (const double length = glm::length(area); length > 0.0) add({t.a_m, t.b_m, t.c_m}, area / length);
    }
}

template <class Shape>
void shift(Shape& shape, const Vec3& by_m) {
    if constexpr (std::is_same_v<Shape, SphereShape>) shape.centre_m += by_m;
    else if constexpr (std::is_same_v<Shape, CapsuleShape>) shape.start_m += by_m;
    else if constexpr (std::is_same_v<Shape, CylinderShape>) shape.bottom_m += by_m;
    else if constexpr (std::is_same_v<Shape, ConeShape>) shape.base_m += by_m;
}

// Returns the same solid in a frame whose origin is at zero_m.
Solid seen_from(Solid solid, const Vec3& zero_m) {
    for (Plane& plane : solid.shape.planes) plane.offset_m -= glm::dot(plane.normal, zero_m);
    for (Polygon& face : solid.shape.faces)
        for (Vec3& p : face.points_m) p -= zero_m;
    solid.shape.bounds_m.min_m -= zero_m;
    solid.shape.bounds_m.max_m -= zero_m;
    std::visit([&](auto& round) { shift(round, -zero_m); }, solid.round);
    return solid;
}

void undraw(Scene& world, FeatureId feature) {
    std::erase_if(world.surfaces, [&](const SurfacePolygon& surface) { return surface.feature == feature; });
}

}  // namespace

Aabb placed_bounds(const Aabb& own, const Placement& at) {
    const PlacedFrame frame(at);
    Aabb bounds;
    for (int corner = 0; corner < 8; ++corner)
        bounds.include(frame.to_world({(corner & 1 ? own.max_m : own.min_m).x, (corner & 2 ? own.max_m : own.min_m).y,
                                       (corner & 4 ? own.max_m : own.min_m).z}));
    return bounds;
}

Result<std::shared_ptr<const Scene>> primitive_model(const Primitive& primitive) {
    Result<Solid> solid = make_solid(primitive);
    if (!solid) return tl::unexpected(solid.error());
    auto scene = std::make_shared<Scene>();
    scene->name = kPrimitiveNames[static_cast<std::size_t>(primitive.kind)];
    scene->materials.emplace_back();
    scene->features.push_back({});
    scene->features.back().kind = FeatureKind::Object;
    scene->features.back().name = scene->name;
    scene->features.back().made_name = true;
    scene->features.back().bounds_m = solid->shape.bounds_m;
    scene->bounds_m = solid->shape.bounds_m;
    solid->feature = FeatureId{0};
    scene->solids.push_back(std::move(*solid));
    return std::shared_ptr<const Scene>(std::move(scene));
}

Result<std::shared_ptr<const Scene>> box_model(const Vec3& size_m) {
    Primitive box;
    box.size_m = size_m;
    return primitive_model(box);
}

int find_placed(const Scene& world, const std::string& name) {
    const std::string wanted = lower_ascii(name);
    for (std::size_t i = 0; i < world.placed.size(); ++i)
        if (const Feature* feature = world.find(world.placed[i].feature);
            feature && lower_ascii(feature->name) == wanted)
            return static_cast<int>(i);
    return -1;
}

Result<Scene> with_placed(const Scene& world, const std::string& name, std::shared_ptr<const Scene> model,
                          const Placement& at, const std::string& material) {
    if (name.empty()) return fail(phrase("worlds.thing_needs_name"));
    if (find_placed(world, name) >= 0) return fail(phrase("worlds.thing_there", {{"name", name}}));
    const Aabb own = model ? touchable_bounds(*model) : Aabb{};
    if (own.empty()) return fail(phrase("worlds.nothing_to_touch", {{"name", name}}));
    if (!is_finite(at.position_m) || !std::isfinite(at.scale) || !(at.scale > 0.0))
        return fail(phrase("worlds.thing_place_no_number", {{"name", name}}));
    Material made;
    if (!material.empty()) {
        const MaterialSpec* spec = find_material(material);
        if (!spec) {
            std::vector<std::string> names;
            for (const MaterialSpec& row : material_library()) names.emplace_back(row.name);
            return fail(
                phrase("worlds.no_material", {{"material", material}, {"nearest", nearest_name(material, names)}}));
        }
        made.name = spec->name;
        made.sound = spec->sound;
    }
    Scene scene = world;
    Feature feature;
    feature.kind = FeatureKind::Object;
    feature.name = name;
    feature.material = material.empty() ? kDefaultMaterial : material_id(scene, made);
    feature.bounds_m = placed_bounds(own, at);
    scene.features.push_back(feature);
    const FeatureId id{static_cast<std::uint32_t>(scene.features.size() - 1)};
    Placement placement = at;
    placement.rotation = normalized(at.rotation);
    scene.placed.push_back({id, std::move(model), feature.material, placement});
    draw_placed(scene, scene.placed.back());
    return scene;
}

void move_placed(Scene& world, std::size_t thing, const Placement& at) {
    contract_pre(thing < world.placed.size() && world.placed[thing].model != nullptr);
    contract_pre(at.scale > 0.0 && is_finite(at.position_m));
    PlacedModel& placed = world.placed[thing];
    if (placed.at == at) return;
    placed.at = at;
    world.features[placed.feature.value].bounds_m = placed_bounds(touchable_bounds(*placed.model), at);
    undraw(world, placed.feature);
    draw_placed(world, placed);
}

Scene with_movers_apart(const Scene& world, std::size_t most_things, std::vector<int>& thing_of_mover) {
    Scene scene = world;
    thing_of_mover.assign(world.movers.size(), -1);
    std::vector<bool> leaves(world.features.size(), false);
    std::vector<std::uint32_t> movable;  // only the movable solids, as indices, because most solids cannot move
    for (std::uint32_t s = 0; s < world.solids.size(); ++s)
        if (world.solids[s].role == SolidRole::Mover) movable.push_back(s);
    for (std::size_t i = 0; i < world.movers.size(); ++i) {
        const Mover& mover = world.movers[i];
        if (!mover.moves() || scene.placed.size() >= most_things) continue;
        const auto own = [&](FeatureId feature) { return feature == mover.feature; };
        auto model = std::make_shared<Scene>();
        model->materials.emplace_back();
        model->features.push_back(world.features[mover.feature.value]);
        MaterialId material = kDefaultMaterial;
        for (const std::uint32_t s : movable) {
            const Solid& solid = world.solids[s];
            if (!own(solid.feature)) continue;
            if (!solid.face_materials.empty()) material = solid.face_materials.front();
            model->solids.push_back(seen_from(solid, mover.pivot_m));
            model->solids.back().feature = FeatureId{0};
        }
        for (const MeshTriangle& t : world.triangles)
            if (own(t.feature))
                model->triangles.push_back({t.a_m - mover.pivot_m, t.b_m - mover.pivot_m, t.c_m - mover.pivot_m,
                                            FeatureId{0}, kDefaultMaterial, t.side});
        if (model->solids.empty() && model->triangles.empty()) continue;
        model->bounds_m = touchable_bounds(*model);
        thing_of_mover[i] = static_cast<int>(scene.placed.size());
        leaves[mover.feature.value] = true;
        scene.placed.push_back({mover.feature, std::move(model), material, mover.at(mover.rests_far ? 1.0 : 0.0)});
    }
    const auto left = [&](FeatureId feature) { return feature.value < leaves.size() && leaves[feature.value]; };
    std::erase_if(scene.solids,
                  [&](const Solid& solid) { return solid.role == SolidRole::Mover && left(solid.feature); });
    std::erase_if(scene.triangles, [&](const MeshTriangle& t) { return left(t.feature); });
    std::erase_if(scene.surfaces, [&](const SurfacePolygon& surface) { return left(surface.feature); });
    for (const int thing : thing_of_mover) {
        if (thing < 0) continue;
        const PlacedModel& placed = scene.placed[static_cast<std::size_t>(thing)];
        scene.features[placed.feature.value].bounds_m = placed_bounds(placed.model->bounds_m, placed.at);
        draw_placed(scene, placed);
    }
    return scene;
}

Scene with_bodies_apart(Scene world, std::size_t most_things, std::vector<int>& thing_of_body) {
    thing_of_body.assign(world.bodies.size(), -1);
    if (world.bodies.empty()) return world;
    std::vector<int> body_of_feature(world.features.size(), -1);
    std::vector<std::shared_ptr<Scene>> models(world.bodies.size());
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const FeatureId feature = world.bodies[i].feature;
        if (world.placed.size() + i >= most_things || !world.find(feature)) continue;
        body_of_feature[feature.value] = static_cast<int>(i);
        models[i] = std::make_shared<Scene>();
        models[i]->materials.emplace_back();
        models[i]->features.push_back(world.features[feature.value]);
    }
    const auto body_of = [&](FeatureId feature) {
        return feature.value < body_of_feature.size() ? body_of_feature[feature.value] : -1;
    };
    const auto middle_of = [&](FeatureId feature) { return world.features[feature.value].bounds_m.centre_m(); };
    std::vector<MaterialId> material(world.bodies.size(), kDefaultMaterial);
    const auto moves = [&](const Solid& solid) {
        return solid.role == SolidRole::Mover && body_of(solid.feature) >= 0;
    };
    for (const Solid& solid : world.solids) {
        if (!moves(solid)) continue;
        const auto body = static_cast<std::size_t>(body_of(solid.feature));
        if (!solid.face_materials.empty()) material[body] = solid.face_materials.front();
        models[body]->solids.push_back(seen_from(solid, middle_of(solid.feature)));
        models[body]->solids.back().feature = FeatureId{0};
    }
    for (std::size_t i = 0; i < models.size(); ++i) {
        const FeatureId feature = world.bodies[i].feature;
        if (!models[i]) continue;
        if (models[i]->solids.empty()) {  // the model has no part with a volume
            body_of_feature[feature.value] = -1;
            continue;
        }
        models[i]->bounds_m = touchable_bounds(*models[i]);
        thing_of_body[i] = static_cast<int>(world.placed.size());
        world.placed.push_back({feature, std::move(models[i]), material[i], {middle_of(feature), {}, 1.0}});
    }
    std::erase_if(world.solids, moves);
    std::erase_if(world.surfaces, [&](const SurfacePolygon& surface) { return body_of(surface.feature) >= 0; });
    for (const int thing : thing_of_body) {
        if (thing < 0) continue;
        const PlacedModel& placed = world.placed[static_cast<std::size_t>(thing)];
        world.features[placed.feature.value].bounds_m = placed_bounds(placed.model->bounds_m, placed.at);
        draw_placed(world, placed);
    }
    return world;
}

Result<Scene> without_placed(const Scene& world, const std::string& name) {
    const int index = find_placed(world, name);
    if (index < 0) return fail(phrase("worlds.none_to_take", {{"name", name}}));
    Scene scene = world;
    undraw(scene, scene.placed[static_cast<std::size_t>(index)].feature);
    // The object's name stays, so that earlier references to it can still be resolved.
    scene.placed.erase(scene.placed.begin() + index);
    return scene;
}

}  // namespace handrail
