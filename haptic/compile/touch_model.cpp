#include "haptic/compile/touch_model.h"

#include <algorithm>
#include <array>

namespace handrail {
namespace {

struct Row {
    std::string_view key, one;
};
// In the order of ObstacleKind.
constexpr std::array kKinds{Row{"triangles", "triangle"}, Row{"polygons", "polygon"}, Row{"boxes", "box"},
                            Row{"brushes", "brush"},      Row{"spheres", "sphere"},   Row{"capsules", "capsule"},
                            Row{"cylinders", "cylinder"}, Row{"cones", "cone"},       Row{"shapes_of_their_own", "shape of its own"}};
static_assert(kKinds.size() == kObstacleKinds);
// In the order of EffectLaw's alternatives.
constexpr std::array kLaws{
    Row{"magnets", "magnet"}, Row{"detents", "row of notches"},     Row{"buttons", "button"},       Row{"fly_papers", "fly-paper"},
    Row{"masses", "mass"},    Row{"steady_forces", "steady force"}, Row{"vibrations", "vibration"}, Row{"custom_effects", "effect of its own"}};
static_assert(kLaws.size() == std::variant_size_v<EffectLaw>);

}  // namespace

TouchModel touch_model(const HapticScene& scene) {
    TouchModel model;
    const auto count = [&](std::string_view key, std::string_view one, std::size_t n) {
        model.parts.push_back({key, one, n});
        return n > 0;
    };
    const auto stage = [&](std::string_view name, bool on) { (on ? model.stages_on : model.stages_off).push_back(name); };
    const auto count_if = [](const auto& all, auto&& chosen) { return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), chosen)); };

    std::array<std::size_t, kObstacleKinds> obstacles = scene.obstacle_counts();
    bool one_sided = scene.one_sided_sheets;
    for (const HapticBody& body : scene.bodies) {
        const std::array<std::size_t, kObstacleKinds> of_body = body.shape->obstacle_counts();
        for (std::size_t kind = 0; kind < kObstacleKinds; ++kind) obstacles[kind] += of_body[kind];
        one_sided = one_sided || body.shape->one_sided_sheets;
    }
    for (std::size_t kind = 0; kind < kObstacleKinds; ++kind) count(kKinds[kind].key, kKinds[kind].one, obstacles[kind]);
    stage("sheets of one side", one_sided);
    stage("bodies", count("bodies", "body that may move", scene.bodies.size()));

    const auto drags = [](const LiquidVolume& l) { return l.viscosity_ns_per_m > 0.0; };
    count("liquids", "liquid", scene.liquids.size());
    count("liquids_with_drag", "liquid with drag", count_if(scene.liquids, drags));
    stage("liquids", !scene.liquids.empty());
    stage("liquid surfaces", scene.liquid_surfaces);

    for (std::size_t law = 0; law < kLaws.size(); ++law)
        count(kLaws[law].key, kLaws[law].one, count_if(scene.effects, [&](const EffectVolume& e) { return e.law.index() == law; }));
    stage("effects", !scene.effects.empty());

    count("textures", "texture", scene.reliefs.size());
    stage("textures and shading", scene.fields);

    count("touch_materials", "material", scene.materials.size());
    count("materials_with_stiffness", "material with a stiffness of its own",
          count_if(scene.materials, [](const HapticMaterial& m) { return m.stiffness_fraction >= 0.0; }));
    count("materials_with_friction", "material with a friction of its own",
          count_if(scene.materials, [](const HapticMaterial& m) { return m.friction_kinetic >= 0.0; }));
    const auto is_rounded = [](const Obstacle& o) { return o.rounding != 0; };
    std::size_t rounded = count_if(scene.obstacles, is_rounded);
    for (const HapticBody& body : scene.bodies) rounded += count_if(body.shape->obstacles, is_rounded);
    count("rounded_solids", "solid with rounded edges", rounded);
    return model;
}

}  // namespace handrail
