#include "haptic/compile/compile_dynamics.h"

#include <cmath>

#include "worlds/base/contract.h"

namespace handrail::compile {
namespace {

bool stops_things(const Solid& solid) { return solid.role == SolidRole::Solid || solid.role == SolidRole::Mover; }

render::DynamicsPiece piece_of(const Solid& solid, FeatureId feature) {
    const MaterialId material = solid.face_materials.empty() ? kDefaultMaterial : solid.face_materials.front();
    if (!std::holds_alternative<std::monostate>(solid.round)) return render::make_piece(solid.round, feature, material);
    return render::make_piece(solid.shape, feature, material);
}

// Returns the feature that is named when a free body hits the solid: the solid's own feature, or else that of its first
// named face.
FeatureId feature_of(const Solid& solid) {
    if (solid.feature) return solid.feature;
    for (const FeatureId face : solid.face_features)
        if (face) return face;
    return kNoFeature;
}

std::vector<render::DynamicsPiece> pieces_of(const PlacedModel& placed) {
    std::vector<render::DynamicsPiece> pieces;
    for (const Solid& solid : placed.model->solids)
        if (stops_things(solid)) pieces.push_back(piece_of(solid, placed.feature));
    return pieces;
}

double volume_m3(std::span<const render::DynamicsPiece> pieces, double scale) {
    double sum = 0.0;
    for (const render::DynamicsPiece& piece : pieces) sum += render::mass_properties(piece).volume_m3;
    return sum * scale * scale * scale;
}

}  // namespace

std::shared_ptr<const render::DynamicsScene> compile_dynamics(const Scene& scene, std::span<const FreeThing> free,
                                                              const Vec3& origin_m, DynamicsReport* report) {
    DynamicsReport done;
    done.driven.assign(scene.placed.size(), render::kNoBody);
    done.bodies.assign(scene.placed.size(), render::kNoBody);
    render::DynamicsSceneBuilder builder(origin_m);
    for (std::size_t i = 0; i < free.size(); ++i) {
        contract_pre(free[i].placed < scene.placed.size());
        const PlacedModel& placed = scene.placed[free[i].placed];
        const std::vector<render::DynamicsPiece> pieces = pieces_of(placed);
        render::BodyNature nature = free[i].nature;
        if (free[i].density_kg_per_m3 > 0.0)
            nature.mass_kg = free[i].density_kg_per_m3 * volume_m3(pieces, placed.at.scale);
        render::BodyFault fault = render::BodyFault::None;
        if (free[i].density_kg_per_m3 > 0.0 && !(nature.mass_kg > 0.0)) fault = render::BodyFault::NoVolume;
        else if (done.bodies[free[i].placed] == render::kNoBody)
            fault =
                builder.add_body(pieces, placed.feature, static_cast<std::uint32_t>(free[i].placed), placed.at, nature);
        else continue;  // ignores a thing that was requested twice
        if (fault != render::BodyFault::None) {
            done.refused.push_back({i, fault});
            continue;
        }
        done.bodies[free[i].placed] = static_cast<std::uint32_t>(done.mass_kg.size());
        done.mass_kg.push_back(nature.mass_kg);
    }
    std::shared_ptr<const render::DynamicsScene> made;
    if (!done.mass_kg.empty()) {
        for (const Solid& solid : scene.solids)
            if (stops_things(solid)) builder.add_fixed(piece_of(solid, feature_of(solid)));
        for (const MeshTriangle& t : scene.triangles) builder.add_sheet(t.a_m, t.b_m, t.c_m, t.feature);
        for (std::size_t i = 0; i < scene.placed.size(); ++i) {
            const PlacedModel& placed = scene.placed[i];
            if (done.bodies[i] == render::kNoBody)
                done.driven[i] =
                    builder.add_driven(pieces_of(placed), placed.feature, static_cast<std::uint32_t>(i), placed.at);
        }
        made = builder.build();
    }
    if (report) *report = std::move(done);
    return made;
}

}  // namespace handrail::compile
