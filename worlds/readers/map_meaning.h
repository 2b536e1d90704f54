// Decides what an entity of a map makes of its brushes, by its class and its keys. One reading thread.
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
    std::optional<PrimitiveKind> exact;  // replaces the brushes with one exact shape in the box around them
    bool structure = false;              // true: part of the building, not one thing; its walls are named by side
    bool liquid = false;                 // cs_name is "liquid"
    Feature feature;                     // not used if `structure` is true
    std::optional<double> viscosity_ns_per_m;
    double buoyancy_n = 0.0, film_n = 0.0;
    Vec3 flow_hand_m_per_s{0.0};
    std::optional<SoftWish> soft;
    std::optional<BodyWish> body;  // set if it is free to move
    Material surface;              // what the keys say; its name is one of the library, or empty
    std::string look;              // equal for surfaces with the same keys
    SourcePlace source;
};

class MapMeanings {
public:
    // The referenced objects must outlive this object.
    MapMeanings(double metres_per_unit, Diagnostics& diagnostics, const MapKeys& keys, MapSurfaces& surfaces)
        : units_(metres_per_unit), diagnostics_(diagnostics), keys_(keys), surfaces_(surfaces) {}

    // `index`: the entity's index in the file. `class_name`: in lower case.
    MapMeaning read(const MapEntity& entity, const std::string& class_name, int index);

private:
    std::optional<PrimitiveKind> shape_of(const MapEntity& entity, bool world, const MapMeaning& meaning);

    double units_;
    Diagnostics& diagnostics_;
    const MapKeys& keys_;
    MapSurfaces& surfaces_;
};

}  // namespace handrail::readers
