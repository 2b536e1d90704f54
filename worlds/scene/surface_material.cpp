#include "worlds/scene/surface_material.h"

#include "worlds/base/contract.h"

namespace handrail {

MaterialId library_material(Scene& scene, const MaterialSpec& spec) {
    Material material;
    material.name = spec.name;
    material.sound = spec.sound;
    return material_id(scene, material);
}

void give_material(Scene& scene, FeatureId feature, const MaterialSpec& spec) {
    contract_pre(scene.find(feature) != nullptr);
    const MaterialId id = library_material(scene, spec);
    scene.features[feature.value].material = id;
    for (Solid& solid : scene.solids)
        for (std::size_t face = 0; face < solid.face_features.size(); ++face)
            if (solid.feature == feature || solid.face_features[face] == feature) solid.face_materials[face] = id;
    for (MeshTriangle& triangle : scene.triangles)
        if (triangle.feature == feature) triangle.material = id;
    for (PlacedModel& placed : scene.placed)
        if (placed.feature == feature) placed.material = id;
    for (SurfacePolygon& surface : scene.surfaces)
        if (surface.feature == feature) surface.material = id;
}

}  // namespace handrail
