// What a map says of its things that are free to move: cs_name dynamic_box, dynamic_sphere and dynamic_cylinder, or
// `free` 1, with mass or density, elasticity, rolling and the friction of its surface. One reading thread.
#pragma once

#include <optional>

#include "worlds/readers/map_keys.h"
#include "worlds/scene/scene.h"

namespace handrail {

struct BodyWish {
    FreeBody body;
    std::optional<double> mass_kg;  // none: by its volume and density_kg_per_m3
    double density_kg_per_m3 = 600.0;
};

// dynamic: free unless `free` says no. can_move: a thing by itself that nothing else moves; where one that cannot is to
// be free that is told with its place. surface: what the keys of the entity say of it.
std::optional<BodyWish> body_wish_of(const MapEntity& entity, bool dynamic, bool can_move, const Material& surface,
                                     const MapKeys& keys, Diagnostics& diagnostics);

class MapBodies {
public:
    // The entity's solids are in the scene, under this name. What has no volume, and what would be one too many, stays
    // where it is, which is told.
    void add(Scene& scene, const BodyWish& wish, FeatureId feature, TextPlace place, Diagnostics& diagnostics);
    // After the last entity.
    void tell_too_many(Diagnostics& diagnostics) const;

private:
    std::size_t too_many_ = 0;
    TextPlace first_too_many_;
};

}  // namespace handrail
