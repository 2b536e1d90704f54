#include "worlds/scene/outer_ground.h"

#include <algorithm>

namespace handrail {

Aabb building_bounds_m(const Scene& scene) {
    if (std::none_of(scene.features.begin(), scene.features.end(), is_outer_ground)) return scene.bounds_m;
    Aabb building;
    for (const Feature& feature : scene.features)
        if (!is_outer_ground(feature) && !feature.bounds_m.empty() && feature.kind != FeatureKind::Trigger)
            building.include(feature.bounds_m);
    for (const Solid& solid : scene.solids) {
        const bool counts = solid.role == SolidRole::Solid || solid.role == SolidRole::Mover;
        const Feature* feature = counts ? scene.find(solid.feature) : nullptr;
        if (counts && !(feature && is_outer_ground(*feature))) building.include(solid.shape.bounds_m);
    }
    return building.empty() ? scene.bounds_m : building;
}

}  // namespace handrail
