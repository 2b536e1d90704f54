// Reads the free bodies of a map. An entity is a free body if cs_name is dynamic_box, dynamic_sphere or
// dynamic_cylinder, or if `free` is 1. Its keys give its mass or density, elasticity, rolling resistance, surface
// friction and rubber string. Used on the reading thread only.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "worlds/readers/map_keys.h"
#include "worlds/scene/scene.h"

namespace handrail::readers {

struct BodyOptions {
    FreeBody body;
    std::optional<double> mass_kg;  // empty: the mass follows from the volume and density_kg_per_m3
    double density_kg_per_m3 = 600.0;
    std::string string;  // targetname of the entity to which the rubber string is tied; empty: no string
    double string_n_per_m = 20.0;
    TextPlace string_place;
};

// Reads the keys of one entity. Set `dynamic` if its cs_name is one of dynamic_*: the entity is then free unless `free`
// is 0. Set `can_move` if the entity is a separate object that nothing else moves. If the keys request a free body
// although `can_move` is false, the function reports that with its place. `surface` contains the values of the entity's
// surface keys. Returns nothing if the entity is not free.
std::optional<BodyOptions> body_options_of(const MapEntity& entity, bool dynamic, bool can_move,
                                           const Material& surface, const MapKeys& keys, Diagnostics& diagnostics);

class MapBodies {
public:
    // Adds a free body. `feature` is the feature of the entity's solids in the scene. A body without volume, or beyond
    // the maximum number of bodies, stays fixed, and the function reports it.
    void add(Scene& scene, const BodyOptions& options, FeatureId feature, TextPlace place, Diagnostics& diagnostics);
    // Stores the position and name of an entity, so that a string can be tied to it. `name` is the entity's targetname.
    void note_point(const std::string& name, const Vec3& at_m) { points_m_.emplace(name, at_m); }
    // Call after the last entity. Ties the strings to their entities. Reports strings whose target is missing and the
    // bodies beyond the maximum number.
    void finish(Scene& scene, Diagnostics& diagnostics) const;

private:
    struct Tied {
        std::size_t body = 0;
        BodyOptions options;
    };
    std::vector<Tied> tied_;
    std::map<std::string, Vec3> points_m_;  // positions by targetname; if a name occurs twice, the first position
    std::size_t too_many_ = 0;
    TextPlace first_too_many_;
};

}  // namespace handrail::readers
