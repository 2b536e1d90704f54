// Makes the Place of learning.h from a room: its floor as a grid, with the walls around it. The app thread calls this
// code.
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "app/core/learning/learning.h"
#include "app/core/learning/place_cells.h"
#include "worlds/base/contract.h"
#include "worlds/geometry/clip.h"

namespace handrail::core {
namespace {

constexpr double kFinest_m = 0.05;  // width of a cell; with it, the measured length of a 4 m wall is exact within 1.3 %
// Largest number of cells in a place; a hall of 40 by 25 m has this many cells of kFinest_m.
constexpr std::size_t kMostCells = 400'000;

// The doors near a room.
class Doors {
public:
    Doors(const Scene& scene, const Aabb& near) {
        for (std::uint32_t i = 0; i < scene.features.size(); ++i)
            if (const Feature& feature = scene.features[i];
                feature.kind == FeatureKind::Door && !feature.bounds_m.empty() && overlap(feature.bounds_m, near))
                doors_.emplace_back(feature.bounds_m, FeatureId{i});
    }
    // Returns the door that the short line from `a` to `b` crosses. A leaf may be thinner than a cell, so several
    // points of the line are tested.
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

std::vector<PlaceExit> exits_of_place(const Scene& scene, const navigation::RoomGraph& graph, std::uint32_t room,
                                      const std::vector<WallSample>& walls) {
    std::vector<PlaceExit> exits;
    for (const navigation::Portal& portal : graph.portals) {
        if (portal.kind == navigation::PassageKind::Drop ||
            (portal.rooms[0] != room && (portal.one_way || portal.rooms[1] != room)))
            continue;
        PlaceExit exit{{}, portal.place_m, portal.width_m, portal.kind == navigation::PassageKind::Door};
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

// Makes the place of a room. place_of_room() calls the public functions in the order in which they are declared here.
class PlaceMaker {
public:
    PlaceMaker(const WalkerWorld& world, const navigation::WalkSpace& space, const navigation::RoomGraph& graph,
               std::uint32_t room)
        : world_(world), space_(space), graph_(graph), room_(room) {}

    // Makes the grid. Its cells are those of the walk space, subdivided if they are coarse, plus a margin that the room
    // does not reach. Returns false if the room has no cells.
    bool lay_cells();
    // Assigns each cell where a walker can stand to this room or to another one.
    void share_out();
    // Extends all rooms towards the walls at the same pace, so that a strip of floor along a wall belongs to the nearer
    // room.
    void grow_to_walls(const Doors& doors);
    // Finds the cells outside: those that do not belong to the room and are connected to the margin.
    void find_outside();
    // Finds the boundary between the room and the outside, and the feature at each part of it.
    void find_walls(const Doors& doors);
    // Returns the doors near the cells.
    Doors doors_around() const;
    Place take() { return std::move(place_); }

private:
    enum Owner : std::uint8_t { Nobody, Own, Other };

    std::pair<int, int> column_of(std::uint32_t span) const {
        return {static_cast<int>(space_.spans[span].cell % space_.width),
                static_cast<int>(space_.spans[span].cell / space_.width)};
    }
    bool of_room(std::uint32_t span) const { return graph_.room_of_span[span] == room_; }
    // Returns true if the place `span` is part of a room. Places in a doorway are not, unless the room consists only of
    // a doorway.
    bool counts(std::uint32_t span) const {
        return space_.spans[span].door == navigation::kNothing || (doorway_ && of_room(span));
    }
    bool is_in(int x, int y) const { return x >= 0 && y >= 0 && x < place_.wide && y < place_.deep; }
    int merged_from(int at, int first) const {
        const int off = at - first;
        return ((off >= 0 ? off : off - merged_ + 1) / merged_ + margin_) * cut_;
    }
    bool measure_room();
    bool fits();
    void give(std::uint32_t span, bool own);
    bool floor_goes_on(const Doors& doors, std::size_t here, int cx, int cy, int dx, int dy);
    std::optional<WallSample> wall_at_side(int x, int y, int dx, int dy, const Doors& doors) const;

    const WalkerWorld& world_;
    const navigation::WalkSpace& space_;
    const navigation::RoomGraph& graph_;
    const std::uint32_t room_;
    const navigation::WalkerMeasures& body_ = space_.body;
    const WalkerShape column_{0.0, body_.height_m - body_.step_up_m - 0.1};
    const Vec3 up_{0.0, 0.0, body_.step_up_m + 0.02};
    // Distance from the nearest place where the walker's centre can be to the tip of a corner.
    const double reach_m_ = 1.5 * body_.radius_m;
    bool doorway_ = true;
    int x0_ = static_cast<int>(space_.width), y0_ = static_cast<int>(space_.depth), x1_ = -1, y1_ = -1;
    double lowest_m_ = 1e9, highest_m_ = -1e9;
    // Each cell of the walk space is divided `cut_` times in both directions, or else `merged_` cells in each direction
    // are combined.
    int cut_ = 1, merged_ = 1, margin_ = 0;
    Place place_;
    std::vector<std::uint8_t> owner_;
    std::vector<std::uint32_t> seed_;  // for each cell, the cell from which the floor was extended to it
    std::vector<bool> solid_, outside_;
};

bool PlaceMaker::measure_room() {
    for (std::uint32_t s = 0; s < space_.spans.size() && doorway_; ++s)
        doorway_ = !of_room(s) || space_.spans[s].door != navigation::kNothing;
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
    // A huge place gets coarser cells, so that examining it takes no longer than examining a large one.
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

void PlaceMaker::grow_to_walls(const Doors& doors) {
    std::deque<std::pair<int, int>> open;
    for (int y = 0; y < place_.deep; ++y)
        for (int x = 0; x < place_.wide; ++x)
            if (owner_[place_.at(x, y)] != Nobody) open.emplace_back(x, y);
    while (!open.empty()) {
        const auto [cx, cy] = open.front();
        open.pop_front();
        const std::size_t here = place_.at(cx, cy);
        for (const auto& [dx, dy] : kCellWays)
            if (is_in(cx + dx, cy + dy) && floor_goes_on(doors, here, cx, cy, dx, dy))
                open.emplace_back(cx + dx, cy + dy);
    }
    for (std::size_t i = 0; i < place_.free.size(); ++i) place_.free[i] = owner_[i] == Own;
}

// Extends the floor from cell `here` to its neighbour, which then belongs to the same room. Returns false if there is
// no floor.
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
    const TraceHit ground = world_.trace(to + up_, to - Vec3(0.0, 0.0, body_.step_up_m + 0.05), WalkerShape{});
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

void PlaceMaker::find_walls(const Doors& doors) {
    for (int y = 0; y < place_.deep; ++y)
        for (int x = 0; x < place_.wide; ++x) {
            if (!place_.free[place_.at(x, y)]) continue;
            for (const auto& [dx, dy] : kCellWays)
                if (outside_[place_.at(x + dx, y + dy)])
                    if (const auto wall = wall_at_side(x, y, dx, dy, doors)) place_.walls.push_back(*wall);
        }
    place_.exits = exits_of_place(world_.scene(), graph_, room_, place_.walls);
}

// Returns the piece of wall between a cell and its neighbour. Returns no value if there is a drop or another room.
std::optional<WallSample> PlaceMaker::wall_at_side(int x, int y, int dx, int dy, const Doors& doors) const {
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

Place place_of_room(const WalkerWorld& world, const navigation::WalkSpace& space, const navigation::RoomGraph& graph,
                    std::uint32_t room) {
    contract_pre(room < graph.rooms.size());
    contract_pre(graph.room_of_span.size() == space.spans.size());
    PlaceMaker maker(world, space, graph, room);
    if (maker.lay_cells()) {
        maker.share_out();
        const Doors doors = maker.doors_around();
        maker.grow_to_walls(doors);
        maker.find_outside();
        maker.find_walls(doors);
    }
    return maker.take();
}

}  // namespace handrail::core
