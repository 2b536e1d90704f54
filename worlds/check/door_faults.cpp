#include <algorithm>
#include <cmath>
#include <map>

#include "worlds/base/human_measures.h"
#include "worlds/check/examined.h"
#include "worlds/geometry/clip.h"
#include "worlds/scene/stated_building.h"

namespace handrail::check {
namespace {

constexpr double kJamb_m = 0.06;       // greatest distance between the side of a leaf and its wall or frame
constexpr double kNextToDoor_m = 1.0;  // distance on both sides of a door within which floors are considered
constexpr double kTallest_m = 4.0;     // greatest height of a door; used if no floors are known
constexpr double kInFront_m = 0.5;     // a thing nearer to the door than this distance may block it

// One or more leaves that are next to each other and open together.
struct Doorway {
    std::vector<std::uint32_t> movers;
    std::vector<FeatureId> features;
    Aabb box;
    Vec3 normal{0.0};  // horizontal normal of the leaves; zero for a trapdoor or if a leaf is not flat
    bool opens = false;
    bool of_lift = false;
};

Vec3 face_of(const Examined& world, FeatureId feature) {
    double most_m2 = 0.0;
    Vec3 normal(0.0);
    for (const std::uint32_t i : world.solids_of(feature)) {
        const ConvexSolid& shape = world.scene.solids[i].shape;
        for (std::size_t f = 0; f < shape.planes.size(); ++f)
            if (const double area = area_m2(shape.faces[f]); area > most_m2) {
                most_m2 = area;
                normal = shape.planes[f].normal;
            }
    }
    return std::abs(normal.z) < 0.2 ? glm::normalize(Vec3(normal.x, normal.y, 0.0)) : Vec3(0.0);
}

std::vector<Doorway> doorways(const Examined& world) {
    std::vector<Doorway> doors;
    for (std::uint32_t m = 0; m < world.scene.movers.size(); ++m) {
        const Mover& mover = world.scene.movers[m];
        const Feature* feature = world.scene.find(mover.feature);
        if (!feature || feature->kind != FeatureKind::Door || world.solids_of(mover.feature).empty()) continue;
        const auto mate = std::find_if(doors.begin(), doors.end(), [&](const Doorway& door) {
            return world.scene.movers[door.movers.front()].group == mover.group &&
                   overlap(grown(door.box, 0.05), feature->bounds_m);
        });
        Doorway& door = mate != doors.end() ? *mate : doors.emplace_back();
        if (door.movers.empty()) door.normal = face_of(world, mover.feature);
        door.movers.push_back(m);
        door.features.push_back(mover.feature);
        door.box.include(feature->bounds_m);
        door.opens = door.opens || mover.moves();
        door.of_lift = door.of_lift || mover.lift != kNoMover;
    }
    return doors;
}

WorldFault fault_of(const Examined& world, const Doorway& door, FaultKind kind) {
    const Feature& feature = world.scene.features[door.features.front().value];
    WorldFault fault{kind, {door.box.centre_m().x, door.box.centre_m().y, door.box.min_m.z}, feature.source};
    fault.feature = door.features.front();
    fault.name = spoken_name(feature);
    fault.room = world.room_of(feature);
    return fault;
}

// True if a person can walk from one side of the doorway to the other over places within the doorway.
bool leads_through(const Examined& world, const Doorway& door, const std::vector<std::vector<std::uint32_t>>& within) {
    const navigation::WalkSpace& space = *world.space;
    std::map<std::uint32_t, bool> seen;
    for (const std::uint32_t m : door.movers)
        for (const std::uint32_t s : within[m]) seen[s] = false;
    for (auto& [first, done] : seen) {
        if (done) continue;
        bool before = false, behind = false;
        std::vector<std::uint32_t> open{first};
        done = true;
        while (!open.empty()) {
            const std::uint32_t here = open.back();
            open.pop_back();
            for (const std::uint32_t next : space.spans[here].next) {
                if (next == navigation::kNothing) continue;
                if (const auto inside = seen.find(next); inside != seen.end()) {
                    if (!inside->second) open.push_back(next);
                    inside->second = true;
                    continue;
                }
                const double side = glm::dot(space.place_m(next) - door.box.centre_m(), door.normal);
                (side > 0.0 ? before : behind) = true;
            }
        }
        if (before && behind) return true;
    }
    return false;
}

double width_of(const Doorway& door) {
    const Vec3 along(-door.normal.y, door.normal.x, 0.0), size = door.box.size_m();
    return std::abs(along.x) * size.x + std::abs(along.y) * size.y;
}

// Returns the name of a thing that blocks the doorway; empty if there is none.
std::string in_the_way(const Examined& world, const Doorway& door) {
    Aabb way = door.box;
    const Vec3 out = glm::abs(door.normal) * kInFront_m;
    way.min_m -= out, way.max_m += out;
    for (const std::uint32_t i : world.solids_near(way)) {
        const FeatureId id = world.scene.solids[i].feature;
        if (world.is_thing(id) && std::find(door.features.begin(), door.features.end(), id) == door.features.end())
            return spoken_name(world.scene.features[id.value]);
    }
    return {};
}

// True if there is a solid or sheet at both ends of the leaves, on which the door can hang and at which it can close.
bool has_wall(const Examined& world, const Doorway& door) {
    const Vec3 along(-door.normal.y, door.normal.x, 0.0);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const FeatureId id : door.features)
        for (const std::uint32_t i : world.solids_of(id))
            for (const Polygon& face : world.scene.solids[i].shape.faces)
                for (const Vec3& p : face.points_m) {
                    const double at = glm::dot(p - door.box.centre_m(), along);
                    low = std::min(low, at), high = std::max(high, at);
                }
    const auto held = [&](double at) {
        return world.something_at(door.box.centre_m() + along * at, 0.03, door.features);
    };
    return held(low - kJamb_m) && held(high + kJamb_m);
}

// Returns the height difference between the floors that the door extends across.
double levels_apart(const Examined& world, const Doorway& door) {
    if (!world.space) return door.box.size_m().z > kTallest_m ? door.box.size_m().z : 0.0;
    const navigation::WalkSpace& space = *world.space;
    const auto cell = [&](double at, double origin, std::uint32_t most) {
        return static_cast<std::uint32_t>(std::clamp((at - origin) / space.cell_m, 0.0, most - 1.0));
    };
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const Aabb around = grown(door.box, kNextToDoor_m);
    const std::uint32_t x1 = cell(around.max_m.x, space.origin_m.x, space.width),
                        y1 = cell(around.max_m.y, space.origin_m.y, space.depth);
    for (std::uint32_t y = cell(around.min_m.y, space.origin_m.y, space.depth); y <= y1; ++y)
        for (std::uint32_t x = cell(around.min_m.x, space.origin_m.x, space.width); x <= x1; ++x)
            for (std::uint32_t s = space.first[y * space.width + x]; s < space.first[y * space.width + x + 1]; ++s) {
                const double floor = space.origin_m.z + static_cast<double>(space.spans[s].floor_m);
                if (floor < door.box.min_m.z - 0.3 || floor > door.box.max_m.z - 0.5 || space.spans[s].stairs) continue;
                low = std::min(low, floor), high = std::max(high, floor);
            }
    return high - low > kAboveOrBelow_m ? high - low : 0.0;
}

}  // namespace

void find_door_faults(const Examined& world, std::vector<WorldFault>& faults) {
    std::vector<std::vector<std::uint32_t>> within(world.scene.movers.size());
    if (world.space)
        for (std::uint32_t s = 0; s < world.space->spans.size(); ++s)
            if (const std::uint32_t door = world.space->spans[s].door; door < within.size()) within[door].push_back(s);
    std::vector<FeatureId> stated_doors;  // features of the doors that the file states
    if (world.scene.stated)
        for (const StatedPortal& portal : world.scene.stated->portals) stated_doors.push_back(portal.feature);
    for (const Doorway& door : doorways(world)) {
        if (door.normal == Vec3(0.0)) continue;
        const bool stated =
            std::find(stated_doors.begin(), stated_doors.end(), door.features.front()) != stated_doors.end();
        if (!stated && world.space && !door.of_lift && (!door.opens || !leads_through(world, door, within))) {
            WorldFault fault = fault_of(world, door, FaultKind::ImpassableDoor);
            if (door.opens) fault.other = in_the_way(world, door);
            fault.amount = door.opens ? width_of(door) : 0.0;
            faults.push_back(std::move(fault));
        }
        if (!stated && !has_wall(world, door)) faults.push_back(fault_of(world, door, FaultKind::DoorOnNoWall));
        if (const double apart = levels_apart(world, door); apart > 0.0) {
            faults.push_back(fault_of(world, door, FaultKind::DoorOverLevels));
            faults.back().amount = apart;
        }
    }
}

}  // namespace handrail::check
