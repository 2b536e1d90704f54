#include "worlds/scene/stair_rule.h"

#include "worlds/scene/stated_building.h"

namespace handrail {
namespace {

constexpr double kBeside_m = 0.3;    // a part that is nearer to the stairs, seen from above, is above them
constexpr double kOverFoot_m = 1.0;  // what begins lower is a wall
constexpr double kOverHead_m = 0.3;  // what ends higher is a wall or a roof

// Up to the highest room that they join: railings go on above that.
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
        stairs_.push_back(feature->bounds_m);
        stairs_.back().max_m.z = head_m(*scene.stated, portal, feature->bounds_m);
    }
}

bool StairRule::narrow(FeatureId feature, const Aabb& box) const {
    if (is_stairs(feature)) return true;
    return std::any_of(stairs_.begin(), stairs_.end(), [&](const Aabb& stairs) {
        return box.min_m.z > stairs.min_m.z + kOverFoot_m && box.max_m.z < stairs.max_m.z + kOverHead_m &&
               box.min_m.x < stairs.max_m.x + kBeside_m && box.max_m.x > stairs.min_m.x - kBeside_m &&
               box.min_m.y < stairs.max_m.y + kBeside_m && box.max_m.y > stairs.min_m.y - kBeside_m;
    });
}

}  // namespace handrail
