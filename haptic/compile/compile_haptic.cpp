#include "haptic/compile/compile_haptic.h"

#include "haptic/compile/compile_effects.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "worlds/base/contract.h"
#include "worlds/base/overloaded.h"
#include "worlds/scene/groups.h"

namespace handrail::compile {
namespace {

render::Relief relief_of(const TextureWave& wave) {
    render::Relief relief;
    relief.kind = wave.shape == WaveShape::Sine     ? render::ReliefKind::Sine
                  : wave.shape == WaveShape::Square ? render::ReliefKind::Square
                                                    : render::ReliefKind::Level;
    relief.depth_hand_m = wave.depth_hand_m;
    relief.period_hand_m = wave.period_hand_m;
    relief.friction_share = wave.friction_share;
    relief.turn_cos = std::cos(wave.turn_rad);
    relief.turn_sin = std::sin(wave.turn_rad);
    return relief;
}

// Cache of the scene's reliefs. Many materials may use the same picture, so the levels of each picture are computed
// only once.
class Reliefs {
public:
    std::int32_t add(const Material& material, const MaterialSpec* known) {
        std::optional<TextureWave> wave = material.wave;
        if (!wave && known && known->wave != TextureWave{}) wave = known->wave;
        if (!wave && !material.picture) return -1;
        render::Relief relief = relief_of(wave.value_or(TextureWave{}));
        if (const auto& picture = material.picture) {
            relief.kind = render::ReliefKind::Picture;
            relief.depth_hand_m = picture->depth_hand_m;
            relief.turn_cos = std::cos(picture->turn_rad);
            relief.turn_sin = std::sin(picture->turn_rad);
            relief.low_m = picture->box_m.min_m;
            relief.high_m = picture->box_m.max_m;
            relief.size_m = picture->size_m;
            std::shared_ptr<const render::HeightField>& field = fields_[picture->heights.get()];
            if (!field)
                field = std::make_shared<const render::HeightField>(picture->heights->width, picture->heights->height,
                                                                    picture->heights->depths);
            relief.picture = field;
        }
        list_.push_back(std::move(relief));
        return static_cast<std::int32_t>(list_.size() - 1);
    }
    std::vector<render::Relief> take() { return std::move(list_); }

private:
    std::vector<render::Relief> list_;
    std::map<const HeightPicture*, std::shared_ptr<const render::HeightField>> fields_;
};

render::HapticMaterial compile_material(const Material& material, MaterialSource source, Reliefs& reliefs) {
    render::HapticMaterial compiled;
    const MaterialSpec* known =
        source == MaterialSource::Library && !material.name.empty() ? find_material(material.name) : nullptr;
    if (known) {
        compiled.stiffness_fraction = known->stiffness_fraction;
        compiled.friction_static = known->friction_static;
        compiled.friction_kinetic = known->friction_mu;
        compiled.damping_ns_per_m = known->damping_ns_per_m;
    }
    if (material.stiffness_fraction) compiled.stiffness_fraction = *material.stiffness_fraction;
    if (material.friction_mu) compiled.friction_static = compiled.friction_kinetic = *material.friction_mu;
    if (material.friction_static) compiled.friction_static = *material.friction_static;
    if (material.damping_ns_per_m) compiled.damping_ns_per_m = *material.damping_ns_per_m;
    compiled.relief = reliefs.add(material, known);
    return compiled;
}

// Returns for each feature the axis along which textures are projected on its mesh: the axis in which the feature is
// thinnest, or z if two are equal. The texture is then continuous over every edge, however the mesh is divided into
// facets. A moving thing uses the axes of its own frame, so its texture moves with it.
std::vector<std::uint8_t> mesh_axes(const Scene& scene) {
    std::vector<Aabb> boxes(scene.features.size());
    const auto include = [&](FeatureId feature, const MeshTriangle& t) {
        if (feature.value >= boxes.size()) return;
        for (const Vec3& p : {t.a_m, t.b_m, t.c_m}) boxes[feature.value].include(p);
    };
    for (const MeshTriangle& t : scene.triangles) include(t.feature, t);
    for (const PlacedModel& placed : scene.placed)
        for (const MeshTriangle& t : placed.model->triangles) include(placed.feature, t);
    std::vector<std::uint8_t> axes(boxes.size(), 2);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].empty()) continue;
        const Vec3 size = boxes[i].size_m();
        if (size.y < size.z && size.y <= size.x) axes[i] = 1;
        else if (size.x < size.z && size.x < size.y) axes[i] = 0;
    }
    return axes;
}

// Returns one label for each face. All faces of an object, mover or volume have the same name, while each face of a
// wall has a name of its own.
std::vector<render::SurfaceLabel> labels_of(const Solid& solid) {
    std::vector<render::SurfaceLabel> labels(solid.shape.planes.size());
    for (std::size_t face = 0; face < labels.size(); ++face) {
        labels[face].feature = solid.face_features[face] ? solid.face_features[face] : solid.feature;
        labels[face].material = solid.face_materials[face];
        labels[face].hidden = solid.face_hidden[face];
    }
    return labels;
}

void add_coarser(std::vector<CoarserMesh>& all, const CoarserMesh& one) {
    const auto known =
        std::find_if(all.begin(), all.end(), [&](const CoarserMesh& other) { return other.feature == one.feature; });
    if (known == all.end()) return all.push_back(one);
    known->before += one.before;
    known->after += one.after;
    known->off_m = std::max(known->off_m, one.off_m);
}

// Adds mesh triangles. The triangles of one feature and material that are touched from the same side form one surface.
// If `label` is given, it replaces the labels of the triangles. `scale` is the factor by which the model is enlarged in
// the world.
void add_triangles_of(render::HapticSceneBuilder& builder, const std::vector<MeshTriangle>& triangles, TouchSide side,
                      const render::SurfaceLabel* label, double scale, const CompileOptions& options,
                      CompileReport& report) {
    std::vector<render::SurfaceLabel> labels;
    std::map<std::pair<std::uint32_t, MaterialId>, std::uint32_t> known;
    std::vector<Vec3> corners_m;
    std::vector<std::uint32_t> surfaces;
    corners_m.reserve(3 * triangles.size());
    surfaces.reserve(triangles.size());
    for (const MeshTriangle& t : triangles) {
        if (t.side != side) continue;
        corners_m.insert(corners_m.end(), {t.a_m, t.b_m, t.c_m});
        const render::SurfaceLabel own = label ? *label : render::SurfaceLabel{t.feature, t.material, false};
        const auto [surface, is_new] =
            known.try_emplace({own.feature.value, own.material}, static_cast<std::uint32_t>(labels.size()));
        if (is_new) labels.push_back(own);
        surfaces.push_back(surface->second);
    }
    if (surfaces.empty()) return;
    MeshOptions how = options.mesh;
    how.simplify_m /= scale;
    const auto begins = [&](std::uint32_t surface, std::size_t count) {
        if (options.simplifies) options.simplifies(labels[surface].feature, count);
    };
    const PreparedMesh mesh = prepare_mesh(corners_m, surfaces, how, options.stop, begins);
    std::vector<render::SurfaceLabel> of_triangles;
    of_triangles.reserve(mesh.surfaces.size());
    for (const std::uint32_t surface : mesh.surfaces) of_triangles.push_back(labels[surface]);
    builder.add_mesh(mesh.mesh, of_triangles, side);
    for (std::size_t i = 0; i < mesh.polygons.size(); ++i)
        builder.add_polygon(mesh.polygons[i].points_m, labels[mesh.polygon_surfaces[i]], side);
    report.mesh += mesh.report;
    for (const CoarserSurface& one : mesh.coarser)
        add_coarser(report.coarser, {labels[one.surface].feature, one.before, one.after, one.measured_m * scale});
}

void add_triangles(render::HapticSceneBuilder& builder, const std::vector<MeshTriangle>& triangles,
                   const render::SurfaceLabel* label, double scale, const CompileOptions& options,
                   CompileReport& report) {
    for (const TouchSide side : {TouchSide::Both, TouchSide::Front, TouchSide::Back})
        add_triangles_of(builder, triangles, side, label, scale, options, report);
}

// Adds one touchable solid. A round solid keeps its exact shape and gets the name of its first face.
void add_touchable(render::HapticSceneBuilder& builder, const Solid& solid,
                   std::span<const render::SurfaceLabel> labels, const RoundedSolid* rounded) {
    std::visit(Overloaded{[&](std::monostate) {
                              if (rounded)
                                  builder.add_solid(rounded->planes, rounded->bounds_m, labels, rounded->rounding_m);
                              else builder.add_solid(solid.shape.planes, solid.shape.bounds_m, labels);
                          },
                          [&](const SphereShape& sphere) { builder.add_sphere(sphere, labels[0]); },
                          [&](const CapsuleShape& capsule) { builder.add_capsule(capsule, labels[0]); },
                          [&](const CylinderShape& cylinder) { builder.add_cylinder(cylinder, labels[0]); },
                          [&](const ConeShape& cone) { builder.add_cone(cone, labels[0]); }},
               solid.round);
}

// Adds the hard part of a solid, and above it the soft patch that yields to pressure.
void add_soft_solid(render::HapticSceneBuilder& builder, const Solid& solid) {
    const SoftFace& soft = *solid.soft;
    std::vector<Plane> planes = solid.shape.planes;
    planes[soft.face].offset_m -= soft.depth_m;
    const std::vector<render::SurfaceLabel> labels = labels_of(solid);
    builder.add_solid(planes, solid.shape.bounds_m, labels);

    const std::vector<Vec3>& corners = solid.shape.faces[soft.face].points_m;
    render::SoftPatch patch;
    patch.feature = labels[soft.face].feature;
    patch.material = labels[soft.face].material;
    patch.depth_m = soft.depth_m;
    patch.stiffness_fraction = soft.stiffness_fraction;
    patch.plastic = soft.plastic;
    patch.recovery_s = soft.recovery_s;
    patch.yield_n = soft.yield_n;
    patch.outline_m = corners;
    // The patch's axis u points along its longest edge.
    double longest = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 edge = corners[(i + 1) % corners.size()] - corners[i];
        if (const double length = glm::length(edge); length > longest) {
            longest = length;
            patch.u = edge / length;
        }
    }
    const Vec3 normal = solid.shape.planes[soft.face].normal;
    patch.u = glm::normalize(patch.u - normal * glm::dot(patch.u, normal));
    patch.v = glm::normalize(glm::cross(normal, patch.u));
    double least_u = 1e300, most_u = -1e300, least_v = 1e300, most_v = -1e300;
    for (const Vec3& corner : corners) {
        least_u = std::min(least_u, glm::dot(corner, patch.u));
        most_u = std::max(most_u, glm::dot(corner, patch.u));
        least_v = std::min(least_v, glm::dot(corner, patch.v));
        most_v = std::max(most_v, glm::dot(corner, patch.v));
    }
    patch.size_u_m = most_u - least_u;
    patch.size_v_m = most_v - least_v;
    patch.corner_m = patch.u * least_u + patch.v * least_v + normal * solid.shape.planes[soft.face].offset_m;
    builder.add_soft(std::move(patch));
}

// Returns one rounded solid for each solid, or an empty vector if edges stay sharp.
std::vector<RoundedSolid> rounded_solids(const Scene& scene, double radius_m, const OwnRounding& own,
                                         const std::stop_token& stop, CompileReport& report) {
    if (!(radius_m > 0.0) && !(own.world_m_per_hand_m > 0.0)) return {};
    RoundingReport done;
    std::vector<RoundedSolid> solids = round_edges(scene, radius_m, done, stop, own);
    report.rounding += done;
    return solids;
}

// Compiles the touchable parts of a model, all with one name and one material. The rounding has a fixed size for the
// hand. A model that is placed enlarged therefore gets a smaller rounding in its own metres.
std::shared_ptr<const render::HapticScene> compile_model(const PlacedModel& placed, const CompileOptions& options,
                                                         CompileReport& report) {
    const Scene& model = *placed.model;
    const render::SurfaceLabel label{placed.feature, placed.material, false};
    render::HapticSceneBuilder builder;
    const std::vector<RoundedSolid> rounded = rounded_solids(
        model, options.edge_rounding_m / placed.at.scale,
        {options.own_rounding.world_m_per_hand_m / placed.at.scale, options.own_rounding.most_m / placed.at.scale},
        options.stop, report);
    for (std::size_t i = 0; i < model.solids.size(); ++i)
        if (model.solids[i].role == SolidRole::Solid || model.solids[i].role == SolidRole::Mover)
            add_touchable(builder, model.solids[i], std::span(&label, 1), rounded.empty() ? nullptr : &rounded[i]);
    if (options.shade_meshes) builder.shade_meshes();
    add_triangles(builder, model.triangles, &label, placed.at.scale, options, report);
    return builder.build();
}

}  // namespace

CompileOptions exploring(double edge_rounding_m, std::uint32_t world, double mesh_tolerance_m) {
    contract_pre(edge_rounding_m >= 0.0);
    contract_pre(mesh_tolerance_m >= 0.0);
    CompileOptions options{MaterialSource::Library, world, MeshOptions{}, true, edge_rounding_m, {}, {}, {}};
    options.mesh.simplify_m = mesh_tolerance_m;
    options.mesh.simplify_from = kDenseFrom;
    return options;
}

bool has_dense_mesh(const Scene& scene) {
    std::vector<std::size_t> triangles(scene.features.size(), 0);
    for (const MeshTriangle& t : scene.triangles)
        if (t.feature.value < triangles.size() && ++triangles[t.feature.value] >= kDenseFrom) return true;
    return std::any_of(scene.placed.begin(), scene.placed.end(),
                       [](const PlacedModel& placed) { return placed.model->triangles.size() >= kDenseFrom; });
}

std::shared_ptr<const render::HapticScene> compile_haptic(const Scene& scene, MaterialSource materials) {
    CompileOptions options;
    options.materials = materials;
    options.shade_meshes = materials == MaterialSource::Library;
    return compile_haptic(scene, options);
}

std::shared_ptr<const render::HapticScene> compile_haptic(const Scene& whole, const CompileOptions& options,
                                                          CompileReport* report) {
    contract_pre(options.edge_rounding_m >= 0.0 && std::isfinite(options.edge_rounding_m));
    const std::optional<Scene> without_hidden = without_hidden_groups(whole);
    const Scene& scene = without_hidden ? *without_hidden : whole;
    CompileReport done;
    std::vector<render::HapticMaterial> compiled;
    compiled.reserve(scene.materials.size());
    Reliefs reliefs;
    for (const Material& material : scene.materials)
        compiled.push_back(compile_material(material, options.materials, reliefs));
    render::HapticSceneBuilder builder(std::move(compiled));
    if (std::vector<render::Relief> list = reliefs.take(); !list.empty())
        builder.set_reliefs(std::move(list), mesh_axes(scene));
    const std::vector<RoundedSolid> rounded =
        rounded_solids(scene, options.edge_rounding_m, options.own_rounding, options.stop, done);
    for (std::size_t i = 0; i < scene.solids.size(); ++i) {
        if (options.stop.stop_requested()) return nullptr;
        const Solid& solid = scene.solids[i];
        if (solid.role == SolidRole::Solid || solid.role == SolidRole::Mover) {
            if (solid.soft) add_soft_solid(builder, solid);
            else add_touchable(builder, solid, labels_of(solid), rounded.empty() ? nullptr : &rounded[i]);
        } else if (solid.role == SolidRole::Liquid) {
            render::LiquidVolume liquid;
            liquid.planes = solid.shape.planes;
            liquid.hidden = solid.face_hidden;
            liquid.feature = solid.feature;
            liquid.viscosity_ns_per_m = solid.viscosity_ns_per_m.value_or(0.0);
            liquid.buoyancy_n = solid.buoyancy_n;
            liquid.film_n = solid.film_n;
            liquid.flow_hand_m_per_s = solid.flow_hand_m_per_s;
            builder.add_liquid(std::move(liquid), solid.shape.bounds_m);
        }
    }
    if (options.shade_meshes) builder.shade_meshes();
    add_triangles(builder, scene.triangles, nullptr, 1.0, options, done);
    for (const PlacedModel& placed : scene.placed) {
        if (options.stop.stop_requested()) return nullptr;
        // A hidden thing stays in the list, so that the numbers of the bodies stay the same, but it has no surface.
        builder.add_body(placed.feature, compile_model(placed, options, done), placed.at);
    }
    if (options.stop.stop_requested()) return nullptr;
    add_effects(builder, scene);
    if (report) {
        report->mesh += done.mesh;
        report->rounding += done.rounding;
        for (const CoarserMesh& one : done.coarser) add_coarser(report->coarser, one);
    }
    return builder.build(options.world);
}

}  // namespace handrail::compile
