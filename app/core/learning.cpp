#include "app/core/learning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

namespace handrail {
namespace {

constexpr std::size_t kMostNotes = 40000;
constexpr double kNoteEvery_m = 0.04;
constexpr double kFarthest_m = 15.0;
constexpr std::size_t kMostCells = 60000;
constexpr double kLane_m = 1.0, kLaneOff_m = 0.4;
constexpr double kSameFloor_m = 0.6, kRoomHeight_m = 2.6;
constexpr double kNormalOff_m = 0.3;  // a hand above a radiator touches the wall behind it

template <class T>
void make_room(std::vector<T>& notes) {
    if (notes.size() >= kMostNotes) notes.erase(notes.begin(), notes.begin() + kMostNotes / 4);
}

bool knows(const WallSample& wall, const TouchNote& note) {
    const Vec3 way = wall.point_m - note.point_m;
    if (glm::dot(wall.normal, note.normal) < 0.5 || way.z > kSameFloor_m || way.z < -kRoomHeight_m) return false;
    const double off = way.x * wall.normal.x + way.y * wall.normal.y;
    const double along = -way.x * wall.normal.y + way.y * wall.normal.x;
    return std::abs(off) <= kNormalOff_m && std::abs(along) <= note.reach_m;
}

std::vector<bool> known_walls(const Place& place, const LearningNotes& notes) {
    std::vector<bool> known(place.walls.size());
    for (std::size_t i = 0; i < place.walls.size(); ++i)
        known[i] = std::any_of(notes.touches().begin(), notes.touches().end(), [&](const TouchNote& note) { return knows(place.walls[i], note); });
    return known;
}

// Of each cell, whether a step was made within `reach_m` of its middle.
std::vector<bool> walked_cells(const Place& place, const LearningNotes& notes, double reach_m) {
    std::vector<bool> walked(place.free.size());
    const int around = static_cast<int>(std::ceil(reach_m / Place::kCell_m)) + 1;
    for (const Vec3& step : notes.steps_m()) {
        if (std::abs(step.z - place.origin_m.z) > kSameFloor_m) continue;
        const int cx = static_cast<int>(std::floor((step.x - place.origin_m.x) / Place::kCell_m));
        const int cy = static_cast<int>(std::floor((step.y - place.origin_m.y) / Place::kCell_m));
        for (int y = cy - around; y <= cy + around; ++y)
            for (int x = cx - around; x <= cx + around; ++x) {
                if (!place.is_free(x, y)) continue;
                const Vec3 middle = place.middle_m(x, y);
                const double dx = middle.x - step.x, dy = middle.y - step.y;
                if (dx * dx + dy * dy <= reach_m * reach_m) walked[static_cast<std::size_t>(y * place.wide + x)] = true;
            }
    }
    return walked;
}

}  // namespace

void LearningNotes::touched(const Vec3& point_m, const Vec3& normal, double reach_m) {
    const double length = std::sqrt(normal.x * normal.x + normal.y * normal.y);
    if (length < 0.7) return;  // floor or ceiling
    const Vec3 level(normal.x / length, normal.y / length, 0.0);
    if (!touches_.empty() && glm::length(touches_.back().point_m - point_m) < kNoteEvery_m && glm::dot(touches_.back().normal, level) > 0.99) return;
    make_room(touches_);
    touches_.push_back({point_m, level, reach_m});
    ++noted_;
}

void LearningNotes::walked(const Vec3& feet_m) {
    if (!steps_m_.empty() && glm::length(steps_m_.back() - feet_m) < kNoteEvery_m) return;
    make_room(steps_m_);
    steps_m_.push_back(feet_m);
    ++noted_;
}

bool Place::holds(const Vec3& feet_m) const {
    const int x = static_cast<int>(std::floor((feet_m.x - origin_m.x) / kCell_m)), y = static_cast<int>(std::floor((feet_m.y - origin_m.y) / kCell_m));
    return std::abs(feet_m.z - origin_m.z) < kSameFloor_m && is_free(x, y);
}

double Place::area_m2() const { return static_cast<double>(std::count(free.begin(), free.end(), true)) * kCell_m * kCell_m; }

Place place_around(const BodyWorld& world, const Vec3& feet_m, const BodySize& body) {
    constexpr int kHalf = static_cast<int>(kFarthest_m / Place::kCell_m);
    constexpr int kWide = 2 * kHalf + 1;
    const Scene& scene = world.scene();
    std::vector<Aabb> doors;
    std::vector<FeatureId> door_features;
    for (std::uint32_t i = 0; i < scene.features.size(); ++i)
        if (const Feature& feature = scene.features[i]; feature.kind == FeatureKind::Door && !feature.bounds_m.empty()) {
            doors.push_back(feature.bounds_m);
            door_features.push_back(FeatureId{i});
        }
    const BodyShape column{0.0, body.height_m - body.step_up_m - 0.1};
    const double lift = body.step_up_m + 0.02;
    Place all;
    all.origin_m = feet_m - Vec3((kHalf + 0.5) * Place::kCell_m, (kHalf + 0.5) * Place::kCell_m, 0.0);
    all.wide = all.deep = kWide;
    all.free.assign(static_cast<std::size_t>(kWide) * kWide, false);
    std::vector<float> height(all.free.size(), 0.0F);
    // 1. The free cells, from the body on.
    const auto index = [&](int x, int y) { return static_cast<std::size_t>(y * kWide + x); };
    const auto door_at = [&](const Vec3& p) {
        for (std::size_t i = 0; i < doors.size(); ++i)
            if (p.x > doors[i].min_m.x && p.x < doors[i].max_m.x && p.y > doors[i].min_m.y && p.y < doors[i].max_m.y && p.z + 1.0 > doors[i].min_m.z &&
                p.z < doors[i].max_m.z)
                return static_cast<int>(i);
        return -1;
    };
    // A leaf may be thinner than a cell: the way from cell to cell is looked at.
    const auto passes_door = [&](const Vec3& a, const Vec3& b) {
        for (int i = 0; i <= 4; ++i)
            if (const int door = door_at(a + (b - a) * (0.25 * i)); door >= 0) return door;
        return -1;
    };
    std::deque<std::pair<int, int>> open{{kHalf, kHalf}};
    all.free[index(kHalf, kHalf)] = true;
    std::size_t cells = 1;
    constexpr std::array kWays{std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)};
    while (!open.empty()) {
        const auto [cx, cy] = open.front();
        open.pop_front();
        const double z = feet_m.z + static_cast<double>(height[index(cx, cy)]);
        for (const auto& [dx, dy] : kWays) {
            const int x = cx + dx, y = cy + dy;
            if (x < 0 || y < 0 || x >= kWide || y >= kWide || cells >= kMostCells) {
                all.whole = false;
                continue;
            }
            if (all.free[index(x, y)]) continue;
            Vec3 from = all.middle_m(cx, cy), to = all.middle_m(x, y);
            from.z = to.z = z;
            if (passes_door(from, to) >= 0) continue;
            const Vec3 up(0.0, 0.0, lift);
            if (world.trace(from + up, to + up, column).hit || world.blocked(to + up, column)) continue;
            const TraceHit ground = world.trace(to + up, to - Vec3(0.0, 0.0, body.step_up_m + 0.05), BodyShape{});
            if (!ground.hit || ground.normal.z < 0.7 || std::abs(ground.end_m.z - feet_m.z) > kSameFloor_m) continue;
            all.free[index(x, y)] = true;
            height[index(x, y)] = static_cast<float>(ground.end_m.z - feet_m.z);
            ++cells;
            open.emplace_back(x, y);
        }
    }
    // 2. What is outside: cells that are not free and hang together with the rim.
    std::vector<bool> outside(all.free.size());
    std::deque<std::pair<int, int>> rim;
    const auto take = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= kWide || y >= kWide || all.free[index(x, y)] || outside[index(x, y)]) return;
        outside[index(x, y)] = true;
        rim.emplace_back(x, y);
    };
    for (int i = 0; i < kWide; ++i) take(i, 0), take(i, kWide - 1), take(0, i), take(kWide - 1, i);
    while (!rim.empty()) {
        const auto [cx, cy] = rim.front();
        rim.pop_front();
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) take(cx + dx, cy + dy);
    }
    // 3. The boundary between the two, by what bounds it.
    for (int y = 0; y < kWide; ++y)
        for (int x = 0; x < kWide; ++x) {
            if (!all.free[index(x, y)]) continue;
            for (const auto& [dx, dy] : kWays) {
                const int nx = x + dx, ny = y + dy;
                if (nx < 0 || ny < 0 || nx >= kWide || ny >= kWide || all.free[index(nx, ny)] || !outside[index(nx, ny)]) continue;
                Vec3 from = all.middle_m(x, y);
                from.z = feet_m.z + static_cast<double>(height[index(x, y)]);
                const Vec3 way(dx, dy, 0.0);
                WallSample sample{from + way * (0.5 * Place::kCell_m), -way, kNoFeature, Place::kCell_m};
                if (const int door = passes_door(from, from + way * Place::kCell_m); door >= 0) {
                    sample.feature = door_features[static_cast<std::size_t>(door)];
                } else {
                    const Vec3 up(0.0, 0.0, lift);
                    const TraceHit hit = world.trace(from + up, from + up + way * (1.6 * Place::kCell_m), column);
                    if (!hit.hit || !hit.feature) continue;  // a fall, or the end of what is looked at
                    sample.feature = hit.feature;
                    sample.point_m = Vec3(hit.end_m.x, hit.end_m.y, from.z);
                    if (const double level = std::sqrt(hit.normal.x * hit.normal.x + hit.normal.y * hit.normal.y); level > 0.7) {
                        sample.normal = Vec3(hit.normal.x / level, hit.normal.y / level, 0.0);
                        sample.length_m *= std::abs(glm::dot(sample.normal, way));
                    }
                }
                all.walls.push_back(sample);
            }
        }
    // 4. Cut to what is free.
    int x0 = kWide, y0 = kWide, x1 = -1, y1 = -1;
    for (int y = 0; y < kWide; ++y)
        for (int x = 0; x < kWide; ++x)
            if (all.free[index(x, y)]) x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
    Place cut;
    cut.origin_m = all.origin_m + Vec3(x0 * Place::kCell_m, y0 * Place::kCell_m, 0.0);
    cut.wide = x1 - x0 + 1;
    cut.deep = y1 - y0 + 1;
    cut.whole = all.whole;
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) cut.free.push_back(all.free[index(x, y)]);
    cut.walls = std::move(all.walls);
    return cut;
}

Progress progress_of(const Place& place, const LearningNotes& notes, const Scene& scene) {
    Progress progress;
    const std::vector<bool> known = known_walls(place, notes);
    for (std::size_t i = 0; i < place.walls.size(); ++i) {
        const FeatureId feature = place.walls[i].feature;
        auto wall = std::find_if(progress.walls.begin(), progress.walls.end(), [&](const WallProgress& w) { return w.feature == feature; });
        if (wall == progress.walls.end()) wall = progress.walls.insert(progress.walls.end(), WallProgress{feature});
        const double length_m = place.walls[i].length_m;
        wall->length_m += length_m;
        progress.perimeter_m += length_m;
        if (!known[i]) continue;
        wall->touched_m += length_m;
        progress.touched_m += length_m;
    }
    for (const WallProgress& wall : progress.walls)
        if (const Feature* feature = scene.find(wall.feature); feature && feature->kind == FeatureKind::Door) {
            ++progress.doors;
            progress.doors_found += wall.touched_m > 0.0;
        }
    const std::vector<bool> walked = walked_cells(place, notes, kFloorReach_m);
    progress.floor_m2 = place.area_m2();
    progress.walked_m2 = static_cast<double>(std::count(walked.begin(), walked.end(), true)) * Place::kCell_m * Place::kCell_m;
    return progress;
}

std::optional<Unexplored> nearest_unexplored(const Place& place, const LearningNotes& notes, const Vec3& feet_m) {
    std::optional<Unexplored> nearest;
    double nearest_m = 1e9;
    const auto offer = [&](const Vec3& point, bool wall, FeatureId feature) {
        const double distance = std::hypot(point.x - feet_m.x, point.y - feet_m.y);
        if (distance >= nearest_m) return;
        nearest_m = distance;
        nearest = Unexplored{point, wall, feature};
    };
    const std::vector<bool> known = known_walls(place, notes);
    for (std::size_t i = 0; i < place.walls.size(); ++i) {
        if (known[i]) continue;
        int beside = 0;  // of the same stretch
        for (std::size_t k = 0; k < place.walls.size(); ++k)
            beside += !known[k] && place.walls[k].feature == place.walls[i].feature && glm::length(place.walls[k].point_m - place.walls[i].point_m) < 0.45;
        if (beside >= 5) offer(place.walls[i].point_m, true, place.walls[i].feature);
    }
    const std::vector<bool> walked = walked_cells(place, notes, kFloorReach_m);
    std::vector<bool> seen(place.free.size());
    for (int y = 0; y < place.deep; ++y)
        for (int x = 0; x < place.wide; ++x) {
            const auto at = [&](int cx, int cy) { return static_cast<std::size_t>(cy * place.wide + cx); };
            if (!place.is_free(x, y) || walked[at(x, y)] || seen[at(x, y)]) continue;
            std::vector<std::pair<int, int>> patch{{x, y}};
            seen[at(x, y)] = true;
            for (std::size_t i = 0; i < patch.size(); ++i)
                for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
                    const int nx = patch[i].first + dx, ny = patch[i].second + dy;
                    if (!place.is_free(nx, ny) || walked[at(nx, ny)] || seen[at(nx, ny)]) continue;
                    seen[at(nx, ny)] = true;
                    patch.emplace_back(nx, ny);
                }
            if (static_cast<double>(patch.size()) * Place::kCell_m * Place::kCell_m < 0.5) continue;
            for (const auto& [px, py] : patch) offer(place.middle_m(px, py), false, kNoFeature);
        }
    return nearest;
}

std::vector<Lane> lanes_of(const Place& place, const LearningNotes& notes) {
    const std::vector<bool> walked = walked_cells(place, notes, kLaneOff_m);
    std::vector<Lane> lanes;
    for (const bool north : {true, false}) {
        const int across = north ? place.wide : place.deep, along = north ? place.deep : place.wide;
        const double span_m = across * Place::kCell_m;
        const int count = std::max(1, static_cast<int>(std::lround(span_m / kLane_m)));
        for (int i = 0; i < count; ++i) {
            const int c = static_cast<int>((i + 0.5) * across / count);
            Lane lane{north, (north ? place.origin_m.x : place.origin_m.y) + (c + 0.5) * Place::kCell_m, 0.0, 0.0};
            for (int k = 0; k < along; ++k) {
                const int x = north ? c : k, y = north ? k : c;
                if (!place.is_free(x, y)) continue;
                lane.length_m += Place::kCell_m;
                if (walked[static_cast<std::size_t>(y * place.wide + x)]) lane.walked_m += Place::kCell_m;
            }
            if (lane.length_m > 0.5) lanes.push_back(lane);
        }
    }
    return lanes;
}

}  // namespace handrail
