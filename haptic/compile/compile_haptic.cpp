#include "haptic/compile/compile_haptic.h"

#include "haptic/compile/compile_effects.h"

#include <algorithm>

namespace handrail {
namespace {

HapticMaterial compile_material(const Material& material, MaterialSource source) {
    HapticMaterial compiled;
    const MaterialSpec* known = source == MaterialSource::Library && !material.name.empty() ? find_material(material.name) : nullptr;
    if (known) {
        compiled.stiffness_fraction = known->stiffness_fraction;
        compiled.friction_static = compiled.friction_kinetic = known->friction_mu;
    }
    if (material.stiffness_fraction) compiled.stiffness_fraction = *material.stiffness_fraction;
    if (material.friction_mu) compiled.friction_static = compiled.friction_kinetic = *material.friction_mu;
    return compiled;
}

// An object, mover or volume is named as a whole; a wall by its face.
std::vector<SurfaceLabel> labels_of(const Solid& solid) {
    std::vector<SurfaceLabel> labels(solid.shape.planes.size());
    for (std::size_t face = 0; face < labels.size(); ++face) {
        labels[face].feature = solid.face_features[face] ? solid.face_features[face] : solid.feature;
        labels[face].material = solid.face_materials[face];
        labels[face].hidden = solid.face_hidden[face];
    }
    return labels;
}

// What of a model can be touched, all under one name and of one material.
std::shared_ptr<const HapticScene> compile_model(const Scene& model, const SurfaceLabel& label) {
    HapticSceneBuilder builder;
    for (const Solid& solid : model.solids)
        if (solid.role == SolidRole::Solid || solid.role == SolidRole::Mover) builder.add_solid(solid.shape.planes, solid.shape.bounds_m, label);
    for (const MeshTriangle& t : model.triangles) builder.add_triangle(t.a_m, t.b_m, t.c_m, label);
    return builder.build();
}

}  // namespace

std::shared_ptr<const HapticScene> compile_haptic(const Scene& scene, MaterialSource materials, std::uint32_t world) {
    std::vector<HapticMaterial> compiled;
    compiled.reserve(scene.materials.size());
    for (const Material& material : scene.materials) compiled.push_back(compile_material(material, materials));
    HapticSceneBuilder builder(std::move(compiled));
    for (const Solid& solid : scene.solids) {
        if (solid.role == SolidRole::Solid || solid.role == SolidRole::Mover) {
            builder.add_solid(solid.shape.planes, solid.shape.bounds_m, labels_of(solid));
        } else if (solid.role == SolidRole::Liquid) {
            LiquidVolume liquid;
            liquid.planes = solid.shape.planes;
            liquid.hidden = solid.face_hidden;
            liquid.feature = solid.feature;
            liquid.viscosity_ns_per_m = solid.viscosity_ns_per_m.value_or(0.0);
            liquid.buoyancy_n = solid.buoyancy_n;
            liquid.film_n = solid.film_n;
            liquid.flow_hand_m_per_s = solid.flow_hand_m_per_s;
            builder.add_liquid(std::move(liquid), solid.shape.bounds_m);
        }
    }
    for (const MeshTriangle& t : scene.triangles) builder.add_triangle(t.a_m, t.b_m, t.c_m, {t.feature, t.material, false});
    for (const PlacedModel& placed : scene.placed)
        builder.add_body(placed.feature, compile_model(*placed.model, {placed.feature, placed.material, false}), placed.at);
    add_effects(builder, scene);
    return builder.build(world);
}

}  // namespace handrail
