// Builds the scene that a plan of simplify_scene.h describes.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "haptic/compile/simplify_scene.h"
#include "haptic/compile/simplify_shapes.h"
#include "worlds/base/contract.h"
#include "worlds/geometry/box_index.h"

namespace handrail::compile {
namespace {

using namespace doorway;

// Returns the index of the solid's face whose normal is closest to `way`. Where a solid is cut, the new face gets the
// name and material of that face.
std::size_t face_towards(const ConvexSolid& solid, const Vec3& way) {
    std::size_t best = 0;
    for (std::size_t f = 1; f < solid.planes.size(); ++f)
        if (glm::dot(solid.planes[f].normal, way) > glm::dot(solid.planes[best].normal, way) + 1e-12) best = f;
    return best;
}

struct PlaneFrom {
    Plane plane;
    int face = -1;  // index of the solid's face; -1: the plane comes from a cut
    bool covered = false;
};

// Returns the part of `solid` behind the planes, or nothing if that part is empty.
std::optional<Solid> piece_of(const Solid& solid, const std::vector<PlaneFrom>& from) {
    std::vector<Plane> planes;
    for (const PlaneFrom& one : from) planes.push_back(one.plane);
    BuiltSolid made = built(planes, solid.shape.bounds_m);
    if (made.fault != SolidFault::None) return std::nullopt;
    Solid piece;
    piece.role = solid.role;
    piece.feature = solid.feature;
    piece.source = solid.source;
    piece.shape = std::move(made.solid);
    for (const std::uint32_t i : made.plane_index) {
        const std::size_t label = from[i].face >= 0 ? static_cast<std::size_t>(from[i].face)
                                                    : face_towards(solid.shape, from[i].plane.normal);
        piece.face_features.push_back(solid.face_features[label]);
        piece.face_materials.push_back(solid.face_materials[label]);
        piece.face_hidden.push_back(from[i].face >= 0 ? solid.face_hidden[label] : from[i].covered);
    }
    return piece;
}

// Returns the pieces of `solid` that remain after a box is removed. `box` contains the planes of the box. If the box
// misses the solid, the result contains the whole solid.
std::vector<Solid> without(const Solid& solid, const std::vector<Plane>& box) {
    std::vector<PlaneFrom> rest;
    for (std::size_t f = 0; f < solid.shape.planes.size(); ++f)
        rest.push_back({solid.shape.planes[f], static_cast<int>(f), false});
    std::vector<Solid> pieces;
    for (const Plane& plane : box) {
        std::vector<PlaneFrom> outside = rest;
        outside.push_back({{-plane.normal, -plane.offset_m}, -1, false});
        if (std::optional<Solid> piece = piece_of(solid, outside)) {
            pieces.push_back(std::move(*piece));
            // The next piece touches this piece at this plane, so the plane is covered there.
            rest.push_back({plane, -1, true});
        }
        if (!piece_of(solid, rest)) return pieces;
    }
    return pieces;
}

template <class Shape>
Vec3* centre_of_round(Shape& shape) {
    if constexpr (std::is_same_v<Shape, SphereShape>) return &shape.centre_m;
    else if constexpr (std::is_same_v<Shape, CapsuleShape>) return &shape.start_m;
    else if constexpr (std::is_same_v<Shape, CylinderShape>) return &shape.bottom_m;
    else if constexpr (std::is_same_v<Shape, ConeShape>) return &shape.base_m;
    else return nullptr;
}

// Stretches the solid by the factor `times` along `way`, then shifts it by `plus_m`. Round parts are moved and keep
// their shape.
void draw_out(Solid& solid, const Vec3& way, double times, double plus_m) {
    const auto moved = [&](const Vec3& p) { return p + way * ((times - 1.0) * glm::dot(way, p) + plus_m); };
    if (!std::holds_alternative<std::monostate>(solid.round)) {
        const Vec3 by = moved(solid.shape.bounds_m.centre_m()) - solid.shape.bounds_m.centre_m();
        for (Plane& plane : solid.shape.planes) plane.offset_m += glm::dot(plane.normal, by);
        for (Polygon& face : solid.shape.faces)
            for (Vec3& p : face.points_m) p += by;
        std::visit(
            [&](auto& round) {
                if (Vec3* centre = centre_of_round(round)) *centre += by;
            },
            solid.round);
        solid.shape.bounds_m = {solid.shape.bounds_m.min_m + by, solid.shape.bounds_m.max_m + by};
        return;
    }
    solid.shape.bounds_m = {};
    for (std::size_t f = 0; f < solid.shape.planes.size(); ++f) {
        for (Vec3& p : solid.shape.faces[f].points_m) {
            p = moved(p);
            solid.shape.bounds_m.include(p);
        }
        Plane& plane = solid.shape.planes[f];
        const double lean = glm::dot(plane.normal, way);
        if (std::abs(lean) > 1e-12 && std::abs(lean) < 1.0 - 1e-12)
            plane.normal = glm::normalize(plane.normal + way * ((1.0 / times - 1.0) * lean));
        plane.offset_m = glm::dot(plane.normal, solid.shape.faces[f].points_m.front());
    }
}

void draw_out(MeshTriangle& t, const Vec3& way, double times, double plus_m) {
    for (Vec3* p : {&t.a_m, &t.b_m, &t.c_m}) *p += way * ((times - 1.0) * glm::dot(way, *p) + plus_m);
}

// Marks a solid's faces as touchable again if they were covered only by parts that were removed.
void uncover(Solid& solid, const std::vector<Plane>& gone) {
    std::vector<Vec3> rest, scratch;
    for (std::size_t f = 0; f < solid.face_hidden.size(); ++f) {
        if (!solid.face_hidden[f]) continue;
        rest = solid.shape.faces[f].points_m;
        for (const Plane& plane : gone) {
            if (rest.size() < 3) break;
            keep_back(rest, {plane.normal, plane.offset_m + 1e-5}, kTolerance.cut_m, scratch);
        }
        tidy(rest, 1e-3);
        if (rest.size() >= 3) solid.face_hidden[f] = false;
    }
}

}  // namespace

std::vector<Plane> NarrowOpening::cut() const {
    return box_planes(along, {felt_low_m, felt_high_m}, {front_m, back_m}, {floor_m, top_m});
}

Vec3 NarrowOpening::drawn_apart(const Vec3& p) const {
    const double s = glm::dot(along, p);
    return p + along * (felt_low_m + (s - low_m) * times() - s);
}

bool Simplification::changes_nothing() const { return left_out.empty() && widened() == 0; }

std::size_t Simplification::widened() const {
    return static_cast<std::size_t>(
        std::count_if(openings.begin(), openings.end(), [](const NarrowOpening& o) { return o.widened(); }));
}

std::size_t Simplification::staying_narrow() const {
    return static_cast<std::size_t>(
        std::count_if(openings.begin(), openings.end(), [](const NarrowOpening& o) { return o.stays_narrow(); }));
}

const NarrowOpening* Simplification::of_door(FeatureId door) const {
    for (const NarrowOpening& opening : openings)
        if (opening.widened() && std::find(opening.doors.begin(), opening.doors.end(), door) != opening.doors.end())
            return &opening;
    return nullptr;
}

Placement felt_placement(const Simplification& plan, FeatureId thing, const Placement& at) {
    contract_pre(is_finite(at.position_m) && at.scale > 0.0);
    Placement felt = at;
    if (const NarrowOpening* opening = plan.of_door(thing)) felt.position_m = opening->drawn_apart(at.position_m);
    return felt;
}

Scene simplified(const Scene& scene, const Simplification& plan) {
    contract_pre(!plan.changes_nothing());
    Scene felt;
    felt.name = scene.name;
    felt.metres_per_unit = scene.metres_per_unit;
    felt.bounds_m = scene.bounds_m;
    felt.materials = scene.materials;
    felt.features = scene.features;
    felt.effects = scene.effects;
    felt.movers = scene.movers;
    const auto is_out = [&](FeatureId id) {
        return std::binary_search(plan.left_out.begin(), plan.left_out.end(), id,
                                  [](FeatureId a, FeatureId b) { return a.value < b.value; });
    };

    struct Removal {
        std::vector<Plane> planes;
        Aabb box;
    };
    std::vector<Removal> gone;
    std::vector<std::pair<std::vector<Plane>, Aabb>> cuts;
    for (const NarrowOpening& opening : plan.openings)
        if (opening.widened()) {
            cuts.emplace_back(opening.cut(),
                              box_around(opening.along, {opening.felt_low_m, opening.felt_high_m},
                                         {opening.front_m, opening.back_m}, {opening.floor_m, opening.top_m}));
            gone.push_back({cuts.back().first, cuts.back().second});
        }

    std::vector<Aabb> cut_boxes;
    for (const auto& [planes, box] : cuts) cut_boxes.push_back(box);
    const BoxIndex cut_index(cut_boxes);
    std::vector<std::uint32_t> near;
    std::map<std::uint32_t, const NarrowOpening*> opening_of;  // for each widened door's feature number, its opening
    for (const NarrowOpening& opening : plan.openings)
        for (const FeatureId door : opening.doors)
            if (opening.widened()) opening_of.try_emplace(door.value, &opening);
    const auto of_door = [&](FeatureId door) {
        const auto found = opening_of.find(door.value);
        return found == opening_of.end() ? nullptr : found->second;
    };
    for (const Solid& solid : scene.solids) {
        if (is_out(solid.feature)) {
            gone.push_back({solid.shape.planes, solid.shape.bounds_m});
            continue;
        }
        if (const NarrowOpening* opening = of_door(solid.feature)) {
            felt.solids.push_back(solid);
            draw_out(felt.solids.back(), opening->along, opening->times(),
                     opening->felt_low_m - opening->low_m * opening->times());
            continue;
        }
        std::vector<Solid> pieces{solid};
        if (is_wall(scene, solid)) {
            cut_index.find(solid.shape.bounds_m, near);
            for (const std::uint32_t c : near) {
                const double floor_m = -cuts[c].first[3].offset_m;
                if (solid.shape.bounds_m.max_m.z < floor_m + kStep_m) continue;
                std::vector<Solid> next;
                for (const Solid& piece : pieces) {
                    if (common(piece.shape, cuts[c].first).faces.empty()) next.push_back(piece);
                    else
                        for (Solid& part : without(piece, cuts[c].first)) next.push_back(std::move(part));
                }
                pieces = std::move(next);
            }
        }
        for (Solid& piece : pieces) felt.solids.push_back(std::move(piece));
    }
    std::vector<Aabb> gone_boxes;
    for (const Removal& one : gone) gone_boxes.push_back(grown(one.box, 1e-4));
    const BoxIndex gone_index(gone_boxes);
    for (Solid& solid : felt.solids) {
        gone_index.find(solid.shape.bounds_m, near);
        for (const std::uint32_t g : near) uncover(solid, gone[g].planes);
    }

    felt.triangles = scene.triangles;
    for (MeshTriangle& t : felt.triangles)
        if (const NarrowOpening* opening = of_door(t.feature))
            draw_out(t, opening->along, opening->times(), opening->felt_low_m - opening->low_m * opening->times());

    felt.placed = scene.placed;
    for (PlacedModel& placed : felt.placed) {
        const NarrowOpening* opening = of_door(placed.feature);
        if (is_out(placed.feature)) {
            // An omitted model is replaced by an empty one, because the app addresses placed models by their index.
            auto nothing = std::make_shared<Scene>();
            nothing->materials = placed.model->materials;
            placed.model = std::move(nothing);
        } else if (opening) {
            auto model = std::make_shared<Scene>(*placed.model);
            for (Solid& solid : model->solids) draw_out(solid, opening->along, opening->times(), 0.0);
            for (MeshTriangle& t : model->triangles) draw_out(t, opening->along, opening->times(), 0.0);
            placed.model = std::move(model);
            placed.at = felt_placement(plan, placed.feature, placed.at);
        }
    }
    return felt;
}

}  // namespace handrail::compile
