#include "app/core/learning/learning.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

#include "app/core/learning/place_cells.h"
#include "worlds/base/contract.h"
#include "worlds/geometry/clip.h"

namespace handrail::core {
namespace {

// Largest number of notes, enough for 40 km of new ground. Any further notes are dropped.
constexpr std::size_t kMostNotes = 1000000;
constexpr double kSpot_m = 0.04;
constexpr double kLane_m = 1.0, kLaneOff_m = 0.4;
// A touch belongs to a wall if it is at most this far from the wall. So a hand on the front of a radiator also learns
// the wall behind the radiator.
constexpr double kNormalOff_m = 0.3;
// Walls shorter than this are not announced. A door jamb is part of the perimeter, but too short to announce.
constexpr double kLeastWall_m = 0.2;
constexpr double kUnknown_m = 0.45;  // radius of the neighbourhood of a sample in which unknown wall is added up
// A person whose path is within this distance of a door's middle has passed through the door. A person who only walks
// along the wall with the door stays farther away.
constexpr double kThrough_m = 0.3;

// Returns the key of a spot, which is a cell a few centimetres wide. For a touch, `facing` is one plus the number of
// the eighth of the circle that the wall faces. For a step, `facing` is 0.
std::uint64_t spot_of(const Vec3& point_m, std::size_t facing) {
    const auto part = [](double metres) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(metres / kSpot_m))) & 0xfffffU;
    };
    return part(point_m.x) | part(point_m.y) << 20U | part(point_m.z) << 40U |
           static_cast<std::uint64_t>(facing) << 60U;
}

bool knows(const WallSample& wall, const TouchNote& note) {
    const Vec3 way = wall.point_m - note.point_m;
    if (glm::dot(wall.normal, note.normal) < 0.5 || way.z > kSameFloor_m || way.z < -kRoomHeight_m) return false;
    const double off = way.x * wall.normal.x + way.y * wall.normal.y;
    const double along = -way.x * wall.normal.y + way.y * wall.normal.x;
    return std::abs(off) <= kNormalOff_m && std::abs(along) <= note.reach_m;
}

// The samples of the boundary that are still unknown, sorted into squares as wide as the neighbourhood of a sample.
class UnknownWalls {
public:
    explicit UnknownWalls(const Learnt& learnt) : walls_(learnt.place().walls) {
        for (std::uint32_t i = 0; i < walls_.size(); ++i)
            if (!learnt.knows_wall(i)) squares_[square_of(walls_[i].point_m, 0, 0)].push_back(i);
    }
    // Returns the unknown length of the same wall in the neighbourhood of this sample.
    double beside_m(const WallSample& wall) const {
        double sum_m = 0.0;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const auto found = squares_.find(square_of(wall.point_m, dx, dy));
                if (found == squares_.end()) continue;
                for (const std::uint32_t i : found->second)
                    if (walls_[i].feature == wall.feature && glm::length(walls_[i].point_m - wall.point_m) < kUnknown_m)
                        sum_m += walls_[i].length_m;
            }
        return sum_m;
    }

private:
    static std::pair<int, int> square_of(const Vec3& at_m, int dx, int dy) {
        return {static_cast<int>(std::floor(at_m.x / kUnknown_m)) + dx,
                static_cast<int>(std::floor(at_m.y / kUnknown_m)) + dy};
    }

    const std::vector<WallSample>& walls_;
    std::map<std::pair<int, int>, std::vector<std::uint32_t>> squares_;
};

}  // namespace

void LearningNotes::touched(const Vec3& point_m, const Vec3& normal, double reach_m) {
    contract_pre(is_finite(point_m) && is_finite(normal));
    contract_pre(reach_m >= 0.0);
    const double length = std::sqrt(normal.x * normal.x + normal.y * normal.y);
    // The surface is a floor or a ceiling, or there are already kMostNotes notes.
    if (length < 0.7 || count() >= kMostNotes) return;
    const Vec3 level(normal.x / length, normal.y / length, 0.0);
    // The reach is at least the width of a spot, so that neighbouring spots leave no gap.
    const double reach = std::max(reach_m, kSpot_m);
    double& reached =
        spots_.try_emplace(spot_of(point_m, 1 + nearest_eighth(std::atan2(level.y, level.x))), 0.0).first->second;
    if (reach <= reached) return;
    reached = reach;
    touches_.push_back({point_m, level, reach});
}

void LearningNotes::walked(const Vec3& feet_m) {
    contract_pre(is_finite(feet_m));
    if (count() < kMostNotes && spots_.try_emplace(spot_of(feet_m, 0), 0.0).second) steps_m_.push_back(feet_m);
}

bool LearningNotes::any_in(const Aabb& box) const {
    const auto in = [&](const Vec3& p) { return overlap(box, Aabb{p, p}); };
    return std::any_of(touches_.begin(), touches_.end(), [&](const TouchNote& note) { return in(note.point_m); }) ||
           std::any_of(steps_m_.begin(), steps_m_.end(), in);
}

double Place::area_m2() const {
    return static_cast<double>(std::count(free.begin(), free.end(), true)) * cell_m * cell_m;
}

Learnt::Learnt(Place place)
    : place_(std::move(place)),
      known_(place_.walls.size(), false),
      walked_(place_.free.size(), false),
      beside_(place_.free.size(), false),
      taken_(place_.exits.size(), false) {}

void Learnt::lay(const LearningNotes& notes) {
    for (; touches_ < notes.touches().size(); ++touches_)
        for (std::size_t i = 0; i < known_.size(); ++i)
            if (!known_[i]) known_[i] = knows(place_.walls[i], notes.touches()[touches_]);
    const int reach = static_cast<int>(std::ceil(kFloorReach_m / place_.cell_m)) + 1;
    for (; steps_ < notes.steps_m().size(); ++steps_) {
        const Vec3& step = notes.steps_m()[steps_];
        const int cx = static_cast<int>(std::floor((step.x - place_.origin_m.x) / place_.cell_m));
        const int cy = static_cast<int>(std::floor((step.y - place_.origin_m.y) / place_.cell_m));
        for (int y = std::max(0, cy - reach); y <= std::min(place_.deep - 1, cy + reach); ++y)
            for (int x = std::max(0, cx - reach); x <= std::min(place_.wide - 1, cx + reach); ++x) {
                const std::size_t i = place_.at(x, y);
                if (!place_.free[i] || (walked_[i] && beside_[i])) continue;
                const Vec3 off = place_.middle_m(x, y) - step;
                const double far_m2 = off.x * off.x + off.y * off.y;
                if (std::abs(off.z) > kSameFloor_m || far_m2 > kFloorReach_m * kFloorReach_m) continue;
                walked_[i] = true;
                if (far_m2 <= kLaneOff_m * kLaneOff_m) beside_[i] = true;
            }
        for (std::size_t i = 0; i < place_.exits.size(); ++i) {
            const PlaceExit& exit = place_.exits[i];
            const Vec3 off = exit.at_m - step;
            const double near_m = exit.door ? kThrough_m : std::max(kThrough_m, 0.5 * exit.width_m);
            if (std::abs(off.z) < kRoomHeight_m && std::hypot(off.x, off.y) <= near_m) taken_[i] = true;
        }
    }
}

bool Learnt::found(const PlaceExit& exit) const {
    if (taken_[static_cast<std::size_t>(&exit - place_.exits.data())]) return true;
    for (std::size_t i = 0; i < known_.size(); ++i)
        if (known_[i] &&
            std::find(exit.features.begin(), exit.features.end(), place_.walls[i].feature) != exit.features.end())
            return true;
    return false;
}

Progress progress_of(const Learnt& learnt) {
    const Place& place = learnt.place();
    Progress progress;
    for (std::size_t i = 0; i < place.walls.size(); ++i) {
        const FeatureId feature = place.walls[i].feature;
        auto wall = std::find_if(progress.walls.begin(), progress.walls.end(),
                                 [&](const WallProgress& w) { return w.feature == feature; });
        if (wall == progress.walls.end()) wall = progress.walls.insert(progress.walls.end(), WallProgress{feature});
        const double length_m = place.walls[i].length_m;
        wall->length_m += length_m;
        progress.perimeter_m += length_m;
        if (!learnt.knows_wall(i)) continue;
        wall->touched_m += length_m;
        progress.touched_m += length_m;
    }
    std::erase_if(progress.walls, [](const WallProgress& wall) { return wall.length_m < kLeastWall_m; });
    for (const PlaceExit& exit : place.exits) {
        ++progress.exits;
        progress.exits_found += learnt.found(exit);
        progress.doors_only &= exit.door;
    }
    progress.floor_m2 = place.area_m2();
    std::size_t walked = 0;
    for (int y = 0; y < place.deep; ++y)
        for (int x = 0; x < place.wide; ++x) walked += learnt.walked(x, y);
    progress.walked_m2 = static_cast<double>(walked) * place.cell_m * place.cell_m;
    return progress;
}

std::optional<Unexplored> nearest_unexplored(const Learnt& learnt, const Vec3& feet_m) {
    contract_pre(is_finite(feet_m));
    const Place& place = learnt.place();
    std::optional<Unexplored> nearest;
    double nearest_m = 1e9;
    const auto offer = [&](const Vec3& point, bool wall, FeatureId feature) {
        const double distance = std::hypot(point.x - feet_m.x, point.y - feet_m.y);
        if (distance >= nearest_m) return;
        nearest_m = distance;
        nearest = Unexplored{point, wall, feature};
    };
    const UnknownWalls unknown_walls(learnt);
    for (std::size_t i = 0; i < place.walls.size(); ++i) {
        if (learnt.knows_wall(i)) continue;
        const WallSample& wall = place.walls[i];
        // Skip a sample that is farther away than the best sample until now.
        if (std::hypot(wall.point_m.x - feet_m.x, wall.point_m.y - feet_m.y) >= nearest_m) continue;
        if (unknown_walls.beside_m(wall) >= kUnknown_m) offer(wall.point_m, true, wall.feature);
    }
    std::vector<bool> seen(place.free.size());
    const auto unknown = [&](int x, int y) {
        return place.is_free(x, y) && !learnt.walked(x, y) && !seen[place.at(x, y)];
    };
    for (int y = 0; y < place.deep; ++y)
        for (int x = 0; x < place.wide; ++x) {
            if (!unknown(x, y)) continue;
            std::vector<std::pair<int, int>> patch{{x, y}};
            seen[place.at(x, y)] = true;
            for (std::size_t i = 0; i < patch.size(); ++i)
                for (const auto& [dx, dy] : kCellWays) {
                    const int nx = patch[i].first + dx, ny = patch[i].second + dy;
                    if (!unknown(nx, ny)) continue;
                    seen[place.at(nx, ny)] = true;
                    patch.emplace_back(nx, ny);
                }
            if (static_cast<double>(patch.size()) * place.cell_m * place.cell_m < 0.5) continue;
            for (const auto& [px, py] : patch) offer(place.middle_m(px, py), false, kNoFeature);
        }
    return nearest;
}

std::vector<Lane> lanes_of(const Learnt& learnt) {
    const Place& place = learnt.place();
    // Computes the bounds of the room itself, without the margin of the grid.
    int x0 = place.wide, y0 = place.deep, x1 = -1, y1 = -1;
    for (int y = 0; y < place.deep; ++y)
        for (int x = 0; x < place.wide; ++x)
            if (place.is_free(x, y))
                x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
    std::vector<Lane> lanes;
    for (const bool north : {true, false}) {
        const int first = north ? x0 : y0, across = (north ? x1 : y1) - first + 1;
        const int count = std::max(1, static_cast<int>(std::lround(across * place.cell_m / kLane_m)));
        for (int i = 0; i < count; ++i) {
            const int c = first + static_cast<int>((i + 0.5) * across / count);
            Lane lane{north, (north ? place.origin_m.x : place.origin_m.y) + (c + 0.5) * place.cell_m, 0.0, 0.0};
            for (int k = north ? y0 : x0; k <= (north ? y1 : x1); ++k) {
                const int x = north ? c : k, y = north ? k : c;
                if (!place.is_free(x, y)) continue;
                lane.length_m += place.cell_m;
                if (learnt.along_lane(x, y)) lane.walked_m += place.cell_m;
            }
            if (lane.length_m > 0.5) lanes.push_back(lane);
        }
    }
    return lanes;
}

}  // namespace handrail::core
