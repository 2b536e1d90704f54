#include "worlds/scene/made_door.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <variant>

#include "worlds/base/contract.h"
#include "worlds/geometry/clip.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace {

constexpr double kBeyondWall_m = 0.02;  // distance by which the cut extends beyond both sides of the wall
constexpr double kTouches_m = 1e-4;     // a part that extends less than this into the doorway is not cut
constexpr double kThreshold_m = 0.1;

struct Doorway {
    // Middle of the doorway on the floor; direction through the wall; direction along the wall to the right.
    Vec3 middle_m{0.0}, along{0.0}, across{0.0};
    double half_m = 0.0, deep_m = 0.0;
    std::array<Plane, 6> planes;  // right, left, ahead, behind, above, below
};

Doorway doorway_of(const MadeDoor& door) {
    Doorway box;
    box.middle_m = door.place_m;
    box.along = {std::sin(door.heading_rad), std::cos(door.heading_rad), 0.0};
    box.across = {box.along.y, -box.along.x, 0.0};
    box.half_m = 0.5 * door.width_m;
    box.deep_m = 0.5 * door.through_m + kBeyondWall_m;
    const auto plane = [&](const Vec3& normal, double out_m) {
        return Plane{normal, glm::dot(normal, box.middle_m) + out_m};
    };
    const Vec3 up(0.0, 0.0, 1.0);
    box.planes = {plane(box.across, box.half_m), plane(-box.across, box.half_m), plane(box.along, box.deep_m),
                  plane(-box.along, box.deep_m), plane(up, kMadeDoorHigh_m),     plane(-up, 0.0)};
    return box;
}

Plane other_side(const Plane& plane) { return {-plane.normal, -plane.offset_m}; }

double far_along(const ConvexSolid& solid, const Vec3& direction) {
    double most = -1e300;
    for (const Polygon& face : solid.faces)
        for (const Vec3& p : face.points_m) most = std::max(most, glm::dot(direction, p));
    return most;
}

// Returns the part of a solid behind a plane. Each face keeps its feature and material. The new face gets those of the
// face with index `made`.
std::optional<Solid> part_behind(const Solid& solid, const Plane& plane, std::size_t made) {
    if (-far_along(solid.shape, -plane.normal) >= plane.offset_m - kTouches_m) return std::nullopt;
    if (far_along(solid.shape, plane.normal) <= plane.offset_m + kTouches_m) return solid;
    std::vector<Plane> planes = solid.shape.planes;
    planes.push_back(plane);
    const BuiltSolid built = solid_from_planes(planes, solid.shape.bounds_m.centre_m(),
                                               2.0 * glm::length(solid.shape.bounds_m.size_m()) + 1.0);
    if (built.fault != SolidFault::None || built.plane_index.size() != built.solid.planes.size()) return std::nullopt;
    Solid part = solid;
    part.shape = built.solid;
    part.face_features.clear(), part.face_materials.clear(), part.face_hidden.clear();
    for (const std::uint32_t from : built.plane_index) {
        const bool old = from < solid.shape.planes.size();
        const std::size_t face = old ? from : made;
        part.face_features.push_back(solid.face_features[face]);
        part.face_materials.push_back(solid.face_materials[face]);
        part.face_hidden.push_back(old && solid.face_hidden[face]);
    }
    return part;
}

bool is_cut(const Scene& scene, const Solid& solid) {
    const Feature* feature = scene.find(solid.feature);
    return solid.role == SolidRole::Solid && std::holds_alternative<std::monostate>(solid.round) &&
           (!feature || feature->made_name);
}

std::size_t largest_face(const ConvexSolid& shape) {
    std::size_t best = 0;
    for (std::size_t f = 1; f < shape.faces.size(); ++f)
        if (area_m2(shape.faces[f]) > area_m2(shape.faces[best])) best = f;
    return best;
}

// Adds the surface where the wall borders one side of the doorway, as seen from within the doorway.
void add_jamb(Scene& scene, const Solid& solid, const Doorway& box, std::size_t side, std::size_t face) {
    const Vec3 up(0.0, 0.0, kMadeDoorHigh_m), right = box.across * box.half_m, ahead = box.along * box.deep_m;
    std::vector<Vec3> corners;
    if (side == 0) corners = {right - ahead, right + ahead, right + ahead + up, right - ahead + up};
    else if (side == 1) corners = {-right + ahead, -right - ahead, -right - ahead + up, -right + ahead + up};
    else corners = {right + ahead + up, right - ahead + up, -right - ahead + up, -right + ahead + up};
    for (Vec3& corner : corners) corner += box.middle_m;
    const Vec3 normal = -box.planes[side].normal;
    if (glm::dot(area_vector_m2(corners), normal) < 0.0) std::reverse(corners.begin(), corners.end());
    std::vector<Vec3> scratch;
    for (const Plane& plane : solid.shape.planes)
        if (corners.size() >= 3) keep_back(corners, plane, 1e-7, scratch);
    if (corners.size() < 3 || area_m2(std::span<const Vec3>(corners)) < 1e-6) return;
    scene.surfaces.push_back(
        {{std::move(corners)}, normal, solid.face_features[face], solid.face_materials[face], SolidRole::Solid});
}

void cut_solids(Scene& scene, const Doorway& box) {
    std::vector<Solid> kept;
    kept.reserve(scene.solids.size() + 8);
    for (const Solid& solid : scene.solids) {
        const std::size_t made = solid.shape.faces.empty() ? 0 : largest_face(solid.shape);
        std::optional<Solid> inner;
        if (is_cut(scene, solid)) inner = solid;
        for (const Plane& plane : box.planes)
            if (inner) inner = part_behind(*inner, plane, made);
        if (!inner) {
            kept.push_back(solid);
            continue;
        }
        for (std::size_t side : {std::size_t{0}, std::size_t{1}, std::size_t{4}})
            add_jamb(scene, solid, box, side, made);
        Solid rest = solid;
        for (const Plane& plane : box.planes) {
            const std::size_t face = largest_face(rest.shape);
            if (std::optional<Solid> outside = part_behind(rest, other_side(plane), face))
                kept.push_back(std::move(*outside));
            std::optional<Solid> within = part_behind(rest, plane, face);
            if (!within) break;
            rest = std::move(*within);
        }
    }
    scene.solids = std::move(kept);
}

void cut_surfaces(Scene& scene, const Doorway& box) {
    std::vector<SurfacePolygon> kept;
    kept.reserve(scene.surfaces.size() + 8);
    for (SurfacePolygon& surface : scene.surfaces) {
        const Feature* feature = scene.find(surface.feature);
        std::vector<Vec3> inner = surface.polygon.points_m, back, front;
        std::vector<std::vector<Vec3>> outside;
        bool within = surface.role == SolidRole::Solid && (!feature || feature->made_name);
        for (const Plane& plane : box.planes) {
            if (!within) break;
            // Moves the plane slightly inwards, so that parts that only touch a side of the doorway are outside it.
            const Plane in{plane.normal, plane.offset_m - kTouches_m};
            split(inner, in, 1e-7, back, front);
            if (front.size() >= 3) outside.push_back(front);
            inner = back;
            within = inner.size() >= 3;
        }
        if (!within) {
            kept.push_back(std::move(surface));
            continue;
        }
        for (std::vector<Vec3>& part : outside)
            if (area_m2(std::span<const Vec3>(part)) > 1e-6)
                kept.push_back({{std::move(part)}, surface.normal, surface.feature, surface.material, surface.role});
    }
    scene.surfaces = std::move(kept);
}

bool anything_at(const Scene& scene, const Vec3& at_m) {
    return std::any_of(scene.solids.begin(), scene.solids.end(), [&](const Solid& solid) {
        return solid.role == SolidRole::Solid && contains(solid.shape, at_m);
    });
}

// Adds a threshold if there is no floor below the wall.
void add_threshold(Scene& scene, const Doorway& box) {
    bool floor = true;
    for (const double along : {-0.9, -0.45, 0.0, 0.45, 0.9})
        for (const double across : {-0.9, 0.0, 0.9})
            floor = floor && anything_at(scene, box.middle_m + box.along * (along * (box.deep_m - kBeyondWall_m)) +
                                                    box.across * (across * box.half_m) - Vec3(0.0, 0.0, 0.01));
    if (floor) return;
    // The threshold gets the feature and material of the nearest floor.
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    double nearest_m = 1e300;
    for (const SurfacePolygon& surface : scene.surfaces) {
        if (surface.normal.z < 0.9 || surface.role != SolidRole::Solid) continue;
        const double off_m = glm::length(centre_of(surface.polygon) - box.middle_m);
        if (off_m >= nearest_m) continue;
        nearest_m = off_m;
        feature = surface.feature;
        material = surface.material;
    }
    std::vector<Plane> planes(box.planes.begin(), box.planes.begin() + 4);
    const double top_m = box.middle_m.z;
    planes.push_back({{0.0, 0.0, 1.0}, top_m});
    planes.push_back({{0.0, 0.0, -1.0}, kThreshold_m - top_m});
    const BuiltSolid built = solid_from_planes(planes, box.middle_m - Vec3(0.0, 0.0, 0.5 * kThreshold_m), 10.0);
    if (built.fault != SolidFault::None) return;
    Solid solid;
    solid.shape = built.solid;
    solid.face_features.assign(solid.shape.planes.size(), feature);
    solid.face_materials.assign(solid.shape.planes.size(), material);
    solid.face_hidden.assign(solid.shape.planes.size(), false);
    for (std::size_t f = 0; f < solid.shape.planes.size(); ++f)
        if (solid.shape.planes[f].normal.z > 0.9)
            scene.surfaces.push_back(
                {solid.shape.faces[f], solid.shape.planes[f].normal, feature, material, SolidRole::Solid});
    scene.solids.push_back(std::move(solid));
}

// True if nothing is left in the doorway that blocks a walker.
bool is_free(const Scene& scene, const Doorway& box) {
    for (double along = -1.0; along <= 1.0; along += 0.1)
        for (const double across : {-0.8, 0.0, 0.8})
            for (const double up : {0.3, 1.0, 1.8})
                if (anything_at(scene, box.middle_m + box.along * (along * box.deep_m) +
                                           box.across * (across * box.half_m) + Vec3(0.0, 0.0, up)))
                    return false;
    return true;
}

// Returns the doors of the file that are inside the doorway.
std::vector<StatedPortal*> stated_in(StatedBuilding& stated, const Doorway& box) {
    std::vector<StatedPortal*> in;
    for (StatedPortal& portal : stated.portals) {
        const Vec3 off = portal.place_m - box.middle_m;
        if (std::abs(glm::dot(off, box.along)) <= box.deep_m && std::abs(glm::dot(off, box.across)) <= box.half_m &&
            std::abs(off.z) < 0.5 * kMadeDoorHigh_m)
            in.push_back(&portal);
    }
    return in;
}

void state_opening(const Scene& scene, StatedBuilding& stated, const MadeDoor& door, const Doorway& box) {
    if (const std::vector<StatedPortal*> there = stated_in(stated, box); !there.empty()) {
        for (StatedPortal* portal : there) portal->passable = portal->passable || is_free(scene, box);
        return;
    }
    StatedPortal portal;
    portal.kind = StatedPortalKind::Opening;
    portal.name = door.name;
    portal.place_m = door.place_m;
    portal.width_m = door.width_m;
    portal.height_m = kMadeDoorHigh_m;
    for (const double side : {-1.0, 1.0})
        for (std::uint32_t r = 0; r < stated.rooms.size(); ++r)
            if (holds(stated.rooms[r], door.place_m + box.along * (side * (box.deep_m + 0.3)) + Vec3(0.0, 0.0, 0.1)) &&
                std::find(portal.rooms.begin(), portal.rooms.end(), r) == portal.rooms.end()) {
                portal.rooms.push_back(r);
                break;
            }
    std::sort(portal.rooms.begin(), portal.rooms.end());
    stated.portals.push_back(std::move(portal));
}

}  // namespace

Scene with_made_doors(Scene scene, std::span<const MadeDoor> doors) {
    std::shared_ptr<StatedBuilding> stated;
    for (const MadeDoor& door : doors) {
        contract_pre(is_finite(door.place_m) && std::isfinite(door.heading_rad) && door.width_m > 0.0 &&
                     door.through_m >= 0.0);
        const Doorway box = doorway_of(door);
        cut_surfaces(scene, box);
        cut_solids(scene, box);
        add_threshold(scene, box);
        if (!scene.stated) continue;
        if (!stated) stated = std::make_shared<StatedBuilding>(*scene.stated);
        state_opening(scene, *stated, door, box);
    }
    if (stated) scene.stated = std::move(stated);
    return scene;
}

}  // namespace handrail
