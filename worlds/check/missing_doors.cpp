#include "worlds/check/missing_doors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "worlds/base/contract.h"
#include "worlds/check/examined.h"

namespace handrail {
namespace {

constexpr double kThickest_m = 0.8, kThinnest_m = 0.03;
constexpr double kWidth_m = 0.9;      // of a doorway, where the wall is long enough
constexpr double kNarrowest_m = 0.7;  // which bodies pass still
constexpr double kSameFloor_m = 0.15;
constexpr double kReach_m = 1.2;  // of who stands at a wall, to its middle
constexpr double kNear_m = 1e6;   // before whatever is long
constexpr int kDirections = 4;

Vec3 step_of(int direction) {
    constexpr std::array<std::array<double, 2>, kDirections> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const auto& step = kSteps[static_cast<std::size_t>(direction)];
    return {step[0], step[1], 0.0};
}

// Nothing but the building itself, and something of it, all the way.
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

}  // namespace

std::vector<MissingDoor> missing_doors(const Scene& scene, const WalkSpace& space, const RoomGraph& graph,
                                       std::uint32_t room, const std::optional<Vec3>& near_m, std::size_t most) {
    contract_pre(room < graph.rooms.size());
    const Examined world(scene, &space, &graph);
    const double farthest_m = kThickest_m + 2.0 * (space.body.radius_m + space.cell_m);
    // By the other room, the direction, and the line on which one stands there.
    std::map<std::tuple<std::uint32_t, int, long, long>, std::vector<std::pair<double, Vec3>>> facing;
    for (std::uint32_t s = 0; s < space.spans.size(); ++s) {
        if (graph.room_of_span[s] != room || space.spans[s].liquid) continue;
        const Vec3 from_m = space.place_m(s);
        for (int d = 0; d < kDirections; ++d) {
            if (space.spans[s].next[d] != kNothing) continue;
            const Vec3 step = step_of(d);
            for (double far_m = space.cell_m; far_m <= farthest_m; far_m += space.cell_m) {
                const std::uint32_t there = space.at(from_m + step * far_m);
                if (there == kNothing || std::abs(space.place_m(there).z - from_m.z) > kSameFloor_m) continue;
                const std::uint32_t other = graph.room_of_span[there];
                if (other == kNothing || other == room || graph.rooms[other].kind != RoomKind::Room) break;
                const Vec3 to_m = space.place_m(there);
                const bool east = d % 2 == 0;
                facing[{other, d, std::lround((east ? from_m.x : from_m.y) / space.cell_m),
                        std::lround((east ? to_m.x : to_m.y) / space.cell_m)}]
                    .emplace_back(east ? from_m.y : from_m.x, 0.5 * (from_m + to_m));
                break;
            }
        }
    }
    std::map<std::uint32_t, std::pair<double, MissingDoor>> best;  // by the other room, with how long its wall is
    for (auto& [key, places] : facing) {
        const auto& [other, direction, here, there] = key;
        std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        const double through_m = static_cast<double>(std::abs(there - here)) * space.cell_m - 2.0 * space.body.radius_m;
        for (std::size_t begin = 0; begin < places.size();) {
            std::size_t end = begin + 1;
            while (end < places.size() && places[end].first - places[end - 1].first < 1.5 * space.cell_m) ++end;
            // Whoever stands at an end of the stretch has the body's width beside the middle.
            const double long_m = places[end - 1].first - places[begin].first + 2.0 * space.body.radius_m;
            const double width_m = std::min(kWidth_m, long_m);
            const double beside_m = std::max(0.0, 0.5 * width_m - space.body.radius_m);
            Vec3 middle_m = places[(begin + end) / 2].second;
            double score_m = long_m, nearest_m = kReach_m;
            for (std::size_t i = begin; near_m && i < end; ++i) {
                const double off_m = glm::length(places[i].second - *near_m);
                if (off_m >= nearest_m || places[i].first - places[begin].first < beside_m ||
                    places[end - 1].first - places[i].first < beside_m)
                    continue;
                nearest_m = off_m;
                middle_m = places[i].second;
                score_m = kNear_m - off_m;
            }
            begin = end;
            if (long_m < kNarrowest_m) continue;
            auto& [known_m, found] = best[other];
            if (score_m <= known_m) continue;
            const Vec3 step = step_of(direction);
            const double half_m = 0.5 * std::max(through_m, kThinnest_m) + 0.1;
            if (!is_wall(world, middle_m - step * half_m, middle_m + step * half_m)) continue;
            known_m = score_m;
            found.to = other;
            found.door.place_m = middle_m;
            found.door.heading_rad = std::atan2(step.x, step.y);
            found.door.width_m = width_m;
            found.door.through_m = std::clamp(through_m, kThinnest_m, kThickest_m) + 0.1;
        }
    }
    std::vector<std::pair<double, MissingDoor>> all;
    for (auto& [other, found] : best)
        if (found.second.to != kNothing) all.push_back(std::move(found));
    // The ground outside comes last: rooms lead to rooms.
    std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) {
        const bool a_outside = world.is_ground(a.second.to), b_outside = world.is_ground(b.second.to);
        return a_outside != b_outside ? b_outside : a.first > b.first;
    });
    std::vector<MissingDoor> doors;
    for (auto& [long_m, door] : all)
        if (doors.size() < most) doors.push_back(std::move(door));
    return doors;
}

}  // namespace handrail
