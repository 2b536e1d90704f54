#include "haptic/compile/touch_model.h"

#include <algorithm>
#include <array>

#include "worlds/base/language.h"

namespace handrail::compile {
namespace {

// Names in the order of ObstacleKind.
constexpr std::array<std::string_view, render::kObstacleKinds> kKinds{
    "triangles", "polygons", "boxes", "brushes", "spheres", "capsules", "cylinders", "cones", "shapes_of_their_own"};
// Names in the order of EffectLaw's alternatives.
constexpr std::array<std::string_view, std::variant_size_v<render::EffectLaw>> kLaws{
    "magnets", "detents", "buttons", "fly_papers", "masses", "steady_forces", "vibrations", "custom_effects"};

}  // namespace

TouchModel touch_model(const render::HapticScene& scene) {
    TouchModel model;
    const auto count = [&](std::string_view key, std::size_t n) {
        model.parts.push_back({key, n});
        return n > 0;
    };
    const auto stage = [&](std::string_view name, bool on) {
        (on ? model.stages_on : model.stages_off).push_back(name);
    };
    const auto count_if = [](const auto& all, auto&& chosen) {
        return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), chosen));
    };

    std::array<std::size_t, render::kObstacleKinds> obstacles = scene.obstacle_counts();
    bool one_sided = scene.one_sided_sheets;
    for (const render::HapticBody& body : scene.bodies) {
        const std::array<std::size_t, render::kObstacleKinds> of_body = body.shape->obstacle_counts();
        for (std::size_t kind = 0; kind < render::kObstacleKinds; ++kind) obstacles[kind] += of_body[kind];
        one_sided = one_sided || body.shape->one_sided_sheets;
    }
    for (std::size_t kind = 0; kind < render::kObstacleKinds; ++kind) count(kKinds[kind], obstacles[kind]);
    stage("sheets of one side", one_sided);
    stage("bodies", count("bodies", scene.bodies.size()));

    std::size_t soft_sides = scene.soft_patches.size();
    for (const render::HapticBody& body : scene.bodies) soft_sides += body.shape->soft_patches.size();
    count("soft_sides", soft_sides);

    const auto drags = [](const render::LiquidVolume& l) { return l.viscosity_ns_per_m > 0.0; };
    count("liquids", scene.liquids.size());
    count("liquids_with_drag", count_if(scene.liquids, drags));
    stage("liquids", !scene.liquids.empty());
    stage("liquid surfaces", scene.liquid_surfaces);

    for (std::size_t law = 0; law < kLaws.size(); ++law)
        count(kLaws[law], count_if(scene.effects, [&](const render::EffectVolume& e) { return e.law.index() == law; }));
    stage("effects", !scene.effects.empty());

    count("textures", scene.reliefs.size());
    stage("textures and shading", scene.fields);

    count("touch_materials", scene.materials.size());
    count("materials_with_stiffness",
          count_if(scene.materials, [](const render::HapticMaterial& m) { return m.stiffness_fraction >= 0.0; }));
    count("materials_with_friction",
          count_if(scene.materials, [](const render::HapticMaterial& m) { return m.friction_kinetic >= 0.0; }));
    const auto is_rounded = [](const render::Obstacle& o) { return o.rounding != 0; };
    std::size_t rounded = count_if(scene.obstacles, is_rounded);
    for (const render::HapticBody& body : scene.bodies) rounded += count_if(body.shape->obstacles, is_rounded);
    count("rounded_solids", rounded);
    return model;
}

std::string spoken_part(const TouchModel::Part& part) {
    return phrase("touch_part." + std::string(part.key), {{"n", part.count}});
}

std::string spoken_stage(std::string_view stage) {
    std::string key = "touch_stage." + std::string(stage);
    std::replace(key.begin(), key.end(), ' ', '_');
    return phrase(key);
}

}  // namespace handrail::compile
