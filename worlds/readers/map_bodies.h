// Reads the free bodies of a map. An entity is one if cs_name is dynamic_box, dynamic_sphere or dynamic_cylinder, or if
// `free` is 1. Its keys give the mass or density, elasticity, rolling, the friction of its surface and a rubber string.
// One reading thread.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "worlds/readers/map_keys.h"
#include "worlds/scene/scene.h"

namespace handrail::readers {

struct BodyWish {
    FreeBody body;
    std::optional<double> mass_kg;  // empty: it follows from the volume and density_kg_per_m3
    double density_kg_per_m3 = 600.0;
    std::string string;  // targetname of the entity at the other end of its rubber string; empty: no string
    double string_n_per_m = 20.0;
    TextPlace string_place;
};

// dynamic: the entity is free unless `free` is 0. can_move: it is a separate thing that nothing else moves; if an
// entity that cannot move should be free, that is reported with its place. surface: what the entity's keys say about
// its surface.
std::optional<BodyWish> body_wish_of(const MapEntity& entity, bool dynamic, bool can_move, const Material& surface,
                                     const MapKeys& keys, Diagnostics& diagnostics);

class MapBodies {
public:
    // `feature` is the feature of the entity's solids in the scene. A body without volume, or beyond the maximum
    // number, stays fixed, and that is reported.
    void add(Scene& scene, const BodyWish& wish, FeatureId feature, TextPlace place, Diagnostics& diagnostics);
    // Notes an entity with a position and a name, to which a string can be tied. name: its targetname.
    void note_point(const std::string& name, const Vec3& at_m) { points_m_.emplace(name, at_m); }
    // Call after the last entity. Ties the strings; reports strings that lead nowhere and bodies beyond the maximum
    // number.
    void finish(Scene& scene, Diagnostics& diagnostics) const;

private:
    struct Tied {
        std::size_t body = 0;
        BodyWish wish;
    };
    std::vector<Tied> tied_;
    std::map<std::string, Vec3> points_m_;  // if a name occurs twice, the first place
    std::size_t too_many_ = 0;
    TextPlace first_too_many_;
};

}  // namespace handrail::readers
