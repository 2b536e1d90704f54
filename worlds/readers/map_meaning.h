// Determines, from the class and the keys of an entity, what the entity's brushes become. Used on the reading thread
// only.
#pragma once

#include <optional>
#include <string>

#include "worlds/readers/map_bodies.h"
#include "worlds/readers/map_keys.h"
#include "worlds/readers/map_soft.h"
#include "worlds/readers/map_surfaces.h"
#include "worlds/scene/primitive.h"
#include "worlds/scene/scene.h"

namespace handrail::readers {

struct MapMeaning {
    SolidRole role = SolidRole::Solid;
    // The brushes are replaced with one exact shape of this kind in the box around them.
    std::optional<PrimitiveKind> exact;
    // True: the brushes are part of the building and not one thing; their walls are named by side.
    bool structure = false;
    bool liquid = false;  // true if cs_name is "liquid"
    Feature feature;      // feature of the whole entity; not used if `structure` is true
    std::optional<double> viscosity_ns_per_m;
    double buoyancy_n = 0.0, film_n = 0.0;
    Vec3 flow_hand_m_per_s{0.0};
    std::optional<SoftOptions> soft;
    std::optional<double> edge_rounding_hand_m;
    std::optional<BodyOptions> body;  // set if the entity is free to move
    Material surface;                 // surface as the keys state it; its name is a library material or empty
    std::string look;                 // a text that is equal for surfaces with the same keys
    SourcePlace source;
};

class MapMeanings {
public:
    // The referenced objects must outlive this object.
    MapMeanings(double metres_per_unit, Diagnostics& diagnostics, const MapKeys& keys, MapSurfaces& surfaces)
        : units_(metres_per_unit), diagnostics_(diagnostics), keys_(keys), surfaces_(surfaces) {}

    // Determines what `entity` becomes. `index` is its index in the file, `class_name` its class in lower case.
    MapMeaning read(const MapEntity& entity, const std::string& class_name, int index);

private:
    std::optional<PrimitiveKind> shape_of(const MapEntity& entity, bool world, const MapMeaning& meaning);

    double units_;
    Diagnostics& diagnostics_;
    const MapKeys& keys_;
    MapSurfaces& surfaces_;
};

}  // namespace handrail::readers
