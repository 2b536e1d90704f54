#include "worlds/scene/surface_material.h"

#include "worlds/base/contract.h"

namespace handrail {

void give_material(Scene& scene, FeatureId feature, const MaterialSpec& spec) {
    contract_pre(scene.find(feature) != nullptr);
    Material material;
    material.name = spec.name;
    material.sound = spec.sound;
    const MaterialId id = material_id(scene, material);
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
