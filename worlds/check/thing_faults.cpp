#include <algorithm>
#include <cmath>

#include "worlds/check/examined.h"
#include "worlds/geometry/clip.h"
#include "worlds/scene/lint.h"
#include "worlds/scene/stated_building.h"

namespace handrail::check {
namespace {

constexpr double kSame_m = 0.005;   // two boxes are equal if their corners are within this distance
constexpr double kFar_m = 3.0;      // a thing farther than this from every standing place is out of reach
constexpr double kHighest_m = 4.0;  // greatest height above a floor of a thing that hangs on a wall
constexpr double kTouching_m = 0.1;

WorldFault fault_of(const Examined& world, FeatureId id, FaultKind kind) {
    const Feature& feature = world.scene.features[id.value];
    const Vec3 middle = feature.bounds_m.centre_m();
    WorldFault fault{kind, {middle.x, middle.y, feature.bounds_m.min_m.z}, feature.source};
    fault.feature = id;
    fault.name = spoken_name(feature);
    fault.room = world.room_of(feature);
    return fault;
}

void twice(const Examined& world, const std::vector<FeatureId>& things, std::vector<WorldFault>& faults) {
    std::vector<Aabb> boxes;
    for (const FeatureId id : things) boxes.push_back(world.scene.features[id.value].bounds_m);
    const BoxIndex index(boxes);
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        index.find(boxes[i], near);
        for (const std::uint32_t k : near) {
            const Vec3 low = glm::abs(boxes[i].min_m - boxes[k].min_m),
                       high = glm::abs(boxes[i].max_m - boxes[k].max_m);
            if (k >= i || std::max({low.x, low.y, low.z, high.x, high.y, high.z}) > kSame_m) continue;
            faults.push_back(fault_of(world, things[i], FaultKind::ThingTwice));
            faults.back().other = spoken_name(world.scene.features[things[k].value]);
            break;
        }
    }
}

// True if the whole thing is inside parts of the building and none of its surface is visible. The surface of a gate
// that is flush with its wall is visible.
bool is_within_walls(const Examined& world, FeatureId id) {
    constexpr double kLooksOut_m2 = 1e-3;
    if (world.scene.features[id.value].area_m2 > kLooksOut_m2) return false;
    const Aabb& box = world.scene.features[id.value].bounds_m;
    const Vec3 middle = box.centre_m(), half = 0.5 * box.size_m() - Vec3(1e-3);
    for (int place = 0; place < 27; ++place) {
        const Vec3 way(place % 3 - 1, place / 3 % 3 - 1, place / 9 - 1);
        const Solid* solid = world.solid_at(middle + way * half, 1e-4, {id});
        if (!solid || solid->feature != kNoFeature) return false;
    }
    return true;
}

// True if the thing is below all floors nearby.
bool is_under_floors(const Examined& world, FeatureId id) {
    const Aabb& box = world.scene.features[id.value].bounds_m;
    const double around = 0.5 + 0.5 * std::max(box.size_m().x, box.size_m().y);
    const Vec3 top(box.centre_m().x, box.centre_m().y, box.max_m.z);
    return world.space->nearest(top, around, kHighest_m, 0.0) != navigation::kNothing &&
           world.space->nearest(top, around, 0.01, 1e4) == navigation::kNothing;
}

bool is_far_from_floors(const Examined& world, FeatureId id) {
    const Aabb& box = world.scene.features[id.value].bounds_m;
    const double around = kFar_m + 0.5 * std::max(box.size_m().x, box.size_m().y);
    const Vec3 foot(box.centre_m().x, box.centre_m().y, box.min_m.z);
    return world.space->nearest(foot, around, box.size_m().z + 1.0, kHighest_m) == navigation::kNothing;
}

bool touches_nothing(const Examined& world, FeatureId id) {
    const Aabb around = grown(world.scene.features[id.value].bounds_m, kTouching_m);
    if (world.sheet_near(around)) return false;
    const std::vector<std::uint32_t>& near = world.solids_near(around);
    return std::none_of(near.begin(), near.end(), [&](std::uint32_t i) { return world.scene.solids[i].feature != id; });
}

// True for a start that needs no check. The reader puts a start in front of each outside door. On an upper storey such
// a door leads to a balcony or to nothing, and no walk starts there.
bool before_upper_door(const Scene& scene, const Start& start) {
    if (!scene.stated || start.feet_m.z < scene.starts.front().feet_m.z + kUpperDoor_m) return false;
    const std::vector<StatedPortal>& portals = scene.stated->portals;
    return std::any_of(portals.begin(), portals.end(), [&](const StatedPortal& portal) {
        return portal.kind == StatedPortalKind::Door && portal.source.line == start.source.line;
    });
}

void starts(const Examined& world, std::vector<WorldFault>& faults) {
    for (const Start& start : world.scene.starts) {
        if (before_upper_door(world.scene, start)) continue;
        if (world.space->nearest(start.feet_m, 0.5, 0.4, 1.0) != navigation::kNothing) continue;
        WorldFault fault{FaultKind::StartLost, start.feet_m, start.source};
        fault.name = start.name;
        faults.push_back(std::move(fault));
    }
}

void materials(const Scene& scene, std::vector<WorldFault>& faults) {
    for (const AlikeMaterials& pair : alike_materials(scene)) {
        WorldFault fault{FaultKind::AlikeMaterials};
        fault.name = pair.sentence;
        const auto surface = std::find_if(scene.surfaces.begin(), scene.surfaces.end(), [&](const SurfacePolygon& s) {
            return scene.material(s.material).name == pair.other;
        });
        if (surface != scene.surfaces.end()) {
            fault.at_m = centre_of(surface->polygon);
            fault.feature = surface->feature;
            if (const Feature* feature = scene.find(surface->feature)) fault.source = feature->source;
        }
        faults.push_back(std::move(fault));
    }
}

}  // namespace

void find_thing_faults(const Examined& world, std::vector<WorldFault>& faults) {
    materials(world.scene, faults);
    std::vector<FeatureId> things;
    for (std::uint32_t f = 0; f < world.scene.features.size(); ++f)
        if (world.is_thing(FeatureId{f})) things.push_back(FeatureId{f});
    twice(world, things, faults);
    if (world.space) starts(world, faults);
    for (const FeatureId id : things) {
        // In an architect's model, beams and window frames belong inside walls, so is_within_walls is not tested there.
        if ((!world.scene.stated && is_within_walls(world, id)) || (world.space && is_under_floors(world, id)))
            faults.push_back(fault_of(world, id, FaultKind::ThingBuried));
        else if (world.space && is_far_from_floors(world, id))
            faults.push_back(fault_of(world, id, FaultKind::ThingOutside));
        else if (touches_nothing(world, id)) faults.push_back(fault_of(world, id, FaultKind::ThingInTheAir));
    }
}

}  // namespace handrail::check
