#include "worlds/readers/map_bodies.h"

#include <algorithm>

#include "worlds/geometry/mass_properties.h"

namespace handrail::readers {
namespace {

constexpr NumberKey kMass{"mass", FreeBody::kLeast_kg, FreeBody::kMost_kg, "map.range_kilograms"};
constexpr NumberKey kDensity{"density", 20.0, 20000.0, "map.range_density"};
constexpr NumberKey kElasticity{"elasticity", 0.0, 0.95, "map.range"};
constexpr NumberKey kRolling{"rolling", 0.0, 1.0, "map.range"};
constexpr NumberKey kStringStiffness{"stiffness_n_per_m", 0.1, 10000.0, "map.range_stiffness"};
constexpr double kStaticOverSliding = 1.25;

double volume_of(const Scene& scene, FeatureId feature) {
    double sum_m3 = 0.0;
    for (const Solid& solid : scene.solids) {
        if (solid.feature != feature || solid.role != SolidRole::Mover) continue;
        const bool flat = std::holds_alternative<std::monostate>(solid.round);
        sum_m3 += (flat ? mass_properties(solid.shape) : mass_properties(solid.round)).volume_m3;
    }
    return sum_m3;
}

}  // namespace

std::optional<BodyOptions> body_options_of(const MapEntity& entity, bool dynamic, bool can_move,
                                           const Material& surface, const MapKeys& keys, Diagnostics& diagnostics) {
    const MapKey* key = entity.find("free");
    if (key ? !keys.yes_no_of(entity, "free") : !dynamic) return std::nullopt;
    if (!can_move) {
        diagnostics.warn(key ? key->place : entity.place, "map.then_stays", "map.free_fixed");
        return std::nullopt;
    }
    BodyOptions options;
    options.mass_kg = keys.number_of(entity, kMass);
    options.density_kg_per_m3 = keys.number_of(entity, kDensity).value_or(options.density_kg_per_m3);
    FreeBody& body = options.body;
    body.elasticity = keys.number_of(entity, kElasticity).value_or(body.elasticity);
    body.rolling = keys.number_of(entity, kRolling).value_or(body.rolling);
    body.friction = surface.friction_mu.value_or(body.friction);
    body.friction_static =
        std::max(body.friction, surface.friction_static.value_or(kStaticOverSliding * body.friction));
    body.by_density = !options.mass_kg;
    if (const MapKey* string = entity.find("string")) {
        options.string = trimmed(string->value);
        options.string_place = string->place;
        options.string_n_per_m = keys.number_of(entity, kStringStiffness).value_or(options.string_n_per_m);
        if (options.string.empty()) diagnostics.warn(string->place, "map.then_loose", "map.string_empty");
    }
    return options;
}

void MapBodies::add(Scene& scene, const BodyOptions& options, FeatureId feature, TextPlace place,
                    Diagnostics& diagnostics) {
    const double volume_m3 = volume_of(scene, feature);
    if (!(volume_m3 > 0.0)) {
        diagnostics.warn(place, "map.then_stays", "map.body_no_volume");
        return;
    }
    if (scene.bodies.size() >= FreeBody::kMost) {
        if (too_many_++ == 0) first_too_many_ = place;
        return;
    }
    FreeBody body = options.body;
    body.feature = feature;
    body.source = scene.features[feature.value].source;
    const double mass_kg = options.mass_kg.value_or(options.density_kg_per_m3 * volume_m3);
    body.mass_kg = std::clamp(mass_kg, FreeBody::kLeast_kg, FreeBody::kMost_kg);
    if (body.mass_kg != mass_kg)
        diagnostics.warn(place, "map.then_number", "map.body_mass", {{"mass", mass_kg}, {"taken", body.mass_kg}});
    if (!options.string.empty()) tied_.push_back({scene.bodies.size(), options});
    scene.bodies.push_back(body);
}

void MapBodies::finish(Scene& scene, Diagnostics& diagnostics) const {
    for (const Tied& tied : tied_) {
        const auto point = points_m_.find(tied.options.string);
        if (point == points_m_.end()) {
            diagnostics.warn(tied.options.string_place, "map.then_loose", "map.string_nowhere",
                             {{"name", excerpt(tied.options.string)}});
            continue;
        }
        scene.bodies[tied.body].string_at_m = point->second;
        scene.bodies[tied.body].string_n_per_m = tied.options.string_n_per_m;
    }
    if (too_many_ > 0)
        diagnostics.warn(first_too_many_, "map.then_stay", "map.too_many_bodies",
                         {{"most", FreeBody::kMost}, {"count", too_many_}});
}

}  // namespace handrail::readers
