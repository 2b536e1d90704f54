#include "worlds/scene/stair_rule.h"

#include <cmath>

#include "worlds/scene/stated_building.h"

namespace handrail {
namespace {

constexpr double kNextTo_m = 0.3;    // a part within this distance of the stairs in plan may be treated as above them
constexpr double kOverFoot_m = 1.0;  // a part whose underside is less than this above the foot of the stairs is a wall
// A part whose top is more than this above the head of the stairs is a wall or a roof.
constexpr double kOverHead_m = 0.3;
constexpr double kSeam_m = 0.01;  // greatest gap between two pieces of one wall

// Returns the box of the flight, widened in plan by kNextTo_m.
Aabb beside(Aabb stairs) {
    stairs.min_m -= Vec3(kNextTo_m, kNextTo_m, 0.0);
    stairs.max_m += Vec3(kNextTo_m, kNextTo_m, 0.0);
    return stairs;
}

bool meets_level(const Aabb& a, const Aabb& b) {
    return a.min_m.x < b.max_m.x && a.max_m.x > b.min_m.x && a.min_m.y < b.max_m.y && a.max_m.y > b.min_m.y;
}

// Returns the height of the flight's head. It is the floor of the highest room to which the stairs lead, not the top of
// the flight, because the flight's railings continue above that floor. If there is no such floor, returns the top of
// the flight.
double head_m(const StatedBuilding& stated, const StatedPortal& portal, const Aabb& box) {
    double highest_m = box.min_m.z;
    for (const std::uint32_t room : portal.rooms)
        if (room < stated.rooms.size()) highest_m = std::max(highest_m, stated.rooms[room].floor_m);
    return highest_m > box.min_m.z + kOverFoot_m ? std::min(highest_m, box.max_m.z) : box.max_m.z;
}

}  // namespace

StairRule::StairRule(const Scene& scene) {
    if (!scene.stated) return;
    for (const StatedPortal& portal : scene.stated->portals) {
        const Feature* const feature = portal.kind == StatedPortalKind::Stairs ? scene.find(portal.feature) : nullptr;
        if (!feature || feature->bounds_m.empty()) continue;
        is_stairs_.resize(scene.features.size(), false);
        is_stairs_[portal.feature.value] = true;
        Flight& flight = flights_.emplace_back();
        flight.box_m = feature->bounds_m;
        flight.box_m.max_m.z = head_m(*scene.stated, portal, feature->bounds_m);
    }
    find_walls(scene);
}

// Examines the pieces from the lowest up, so that each piece of a wall is known before the pieces on top of it are
// examined.
void StairRule::find_walls(const Scene& scene) {
    for (Flight& flight : flights_) {
        const Aabb around = beside(flight.box_m);
        std::vector<Aabb> near;
        for (const Solid& solid : scene.solids)
            if (solid.role == SolidRole::Solid && !is_stairs(solid.feature) &&
                meets_level(solid.shape.bounds_m, around))
                near.push_back(solid.shape.bounds_m);
        std::sort(near.begin(), near.end(), [](const Aabb& a, const Aabb& b) { return a.min_m.z < b.min_m.z; });
        for (const Aabb& box : near)
            if (!above(flight, box) || on_wall(flight, box)) flight.wide_m.push_back(box);
    }
}

bool StairRule::above(const Flight& flight, const Aabb& box) const {
    const Aabb& stairs = flight.box_m;
    return box.min_m.z > stairs.min_m.z + kOverFoot_m && box.max_m.z < stairs.max_m.z + kOverHead_m &&
           meets_level(box, beside(stairs));
}

// True if the piece stands on a piece of a wall: in plan, its part near the flight is within the wall piece directly
// below it.
bool StairRule::on_wall(const Flight& flight, const Aabb& box) const {
    const Aabb around = beside(flight.box_m);
    return std::any_of(flight.wide_m.begin(), flight.wide_m.end(), [&](const Aabb& wall) {
        if (std::abs(wall.max_m.z - box.min_m.z) > kSeam_m) return false;
        for (int axis = 0; axis < 2; ++axis)
            if (std::max(box.min_m[axis], around.min_m[axis]) < wall.min_m[axis] - kSeam_m ||
                std::min(box.max_m[axis], around.max_m[axis]) > wall.max_m[axis] + kSeam_m)
                return false;
        return true;
    });
}

bool StairRule::narrow(FeatureId feature, const Aabb& box) const {
    if (is_stairs(feature)) return true;
    return std::any_of(flights_.begin(), flights_.end(),
                       [&](const Flight& flight) { return above(flight, box) && !on_wall(flight, box); });
}

}  // namespace handrail
