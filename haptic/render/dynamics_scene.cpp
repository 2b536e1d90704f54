#include "haptic/render/dynamics_scene.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/overloaded.h"
#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"

namespace handrail::render {
namespace {

// Distance up to which other parts may cover a face. A contact may be some way from its face, and
// haptic/dynamics/seams.h tests a point in front of the face; kReach_m includes both.
constexpr double kReach_m = 10e-3;

Aabb bounds_of_round(const RoundShape& round) {
    return std::visit(
        Overloaded{[](std::monostate) { return Aabb{}; }, [](const auto& shape) { return bounds_of(shape); }}, round);
}

bool flat(const DynamicsPiece& piece) noexcept { return std::holds_alternative<std::monostate>(piece.round); }

double farthest_m(const DynamicsPiece& piece) noexcept {
    if (const auto* ball = std::get_if<SphereShape>(&piece.round)) return glm::length(ball->centre_m) + ball->radius_m;
    if (flat(piece)) {
        double most2 = 0.0;
        for (const Polygon& face : piece.solid.faces)
            for (const Vec3& p : face.points_m) most2 = std::max(most2, glm::dot(p, p));
        return std::sqrt(most2);
    }
    return glm::length(glm::max(glm::abs(piece.bounds_m.min_m), glm::abs(piece.bounds_m.max_m)));
}

// Returns an upper bound for half the width of the piece in its thinnest direction.
double half_width_m(const DynamicsPiece& piece) noexcept {
    return std::visit(
        Overloaded{[&](std::monostate) {
                       double least = 1e9;
                       for (const Plane& plane : piece.solid.planes) {
                           double deepest = 0.0;
                           for (const Polygon& face : piece.solid.faces)
                               for (const Vec3& p : face.points_m)
                                   deepest = std::max(deepest, -signed_distance(plane, p));
                           least = std::min(least, 0.5 * deepest);
                       }
                       return least;
                   },
                   [](const SphereShape& s) { return s.radius_m; }, [](const CapsuleShape& s) { return s.radius_m; },
                   [](const CylinderShape& s) { return std::min(s.radius_m, 0.5 * s.height_m); },
                   [](const ConeShape& s) { return 0.5 * std::min(s.radius_m, s.height_m); }},
        piece.round);
}

// Returns true if the face, moved slightly outwards, surely has no part in the solid grown by kReach_m. It checks
// whether the whole face is in front of one of the solid's planes.
bool apart(const Polygon& face, const ConvexSolid& solid) noexcept {
    for (const Plane& plane : solid.planes)
        if (std::all_of(face.points_m.begin(), face.points_m.end(),
                        [&](const Vec3& p) { return signed_distance(plane, p) > kReach_m; }))
            return true;
    return false;
}

void find_neighbours(DynamicsScene& scene) {
    std::vector<Aabb> boxes;
    for (const DynamicsPiece& piece : scene.building)
        boxes.push_back(flat(piece) ? grown(piece.bounds_m, kReach_m) : Aabb{});
    const BoxIndex index(boxes);
    std::vector<std::uint32_t> found;
    scene.first_neighbour.push_back(0);
    for (std::uint32_t i = 0; i < scene.building.size(); ++i) {
        scene.first_face.push_back(static_cast<std::uint32_t>(scene.first_neighbour.size() - 1));
        if (!flat(scene.building[i])) continue;
        for (const Polygon& face : scene.building[i].solid.faces) {
            index.find(bounds_of(face), found);
            for (const std::uint32_t other : found)
                if (other != i && flat(scene.building[other]) && !apart(face, scene.building[other].solid))
                    scene.neighbours.push_back(other);
            scene.first_neighbour.push_back(static_cast<std::uint32_t>(scene.neighbours.size()));
        }
    }
}

bool within(double value, double least, double most) noexcept { return value >= least && value <= most; }

}  // namespace

DynamicsPiece make_piece(ConvexSolid solid, FeatureId feature, MaterialId material) {
    DynamicsPiece piece;
    piece.bounds_m = solid.bounds_m;
    piece.solid = std::move(solid);
    piece.feature = feature;
    piece.material = material;
    return piece;
}

DynamicsPiece make_piece(const RoundShape& round, FeatureId feature, MaterialId material) {
    DynamicsPiece piece;
    piece.round = round;
    piece.bounds_m = bounds_of_round(round);
    piece.feature = feature;
    piece.material = material;
    return piece;
}

DynamicsPiece make_box_piece(const Aabb& box_m, FeatureId feature, MaterialId material) {
    std::vector<Plane> planes;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            Vec3 normal(0.0);
            normal[axis] = side;
            planes.push_back({normal, side < 0.0 ? -box_m.min_m[axis] : box_m.max_m[axis]});
        }
    return make_piece(solid_from_planes(planes, box_m.centre_m(), glm::length(box_m.size_m()) + 1.0).solid, feature,
                      material);
}

DynamicsPiece placed_piece(const DynamicsPiece& piece, const Placement& at) {
    const PlacedFrame frame(at);
    DynamicsPiece out = piece;
    std::visit(Overloaded{[](std::monostate) {},
                          [&](SphereShape& s) {
                              s.centre_m = frame.to_world(s.centre_m);
                              s.radius_m *= at.scale;
                          },
                          [&](CapsuleShape& s) {
                              s.start_m = frame.to_world(s.start_m);
                              s.axis = frame.turned(s.axis);
                              s.length_m *= at.scale;
                              s.radius_m *= at.scale;
                          },
                          [&](CylinderShape& s) {
                              s.bottom_m = frame.to_world(s.bottom_m);
                              s.axis = frame.turned(s.axis);
                              s.height_m *= at.scale;
                              s.radius_m *= at.scale;
                          },
                          [&](ConeShape& s) {
                              s.base_m = frame.to_world(s.base_m);
                              s.axis = frame.turned(s.axis);
                              s.height_m *= at.scale;
                              s.radius_m *= at.scale;
                          }},
               out.round);
    out.bounds_m = bounds_of_round(out.round);
    for (Plane& plane : out.solid.planes) {
        plane.normal = frame.turned(plane.normal);
        plane.offset_m = plane.offset_m * at.scale + glm::dot(plane.normal, at.position_m);
    }
    for (Polygon& face : out.solid.faces)
        for (Vec3& p : face.points_m) out.bounds_m.include(p = frame.to_world(p));
    out.solid.bounds_m = flat(out) ? out.bounds_m : Aabb{};
    return out;
}

MassProperties mass_properties(const DynamicsPiece& piece) noexcept {
    return flat(piece) ? mass_properties(piece.solid) : mass_properties(piece.round);
}

double gap_m(const DynamicsPiece& piece, const Vec3& point_m) noexcept {
    if (const auto* ball = std::get_if<SphereShape>(&piece.round))
        return glm::length(point_m - ball->centre_m) - ball->radius_m;
    if (flat(piece)) {
        double most = -1e9;
        for (const Plane& plane : piece.solid.planes) most = std::max(most, signed_distance(plane, point_m));
        return most;
    }
    return glm::length(glm::max(glm::max(piece.bounds_m.min_m - point_m, point_m - piece.bounds_m.max_m), Vec3(0.0)));
}

Placement thing_of(const DynamicsBody& body, const Placement& middle) noexcept {
    const Rotation& in = body.middle_in_thing.rotation;
    Placement thing;
    thing.rotation = normalized(middle.rotation * Rotation{in.w, -in.x, -in.y, -in.z});
    thing.scale = body.scale;
    thing.position_m = middle.position_m -
                       PlacedFrame(Placement{Vec3(0.0), thing.rotation, 1.0}).turned(body.middle_in_thing.position_m);
    return thing;
}

Placement middle_of(const DynamicsBody& body, const Placement& thing) noexcept {
    const PlacedFrame frame(Placement{thing.position_m, thing.rotation, 1.0});
    return {frame.to_world(body.middle_in_thing.position_m), normalized(thing.rotation * body.middle_in_thing.rotation),
            1.0};
}

void DynamicsSceneBuilder::add_fixed(const DynamicsPiece& piece) {
    DynamicsPiece local = placed_piece(piece, {-scene_.origin_m, {}, 1.0});
    if (!(mass_properties(local).volume_m3 > 0.0) || !is_finite(local.bounds_m.size_m())) return;
    scene_.bounds_m.include(local.bounds_m);
    scene_.building.push_back(std::move(local));
}

void DynamicsSceneBuilder::add_sheet(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, FeatureId feature) {
    if (!is_finite(a_m) || !is_finite(b_m) || !is_finite(c_m) ||
        !(glm::length(glm::cross(b_m - a_m, c_m - a_m)) > 1e-12))
        return;
    const auto first = static_cast<std::uint32_t>(scene_.sheets.points_m.size());
    for (const Vec3& p : {a_m, b_m, c_m}) {
        scene_.sheets.points_m.push_back(p - scene_.origin_m);
        scene_.bounds_m.include(p - scene_.origin_m);
    }
    scene_.sheets.triangles.push_back({first, first + 1, first + 2});
    scene_.sheet_features.push_back(feature);
}

std::uint32_t DynamicsSceneBuilder::add_driven(std::span<const DynamicsPiece> pieces, FeatureId feature,
                                               std::uint32_t haptic, const Placement& start) {
    DrivenThing thing{feature, haptic, {start.position_m - scene_.origin_m, start.rotation, 1.0}, {}, 0.0};
    for (const DynamicsPiece& piece : pieces)
        if (mass_properties(piece).volume_m3 > 0.0)
            thing.pieces.push_back(placed_piece(piece, {Vec3(0.0), {}, start.scale}));
    if (thing.pieces.empty()) return kNoBody;
    for (const DynamicsPiece& piece : thing.pieces) {
        thing.reach_m = std::max(thing.reach_m, farthest_m(piece));
        scene_.bounds_m.include(placed_piece(piece, thing.start).bounds_m);
    }
    scene_.driven.push_back(std::move(thing));
    return static_cast<std::uint32_t>(scene_.driven.size() - 1);
}

double string_damping_ns_per_m(const BodyNature& nature) noexcept {
    constexpr double kOfCritical = 0.1;
    return nature.string ? 2.0 * kOfCritical * std::sqrt(nature.string->stiffness_n_per_m * nature.mass_kg) : 0.0;
}

std::uint32_t body_of(const DynamicsScene& scene, FeatureId feature) noexcept {
    if (feature)
        for (std::size_t i = 0; i < scene.bodies.size(); ++i)
            if (scene.bodies[i].feature == feature) return static_cast<std::uint32_t>(i);
    return kNoBody;
}

BodyFault DynamicsSceneBuilder::add_body(std::span<const DynamicsPiece> pieces, FeatureId feature, std::uint32_t haptic,
                                         const Placement& start, const BodyNature& nature) {
    if (scene_.bodies.size() >= DynamicsScene::kMostBodies) return BodyFault::TooMany;
    if (!within(nature.mass_kg, 0.01, 10'000.0)) return BodyFault::BadMass;
    if (!within(nature.friction, 0.0, 10.0) || !within(nature.friction_static, nature.friction, 10.0) ||
        !within(nature.elasticity, 0.0, 0.95) || !within(nature.rolling, 0.0, 1.0))
        return BodyFault::BadNature;
    if (nature.string && (!is_finite(nature.string->at_m) || !within(nature.string->stiffness_n_per_m, 0.0, 10'000.0)))
        return BodyFault::BadNature;
    if (!is_finite(start.position_m) || !within(start.scale, 1e-6, 1e6)) return BodyFault::BadPlace;
    MassProperties whole;
    std::vector<const DynamicsPiece*> parts;
    for (const DynamicsPiece& piece : pieces) {
        const MassProperties own = mass_properties(piece);
        if (!(own.volume_m3 > 0.0)) continue;
        parts.push_back(&piece);
        whole = parts.size() == 1 ? own : together(whole, own);
    }
    if (parts.empty() || !is_finite(whole.middle_m)) return BodyFault::NoVolume;

    DynamicsBody body;
    body.feature = feature;
    body.haptic = haptic;
    body.scale = start.scale;
    body.nature = nature;
    body.ball = parts.size() == 1 && std::holds_alternative<SphereShape>(parts[0]->round);
    const PrincipalAxes axes = principal_axes(whole.spread_m5);
    body.middle_in_thing = {whole.middle_m * start.scale, axes.rotation, 1.0};
    body.inertia_kg_m2 = axes.inertia_m5 * (nature.mass_kg / whole.volume_m3 * start.scale * start.scale);
    // Scales the pieces, then converts them to the frame of the centre of mass.
    const Rotation& r = axes.rotation;
    const Rotation back{r.w, -r.x, -r.y, -r.z};
    const Vec3 shift = PlacedFrame(Placement{Vec3(0.0), back, 1.0}).turned(-body.middle_in_thing.position_m);
    body.half_width_m = 1e9;
    for (const DynamicsPiece* part : parts) {
        body.pieces.push_back(placed_piece(*part, {shift, back, start.scale}));
        body.reach_m = std::max(body.reach_m, farthest_m(body.pieces.back()));
        body.half_width_m = std::min(body.half_width_m, half_width_m(body.pieces.back()));
    }
    body.start = middle_of(body, {start.position_m - scene_.origin_m, start.rotation, 1.0});
    scene_.bounds_m.include(grown({body.start.position_m, body.start.position_m}, body.reach_m));
    scene_.bodies.push_back(std::move(body));
    return BodyFault::None;
}

std::shared_ptr<const DynamicsScene> DynamicsSceneBuilder::build() {
    for (DynamicsBody& body : scene_.bodies)
        if (body.nature.string) body.nature.string->at_m -= scene_.origin_m;
    find_neighbours(scene_);
    auto out = std::make_shared<const DynamicsScene>(std::move(scene_));
    scene_ = {};
    return out;
}

}  // namespace handrail::render
