#include "app/core/learning/learning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>

#include "worlds/base/contract.h"
#include "worlds/geometry/clip.h"

namespace handrail {
namespace {

constexpr std::size_t kMostNotes = 1000000;  // 40 km of new ground; later ones are not kept
constexpr double kSpot_m = 0.04;
constexpr double kFinest_m = 0.05;           // cells: a wall of 4 m is then as long as it is within 1.3 %
constexpr std::size_t kMostCells = 400'000;  // of one place; a hall of 40 by 25 m has as many of the finest
constexpr double kLane_m = 1.0, kLaneOff_m = 0.4;
constexpr double kSameFloor_m = 0.6, kRoomHeight_m = 2.6;
constexpr double kNormalOff_m = 0.3;  // a hand above a radiator touches the wall behind it
constexpr double kLeastWall_m = 0.2;  // the jamb of a door is part of the perimeter, but no wall to be told of
constexpr double kUnknown_m = 0.45;   // of wall, around one sample
constexpr double kThrough_m = 0.3;    // of a door's middle: gone through; walking along its wall passes farther off
constexpr std::array kWays{std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)};

// Of places a few centimetres apart and, for touches, which of eight ways the wall faces; 0 for steps.
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

// Where the leaves of doors hang.
class Doors {
public:
    Doors(const Scene& scene, const Aabb& near) {
        for (std::uint32_t i = 0; i < scene.features.size(); ++i)
            if (const Feature& feature = scene.features[i];
                feature.kind == FeatureKind::Door && !feature.bounds_m.empty() && overlap(feature.bounds_m, near))
                doors_.emplace_back(feature.bounds_m, FeatureId{i});
    }
    // The door on the short way from one place to another. A leaf may be thinner than a cell, so the way is looked at.
    FeatureId between(const Vec3& a, const Vec3& b) const {
        for (int i = 0; i <= 4; ++i) {
            const Vec3 p = a + (b - a) * (0.25 * i);
            for (const auto& [box, feature] : doors_)
                if (p.x > box.min_m.x && p.x < box.max_m.x && p.y > box.min_m.y && p.y < box.max_m.y &&
                    p.z + 1.0 > box.min_m.z && p.z < box.max_m.z)
                    return feature;
        }
        return kNoFeature;
    }

private:
    std::vector<std::pair<Aabb, FeatureId>> doors_;
};

// The samples of a boundary that nobody knows yet, by squares as wide as what lies around one sample.
class UnknownWalls {
public:
    explicit UnknownWalls(const Learnt& learnt) : walls_(learnt.place().walls) {
        for (std::uint32_t i = 0; i < walls_.size(); ++i)
            if (!learnt.knows_wall(i)) squares_[square_of(walls_[i].point_m, 0, 0)].push_back(i);
    }
    // How much of the same stretch is unknown around that sample.
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

std::vector<PlaceExit> exits_of_place(const Scene& scene, const RoomGraph& graph, std::uint32_t room,
                                      const std::vector<WallSample>& walls) {
    std::vector<PlaceExit> exits;
    for (const Portal& portal : graph.portals) {
        if (portal.kind == PassageKind::Drop ||
            (portal.rooms[0] != room && (portal.one_way || portal.rooms[1] != room)))
            continue;
        PlaceExit exit{{}, portal.place_m, portal.width_m, portal.kind == PassageKind::Door};
        if (portal.feature) exit.features.push_back(portal.feature);
        const auto own = std::find_if(scene.movers.begin(), scene.movers.end(),
                                      [&](const Mover& mover) { return mover.feature == portal.feature; });
        if (own != scene.movers.end())
            for (const Mover& leaf : scene.movers)
                if (leaf.group == own->group && leaf.feature != portal.feature) exit.features.push_back(leaf.feature);
        exits.push_back(std::move(exit));
    }
    for (const WallSample& wall : walls) {
        const Feature* feature = scene.find(wall.feature);
        if (!feature || feature->kind != FeatureKind::Door) continue;
        const bool known = std::any_of(exits.begin(), exits.end(), [&](const PlaceExit& exit) {
            return std::find(exit.features.begin(), exit.features.end(), wall.feature) != exit.features.end();
        });
        if (!known) exits.push_back({{wall.feature}, feature->bounds_m.centre_m(), 0.0, true});
    }
    return exits;
}

}  // namespace

void LearningNotes::touched(const Vec3& point_m, const Vec3& normal, double reach_m) {
    contract_pre(is_finite(point_m) && is_finite(normal));
    contract_pre(reach_m >= 0.0);
    const double length = std::sqrt(normal.x * normal.x + normal.y * normal.y);
    if (length < 0.7 || count() >= kMostNotes) return;  // floor or ceiling
    const Vec3 level(normal.x / length, normal.y / length, 0.0);
    const double reach = std::max(reach_m, kSpot_m);  // neighbouring spots leave no gap
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

namespace {

// Makes the place of a room, in the order of place_of_room().
class PlaceMaker {
public:
    PlaceMaker(const BodyWorld& world, const WalkSpace& space, const RoomGraph& graph, std::uint32_t room)
        : world_(world), space_(space), graph_(graph), room_(room) {}

    // The cells: those of the walk space, cut finer where they are coarse, with a rim that nothing of the room reaches.
    // False: the room has none.
    bool lay_cells();
    // Whose each cell is: first where a body stands in this room, else in another one.
    void share_out();
    // From there to the walls, both at the same pace, so that a strip of floor along a wall goes to the nearer one.
    void grow_to_walls();
    // What is outside: cells that are not the room's and hang together with the rim.
    void find_outside();
    // The boundary between the two, by what bounds it.
    void find_walls();
    Place take() { return std::move(place_); }

private:
    enum Owner : std::uint8_t { Nobody, Own, Other };

    std::pair<int, int> column_of(std::uint32_t span) const {
        return {static_cast<int>(space_.spans[span].cell % space_.width),
                static_cast<int>(space_.spans[span].cell / space_.width)};
    }
    bool of_room(std::uint32_t span) const { return graph_.room_of_span[span] == room_; }
    // A door's own places belong to it; a room that is nothing but a doorway has no others.
    bool counts(std::uint32_t span) const { return space_.spans[span].door == kNothing || (doorway_ && of_room(span)); }
    bool is_in(int x, int y) const { return x >= 0 && y >= 0 && x < place_.wide && y < place_.deep; }
    int merged_from(int at, int first) const {
        const int off = at - first;
        return ((off >= 0 ? off : off - merged_ + 1) / merged_ + margin_) * cut_;
    }
    bool measure_room();
    bool fits();
    void give(std::uint32_t span, bool own);
    bool floor_goes_on(const Doors& doors, std::size_t here, int cx, int cy, int dx, int dy);
    std::optional<WallSample> wall_beside(int x, int y, int dx, int dy, const Doors& doors) const;
    Doors doors_around() const;

    const BodyWorld& world_;
    const WalkSpace& space_;
    const RoomGraph& graph_;
    const std::uint32_t room_;
    const WalkBody& body_ = space_.body;
    const BodyShape column_{0.0, body_.height_m - body_.step_up_m - 0.1};
    const Vec3 up_{0.0, 0.0, body_.step_up_m + 0.02};
    const double reach_m_ = 1.5 * body_.radius_m;  // from where the middle of the body can be into a corner
    bool doorway_ = true;
    int x0_ = static_cast<int>(space_.width), y0_ = static_cast<int>(space_.depth), x1_ = -1, y1_ = -1;
    double lowest_m_ = 1e9, highest_m_ = -1e9;
    // Finer than the cells of the walk space by `cut_`, or as wide as `merged_` of them.
    int cut_ = 1, merged_ = 1, margin_ = 0;
    Place place_;
    std::vector<std::uint8_t> owner_;
    std::vector<std::uint32_t> seed_;  // the cell it was reached from
    std::vector<bool> solid_, outside_;
};

bool PlaceMaker::measure_room() {
    for (std::uint32_t s = 0; s < space_.spans.size() && doorway_; ++s)
        doorway_ = !of_room(s) || space_.spans[s].door != kNothing;
    for (std::uint32_t s = 0; s < space_.spans.size(); ++s) {
        if (!of_room(s) || !counts(s)) continue;
        const auto [x, y] = column_of(s);
        x0_ = std::min(x0_, x), x1_ = std::max(x1_, x), y0_ = std::min(y0_, y), y1_ = std::max(y1_, y);
        lowest_m_ = std::min(lowest_m_, space_.place_m(s).z), highest_m_ = std::max(highest_m_, space_.place_m(s).z);
    }
    return x1_ >= 0;
}

bool PlaceMaker::fits() {
    margin_ = static_cast<int>(std::ceil(reach_m_ / (merged_ * space_.cell_m))) + 2;
    place_.wide = ((x1_ - x0_) / merged_ + 1 + 2 * margin_) * cut_;
    place_.deep = ((y1_ - y0_) / merged_ + 1 + 2 * margin_) * cut_;
    return static_cast<std::size_t>(place_.wide) * static_cast<std::size_t>(place_.deep) <= kMostCells;
}

bool PlaceMaker::lay_cells() {
    if (!measure_room()) return false;
    // A huge place has coarser cells, so that looking at it takes no longer than a large one.
    cut_ = std::max(1, static_cast<int>(std::ceil(space_.cell_m / kFinest_m - 1e-6)));
    while (!fits()) cut_ > 1 ? --cut_ : ++merged_;
    place_.cell_m = space_.cell_m * merged_ / cut_;
    place_.origin_m = Vec3(space_.origin_m.x + (x0_ - margin_ * merged_) * space_.cell_m,
                           space_.origin_m.y + (y0_ - margin_ * merged_) * space_.cell_m, graph_.rooms[room_].floor_m);
    const std::size_t cells = static_cast<std::size_t>(place_.wide) * static_cast<std::size_t>(place_.deep);
    place_.free.assign(cells, false);
    place_.height_m.assign(cells, 0.0F);
    owner_.assign(cells, Nobody);
    seed_.assign(cells, 0);
    solid_.assign(cells, false);
    outside_.assign(cells, false);
    return true;
}

void PlaceMaker::share_out() {
    for (const bool own : {true, false})
        for (std::uint32_t s = 0; s < space_.spans.size(); ++s)
            if (of_room(s) == own && counts(s)) give(s, own);
}

void PlaceMaker::give(std::uint32_t span, bool own) {
    const auto [cx, cy] = column_of(span);
    const int x = merged_from(cx, x0_), y = merged_from(cy, y0_);
    const double z = space_.place_m(span).z;
    if (!is_in(x, y) || z < lowest_m_ - kSameFloor_m || z > highest_m_ + kSameFloor_m) return;
    for (int dy = 0; dy < cut_; ++dy)
        for (int dx = 0; dx < cut_; ++dx) {
            const std::size_t i = place_.at(x + dx, y + dy);
            if (owner_[i] != Nobody) continue;
            owner_[i] = own ? Own : Other;
            seed_[i] = static_cast<std::uint32_t>(i);
            place_.height_m[i] = static_cast<float>(z - place_.origin_m.z);
        }
}

Doors PlaceMaker::doors_around() const {
    const Vec3 low(0.0, 0.0, lowest_m_ - place_.origin_m.z - kRoomHeight_m);
    const Vec3 high(place_.wide * place_.cell_m, place_.deep * place_.cell_m,
                    highest_m_ - place_.origin_m.z + kRoomHeight_m);
    return Doors(world_.scene(), Aabb{place_.origin_m + low, place_.origin_m + high});
}

void PlaceMaker::grow_to_walls() {
    const Doors doors = doors_around();
    std::deque<std::pair<int, int>> open;
    for (int y = 0; y < place_.deep; ++y)
        for (int x = 0; x < place_.wide; ++x)
            if (owner_[place_.at(x, y)] != Nobody) open.emplace_back(x, y);
    while (!open.empty()) {
        const auto [cx, cy] = open.front();
        open.pop_front();
        const std::size_t here = place_.at(cx, cy);
        for (const auto& [dx, dy] : kWays)
            if (is_in(cx + dx, cy + dy) && floor_goes_on(doors, here, cx, cy, dx, dy))
                open.emplace_back(cx + dx, cy + dy);
    }
    for (std::size_t i = 0; i < place_.free.size(); ++i) place_.free[i] = owner_[i] == Own;
}

// From a cell to the next one that way, which then has the same owner.
bool PlaceMaker::floor_goes_on(const Doors& doors, std::size_t here, int cx, int cy, int dx, int dy) {
    const int x = cx + dx, y = cy + dy;
    const std::size_t there = place_.at(x, y);
    if (owner_[there] != Nobody || solid_[there]) return false;
    const auto wide = static_cast<std::uint32_t>(place_.wide);
    const double way_x = x - static_cast<double>(seed_[here] % wide),
                 way_y = y - static_cast<double>(seed_[here] / wide);
    if (std::hypot(way_x, way_y) * place_.cell_m > reach_m_) return false;
    const Vec3 from = place_.middle_m(cx, cy), to = from + Vec3(dx * place_.cell_m, dy * place_.cell_m, 0.0);
    if (doors.between(from, to)) return false;
    if (world_.blocked(to + up_, column_)) {
        solid_[there] = true;
        return false;
    }
    if (world_.trace(from + up_, to + up_, column_).hit) return false;
    const TraceHit ground = world_.trace(to + up_, to - Vec3(0.0, 0.0, body_.step_up_m + 0.05), BodyShape{});
    if (!ground.hit || ground.normal.z < 0.7) return false;
    owner_[there] = owner_[here];
    seed_[there] = seed_[here];
    place_.height_m[there] = static_cast<float>(ground.end_m.z - place_.origin_m.z);
    return true;
}

void PlaceMaker::find_outside() {
    std::deque<std::pair<int, int>> open;
    const auto take = [&](int x, int y) {
        if (!is_in(x, y) || place_.free[place_.at(x, y)] || outside_[place_.at(x, y)]) return;
        outside_[place_.at(x, y)] = true;
        open.emplace_back(x, y);
    };
    take(0, 0);
    while (!open.empty()) {
        const auto [cx, cy] = open.front();
        open.pop_front();
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) take(cx + dx, cy + dy);
    }
}

void PlaceMaker::find_walls() {
    const Doors doors = doors_around();
    for (int y = 0; y < place_.deep; ++y)
        for (int x = 0; x < place_.wide; ++x) {
            if (!place_.free[place_.at(x, y)]) continue;
            for (const auto& [dx, dy] : kWays)
                if (outside_[place_.at(x + dx, y + dy)])
                    if (const auto wall = wall_beside(x, y, dx, dy, doors)) place_.walls.push_back(*wall);
        }
    place_.exits = exits_of_place(world_.scene(), graph_, room_, place_.walls);
}

// None: a fall, or another room.
std::optional<WallSample> PlaceMaker::wall_beside(int x, int y, int dx, int dy, const Doors& doors) const {
    const Vec3 from = place_.middle_m(x, y), way(dx, dy, 0.0);
    WallSample sample{from + way * (0.5 * place_.cell_m), -way, doors.between(from, from + way * place_.cell_m),
                      place_.cell_m};
    if (sample.feature) return sample;
    const TraceHit hit = world_.trace(from + up_, from + up_ + way * (1.6 * place_.cell_m), column_);
    if (!hit.hit || !hit.feature) return std::nullopt;
    sample.feature = hit.feature;
    sample.point_m = Vec3(hit.end_m.x, hit.end_m.y, from.z);
    if (const double level = std::sqrt(hit.normal.x * hit.normal.x + hit.normal.y * hit.normal.y); level > 0.7) {
        sample.normal = Vec3(hit.normal.x / level, hit.normal.y / level, 0.0);
        sample.length_m *= std::abs(glm::dot(sample.normal, way));
    }
    return sample;
}

}  // namespace

Place place_of_room(const BodyWorld& world, const WalkSpace& space, const RoomGraph& graph, std::uint32_t room) {
    contract_pre(room < graph.rooms.size());
    contract_pre(graph.room_of_span.size() == space.spans.size());
    PlaceMaker maker(world, space, graph, room);
    if (maker.lay_cells()) {
        maker.share_out();
        maker.grow_to_walls();
        maker.find_outside();
        maker.find_walls();
    }
    return maker.take();
}

Learnt::Learnt(Place place)
    : place_(std::move(place)),
      known_(place_.walls.size(), false),
      walked_(place_.free.size(), false),
      beside_(place_.free.size(), false),
      gone_to_(place_.exits.size(), false) {}

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
            if (std::abs(off.z) < kRoomHeight_m && std::hypot(off.x, off.y) <= near_m) gone_to_[i] = true;
        }
    }
}

bool Learnt::found(const PlaceExit& exit) const {
    if (gone_to_[static_cast<std::size_t>(&exit - place_.exits.data())]) return true;
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
        // Only what would be nearer is looked at.
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
                for (const auto& [dx, dy] : kWays) {
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
    // Of what is the room's: the grid has a rim around it.
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

}  // namespace handrail
