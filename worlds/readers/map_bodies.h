// What a map says of its things that are free to move: cs_name dynamic_box, dynamic_sphere and dynamic_cylinder, or
// `free` 1, with mass or density, elasticity, rolling, the friction of its surface and a rubber string. One reading
// thread.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "worlds/readers/map_keys.h"
#include "worlds/scene/scene.h"

namespace handrail {

struct BodyWish {
    FreeBody body;
    std::optional<double> mass_kg;  // none: by its volume and density_kg_per_m3
    double density_kg_per_m3 = 600.0;
    std::string string;  // targetname of what its rubber string is tied to; empty: none
    double string_n_per_m = 20.0;
    TextPlace string_place;
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
    // An entity with a place and a name, to which a string can be tied. name: its targetname.
    void note_point(const std::string& name, const Vec3& at_m) { points_m_.emplace(name, at_m); }
    // After the last entity: ties strings, and tells of those that lead nowhere and of bodies beyond the most.
    void finish(Scene& scene, Diagnostics& diagnostics) const;

private:
    struct Tied {
        std::size_t body = 0;
        BodyWish wish;
    };
    std::vector<Tied> tied_;
    std::map<std::string, Vec3> points_m_;  // the first of a name
    std::size_t too_many_ = 0;
    TextPlace first_too_many_;
};

}  // namespace handrail
