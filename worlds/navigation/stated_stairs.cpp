#include "worlds/navigation/stated_stairs.h"

#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <map>
#include <optional>
#include <vector>

#include "worlds/geometry/clip.h"
#include "worlds/scene/stated_building.h"

namespace handrail::navigation {
namespace {

constexpr double kLevel = 0.7;         // a surface is a tread if the vertical component of its normal is at least this
constexpr double kFirstTread_m = 0.6;  // greatest height of the first tread above the lower floor
// Greatest depth of the last tread below the upper floor. The last tread may also be up to a tenth of a metre above
// that floor.
constexpr double kLastTread_m = 0.6;
constexpr double kNearEnd_m = 1.5, kSameFloor_m = 0.4;
constexpr double kLeastRise_m = 0.5;

// A surface on which people tread, made of several parts of one feature.
struct Tread {
    Vec3 middle_m{0.0};
    double area_m2 = 0.0;
};
using Treads = std::map<std::uint32_t, std::vector<Tread>>;  // the treads of each feature

void add(std::vector<Tread>& treads, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    if (!(std::abs(normal.z) > kLevel * length)) return;
    treads.push_back({(a + b + c) / 3.0, 0.5 * length});
}

Treads treads_of(const Scene& scene, const StatedBuilding& stated) {
    Treads treads;
    for (const StatedPortal& portal : stated.portals)
        if (portal.kind == StatedPortalKind::Stairs && portal.feature) treads[portal.feature.value];
    if (treads.empty()) return treads;
    for (const Solid& solid : scene.solids) {
        const auto found = treads.find(solid.feature.value);
        if (found == treads.end() || solid.role != SolidRole::Solid) continue;
        for (std::size_t f = 0; f < solid.shape.faces.size(); ++f) {
            const std::vector<Vec3>& points_m = solid.shape.faces[f].points_m;
            if (solid.shape.planes[f].normal.z > kLevel)
                for (std::size_t i = 2; i < points_m.size(); ++i)
                    add(found->second, points_m[0], points_m[i - 1], points_m[i]);
        }
    }
    for (const MeshTriangle& triangle : scene.triangles)
        if (const auto found = treads.find(triangle.feature.value); found != treads.end())
            add(found->second, triangle.a_m, triangle.b_m, triangle.c_m);
    return treads;
}

// Returns the area-weighted middle of the treads between two heights; nothing if there are no treads.
std::optional<Vec3> middle_of(const std::vector<Tread>& treads, double low_m, double high_m) {
    Vec3 sum{0.0};
    double area_m2 = 0.0;
    for (const Tread& tread : treads)
        if (tread.middle_m.z >= low_m && tread.middle_m.z <= high_m) {
            sum += tread.middle_m * tread.area_m2;
            area_m2 += tread.area_m2;
        }
    if (!(area_m2 > 0.0)) return std::nullopt;
    return sum / area_m2;
}

struct Stairs {
    Vec3 foot_m{0.0}, head_m{0.0};
    Aabb around;  // box in which people walk on the stairs; empty: the file contains no shape for them
};

// Finds where a walker steps on and off the stairs. Uses the treads or, if there are none, the rooms that the stairs
// join.
std::optional<Stairs> stairs_of(const Scene& scene, const StatedBuilding& stated, const StatedPortal& portal,
                                const Treads& all) {
    const StatedRoom *low = nullptr, *high = nullptr;
    for (const std::uint32_t number : portal.rooms) {
        if (number >= stated.rooms.size()) continue;
        const StatedRoom& room = stated.rooms[number];
        if (!low || room.floor_m < low->floor_m) low = &room;
        if (!high || room.floor_m > high->floor_m) high = &room;
    }
    const bool joins = low && high->floor_m - low->floor_m > kLeastRise_m;
    const Feature* const feature = scene.find(portal.feature);
    Stairs stairs;
    if (!feature || feature->bounds_m.empty()) {
        if (!joins) return std::nullopt;
        stairs.foot_m = low->at_m;
        stairs.head_m = high->at_m;
        return stairs;
    }
    const Aabb& box = feature->bounds_m;
    const double low_m = joins ? low->floor_m : box.min_m.z, high_m = joins ? high->floor_m : box.max_m.z;
    // A part of a flight, such as a single step, is not stairs.
    if (high_m - low_m < kLeastRise_m || box.min_m.z > low_m + kFirstTread_m || box.max_m.z < high_m - kLastTread_m)
        return std::nullopt;
    const std::vector<Tread>& treads = all.at(portal.feature.value);
    stairs.foot_m = middle_of(treads, low_m - 0.1, low_m + kFirstTread_m).value_or(box.centre_m());
    stairs.head_m = middle_of(treads, high_m - kLastTread_m, high_m + 0.1).value_or(box.centre_m());
    stairs.foot_m.z = low_m;
    stairs.head_m.z = high_m;
    stairs.around = box;
    stairs.around.include(stairs.foot_m);
    stairs.around.include(stairs.head_m);
    stairs.around = grown(stairs.around, kNextToStairs_m);
    return stairs;
}

// Returns whether one span leads to the other on foot, without leaving the box.
bool leads(const WalkSpace& space, std::uint32_t from, std::uint32_t to, const Aabb& within, std::vector<bool>& seen) {
    std::vector<std::uint32_t> open{from};
    seen[from] = true;
    bool there = from == to;
    for (std::size_t i = 0; i < open.size() && !there; ++i)
        for (const std::uint32_t next : space.spans[open[i]].next) {
            if (next == kNothing || seen[next]) continue;
            const Vec3 at = space.place_m(next);
            if (glm::any(glm::lessThan(at, within.min_m)) || glm::any(glm::greaterThan(at, within.max_m))) continue;
            there = there || next == to;
            seen[next] = true;
            open.push_back(next);
        }
    for (const std::uint32_t span : open) seen[span] = false;
    return there;
}

}  // namespace

void link_stated_stairs(const Scene& scene, WalkSpace& space) {
    if (!scene.stated) return;
    const StatedBuilding& stated = *scene.stated;
    if (std::none_of(stated.portals.begin(), stated.portals.end(),
                     [](const StatedPortal& portal) { return portal.kind == StatedPortalKind::Stairs; }))
        return;
    const Treads treads = treads_of(scene, stated);
    std::vector<bool> seen(space.spans.size(), false);
    for (const StatedPortal& portal : stated.portals) {
        if (portal.kind != StatedPortalKind::Stairs) continue;
        const std::optional<Stairs> stairs = stairs_of(scene, stated, portal, treads);
        if (!stairs) continue;
        const std::uint32_t foot = space.nearest(stairs->foot_m, kNearEnd_m, kSameFloor_m, kSameFloor_m),
                            head = space.nearest(stairs->head_m, kNearEnd_m, kSameFloor_m, kSameFloor_m);
        if (foot == kNothing || head == kNothing || foot == head) continue;
        if (!stairs->around.empty() && leads(space, foot, head, stairs->around, seen)) continue;
        space.links.push_back({PassageKind::Climb, foot, head, true, portal.feature});
    }
}

}  // namespace handrail::navigation
