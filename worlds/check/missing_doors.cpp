#include "worlds/check/missing_doors.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "worlds/base/contract.h"
#include "worlds/base/human_measures.h"
#include "worlds/check/examined.h"
#include "worlds/geometry/clip.h"

namespace handrail::check {
namespace {

constexpr double kThickest_m = 0.8, kThinnest_m = 0.03;
constexpr double kWidth_m = 0.9;      // width of a made doorway, if the wall is long enough
constexpr double kNarrowest_m = 0.7;  // least width of a made doorway that people can pass
constexpr double kSameFloor_m = 0.15;
// Base of the scores of walls near the given place; greater than the length of any wall.
constexpr double kNear_m = 1e6;
constexpr double kChest_m = 1.0;      // height above the floor at which walls are searched
constexpr double kUpright = 1e-3;     // greatest z of the unit normal of a wall
constexpr double kSameWall_m = 0.01;  // adjacent faces whose offsets differ by less than this belong to one wall
constexpr double kSameWay = 1e-4;     // greatest 1 - cos of the angle between equal directions (0.8 degrees)

// A face of a wall, with the places in front of it at which a door would lead into another room.
struct Facing {
    Vec3 in{0.0};  // horizontal direction into the wall
    double at_m = 0.0;
    std::uint32_t other = navigation::kNothing;
    struct Place {
        double along_m = 0.0;
        Vec3 middle_m{0.0};  // middle of the wall's thickness, at floor height
        double through_m = 0.0;
    };
    std::vector<Place> places;
};

Vec3 right_of(const Vec3& way) { return {way.y, -way.x, 0.0}; }

// True if the line crosses some part of the building, and nothing else that is solid.
bool is_wall(const Examined& world, const Vec3& from_m, const Vec3& to_m) {
    bool wall = false;
    for (const double up : {0.4, 1.0, 1.6})
        for (int i = 1; i < 8; ++i) {
            const Vec3 at = from_m + (to_m - from_m) * (i / 8.0) + Vec3(0.0, 0.0, up);
            const Solid* solid = world.solid_at(at, 1e-3);
            if (!solid) continue;
            const Feature* feature = world.scene.find(solid->feature);
            if (solid->role != SolidRole::Solid || (feature && !feature->made_name)) return false;
            wall = true;
        }
    return wall;
}

// Returns the wall faces of a room that have another room behind them. They are found from the edges of the walkable
// area, so walls may have any direction.
std::vector<Facing> walls_to_others(const Examined& world, std::uint32_t room) {
    const navigation::WalkSpace& space = *world.space;
    const navigation::RoomGraph& graph = *world.graph;
    const double reach_m = space.body.radius_m + 1.5 * space.cell_m;
    const double farthest_m = kThickest_m + 2.0 * (space.body.radius_m + space.cell_m);
    std::vector<Facing> walls;
    // Finds the room behind a face, the far side of the wall, and the wall's thickness.
    const auto look_behind = [&](const Vec3& from_m, const Vec3& in, double before_m, double at_m) {
        for (double far_m = before_m + space.cell_m; far_m <= farthest_m; far_m += 0.5 * space.cell_m) {
            const std::uint32_t there = space.at(from_m + in * far_m);
            if (there == navigation::kNothing || std::abs(space.place_m(there).z - from_m.z) > kSameFloor_m) continue;
            const std::uint32_t other = graph.room_of_span[there];
            if (other == navigation::kNothing || other == room || graph.rooms[other].kind != navigation::RoomKind::Room)
                return;
            auto wall = std::find_if(walls.begin(), walls.end(), [&](const Facing& known) {
                return known.other == other && std::abs(known.at_m - at_m) < kSameWall_m &&
                       glm::dot(known.in, in) > 1.0 - kSameWay;
            });
            if (wall == walls.end()) wall = walls.insert(walls.end(), {in, at_m, other, {}});
            const double through_m = std::max(0.0, far_m - before_m - space.body.radius_m);
            Vec3 middle_m = from_m + in * (before_m + 0.5 * through_m);
            middle_m.z = 0.5 * (from_m.z + space.place_m(there).z);
            wall->places.push_back({glm::dot(from_m, right_of(in)), middle_m, through_m});
            return;
        }
    };
    for (std::uint32_t s = 0; s < space.spans.size(); ++s) {
        const navigation::WalkSpan& span = space.spans[s];
        if (graph.room_of_span[s] != room || span.liquid ||
            std::none_of(std::begin(span.next), std::end(span.next),
                         [](std::uint32_t n) { return n == navigation::kNothing; }))
            continue;
        const Vec3 from_m = space.place_m(s), chest_m = from_m + Vec3(0.0, 0.0, kChest_m);
        const Vec3 around(reach_m, reach_m, 0.0);
        const std::vector<std::uint32_t> near = world.solids_near({chest_m - around, chest_m + around});
        std::vector<Vec3> looked;  // directions that have been tested
        for (const std::uint32_t n : near) {
            const Solid& solid = world.scene.solids[n];
            if (solid.role != SolidRole::Solid) continue;
            for (const Plane& face : solid.shape.planes) {
                const double before_m = glm::dot(face.normal, chest_m) - face.offset_m;
                if (std::abs(face.normal.z) > kUpright || before_m <= 0.0 || before_m > reach_m ||
                    !contains(solid.shape, chest_m - face.normal * before_m, kSameWall_m))
                    continue;
                const Vec3 in = -glm::normalize(Vec3(face.normal.x, face.normal.y, 0.0));
                if (std::any_of(looked.begin(), looked.end(),
                                [&](const Vec3& way) { return glm::dot(way, in) > 1.0 - kSameWay; }))
                    continue;
                looked.push_back(in);
                look_behind(from_m, in, before_m, -face.offset_m);
            }
        }
    }
    return walls;
}

}  // namespace

std::vector<MissingDoor> missing_doors(const Scene& scene, const navigation::WalkSpace& space,
                                       const navigation::RoomGraph& graph, std::uint32_t room,
                                       const std::optional<Vec3>& near_m, std::size_t most) {
    contract_pre(room < graph.rooms.size());
    const Examined world(scene, &space, &graph);
    // The best door to each other room, with its score: the length of the wall, or its nearness to near_m.
    std::map<std::uint32_t, std::pair<double, MissingDoor>> best;
    for (Facing& wall : walls_to_others(world, room)) {
        std::vector<Facing::Place>& places = wall.places;
        std::stable_sort(places.begin(), places.end(),
                         [](const auto& a, const auto& b) { return a.along_m < b.along_m; });
        for (std::size_t begin = 0; begin < places.size();) {
            std::size_t end = begin + 1;
            while (end < places.size() && places[end].along_m - places[end - 1].along_m < 2.5 * space.cell_m) ++end;
            const double first_m = places[begin].along_m, last_m = places[end - 1].along_m;
            // The walkable places end half a body's width before the ends of the wall.
            const double long_m = last_m - first_m + 2.0 * space.body.radius_m, width_m = std::min(kWidth_m, long_m);
            const double beside_m = std::max(0.0, 0.5 * width_m - space.body.radius_m);
            const Facing::Place* middle = &places[begin];
            double score_m = long_m, nearest_m = kArmsReach_m;
            for (std::size_t i = begin; i < end; ++i)
                if (std::abs(places[i].along_m - 0.5 * (first_m + last_m)) <
                    std::abs(middle->along_m - 0.5 * (first_m + last_m)))
                    middle = &places[i];
            for (std::size_t i = begin; near_m && i < end; ++i) {
                const double off_m = glm::length(places[i].middle_m - *near_m);
                if (off_m >= nearest_m || places[i].along_m - first_m < beside_m ||
                    last_m - places[i].along_m < beside_m)
                    continue;
                nearest_m = off_m;
                middle = &places[i];
                score_m = kNear_m - off_m;
            }
            begin = end;
            if (long_m < kNarrowest_m) continue;
            auto& [known_m, found] = best[wall.other];
            if (score_m <= known_m) continue;
            const double half_m = 0.5 * std::max(middle->through_m, kThinnest_m) + 0.1;
            if (!is_wall(world, middle->middle_m - wall.in * half_m, middle->middle_m + wall.in * half_m)) continue;
            known_m = score_m;
            found.to = wall.other;
            found.door.place_m = middle->middle_m;
            found.door.heading_rad = std::atan2(wall.in.x, wall.in.y);
            found.door.width_m = width_m;
            found.door.through_m = std::clamp(middle->through_m, kThinnest_m, kThickest_m) + 0.1;
        }
    }
    std::vector<std::pair<double, MissingDoor>> all;
    for (auto& [other, found] : best)
        if (found.second.to != navigation::kNothing) all.push_back(std::move(found));
    // Sorts the ground outside to the end, because doors to rooms are more likely.
    std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) {
        const bool a_outside = world.is_ground(a.second.to), b_outside = world.is_ground(b.second.to);
        return a_outside != b_outside ? b_outside : a.first > b.first;
    });
    std::vector<MissingDoor> doors;
    for (auto& [long_m, door] : all)
        if (doors.size() < most) doors.push_back(std::move(door));
    return doors;
}

std::optional<MadeDoor> doorway_cut_free(const Scene& scene, const WorldFault& fault) {
    // If the fault has no width, something other than a wall makes the door impassable.
    if (fault.kind != FaultKind::ImpassableDoor || !fault.other.empty() || !(fault.amount > 0.0)) return std::nullopt;
    const Examined world(scene, nullptr, nullptr);
    const auto is_of_building = [&](const Solid& solid) {
        const Feature* feature = scene.find(solid.feature);
        return solid.role == SolidRole::Solid && (!feature || feature->made_name);
    };
    Vec3 way(0.0);
    double largest_m2 = 0.0;
    const auto look_at = [&](const Solid& solid) {
        for (std::size_t f = 0; f < solid.shape.planes.size(); ++f)
            if (const Vec3& n = solid.shape.planes[f].normal; std::abs(n.z) < kUpright)
                if (const double area = area_m2(solid.shape.faces[f]); area > largest_m2) {
                    largest_m2 = area;
                    way = glm::normalize(Vec3(n.x, n.y, 0.0));
                }
    };
    if (scene.find(fault.feature))
        for (const std::uint32_t i : world.solids_of(fault.feature)) look_at(scene.solids[i]);
    else if (const Solid* wall = world.solid_at(fault.at_m + Vec3(0.0, 0.0, kChest_m), 0.05);
             wall && is_of_building(*wall))
        look_at(*wall);
    if (way == Vec3(0.0)) return std::nullopt;
    // The doorway extends to both sides of the door as far as there are parts of the building. Nothing else may be
    // within it.
    MadeDoor door{fault.at_m, std::atan2(way.x, way.y), std::clamp(fault.amount, kNarrowest_m, kWidth_m), 0.0,
                  fault.name};
    bool walled = false;
    const double half_m = 0.5 * door.width_m - 0.05;
    for (const double side : {-1.0, 1.0})
        for (double far_m = 0.0; far_m <= kThickest_m; far_m += 0.02)
            for (const double across : {-half_m, 0.0, half_m})
                for (const double up : {0.3, kChest_m, 1.7}) {
                    const Vec3 at = fault.at_m + way * (side * far_m) + right_of(way) * across + Vec3(0.0, 0.0, up);
                    const Solid* solid = world.solid_at(at, 1e-3, {fault.feature});
                    if (!solid) continue;
                    if (!is_of_building(*solid)) return std::nullopt;
                    walled = true;
                    door.through_m = std::max(door.through_m, 2.0 * far_m + 0.1);
                }
    if (!walled) return std::nullopt;
    return door;
}

}  // namespace handrail::check
