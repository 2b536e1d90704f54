#include "worlds/navigation/walk_flood.h"
#include "worlds/scene/stated_building.h"

#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <limits>
#include <utility>

namespace handrail::navigation {
namespace {

constexpr double kWading_m = 0.3;  // a walker is in a liquid if the liquid is deeper than this

bool lies_in(const Aabb& box, const Vec3& at) {
    return glm::all(glm::lessThanEqual(box.min_m, at)) && glm::all(glm::lessThanEqual(at, box.max_m));
}

bool wades(const std::vector<const Solid*>& liquids, const std::vector<std::uint32_t>& near, const Vec3& feet) {
    return std::any_of(near.begin(), near.end(),
                       [&](std::uint32_t k) { return contains(liquids[k]->shape, feet + Vec3(0.0, 0.0, kWading_m)); });
}

}  // namespace

Flood::Flood(const Scene& scene, const WalkerMeasures& body, const Obstacles& obstacles, const NearGround& ground,
             bool partly, const std::stop_token& stop, const WalkTrial* trial)
    : scene_(scene),
      body_(body),
      obstacles_(obstacles),
      stop_(stop),
      trial_(trial),
      partly_(partly),
      tiles_(scene, body, obstacles, ground) {}

Flood::End Flood::run() {
    seed();
    End end = spread_all();
    if (end == End::Done && !trial_ && !part_) end = reach_closed_rooms();
    if (end == End::Done) tiles_.drop_unreached();
    return end;
}

Flood::End Flood::spread_all() {
    while (!waiting_.empty()) {
        const std::uint32_t tile = waiting_.front();
        waiting_.pop_front();
        tiles_[tile].waits = false;
        if (const End end = spread(tile); end != End::Done) return end;
    }
    return stop_.stop_requested() ? End::Stopped : End::Done;
}

// Spreads from all waiting places of one tile up to the tile's borders.
Flood::End Flood::spread(std::uint32_t number) {
    while (!tiles_[number].open.empty()) {
        if (stopped()) return End::Stopped;
        const Spot spot = tiles_[number].open.back();
        tiles_[number].open.pop_back();
        Extent& extent = layers_[spot.layer];
        full_ = full_ || ++extent.reached > most_spans(body_.cell_m) || tiles_.bytes() > kMostBytes;
        if (!partly_ && (full_ || part_)) return End::TooLarge;
        const Tile& tile = tiles_[number];
        const Place here = tile.places[spot.place];
        const Cell cell{tile.x * WalkTiles::kTile + spot.cell % WalkTiles::kTile,
                        tile.y * WalkTiles::kTile + spot.cell / WalkTiles::kTile};
        Steps steps;
        for (std::size_t d = 0; d < 4; ++d) {
            const Cell to = WalkTiles::neighbour(cell, static_cast<int>(d));
            const std::uint32_t other = steps.tile[d] = tiles_.beside(number, spot.cell, static_cast<int>(d));
            const std::size_t at = WalkTiles::local(to);
            std::uint32_t k = tiles_.step(here, tiles_[other], at, spot.layer);
            if (k != kNothing && !is_within(tiles_[other].places[k], to)) k = kNothing;
            const bool walks = k != kNothing;
            if (walks && !visit(spot.layer, other, k, to)) k = kNothing;
            steps.place[d] = k;
            if (walks) {
                if (k != kNothing) tiles_[number].steps[spot.place] |= WalkTiles::step_bit(spot.layer, d);
            } else if (const std::uint32_t down = drop(here, other, to, spot.layer); down != kNothing)
                visit(spot.layer, other, down, to);
        }
        // A walker on a lift also reaches all stops of that lift.
        if (here.ground != kNothing && here.ground >= obstacles_.all.size()) {
            const PassingFloor& floor = obstacles_.passing[here.ground - obstacles_.all.size()];
            const Range range = WalkTiles::column(tile, spot.cell, spot.layer);
            if (scene_.features[floor.shape.feature.value].kind == FeatureKind::Lift)
                for (std::uint32_t k = range.from; k < range.to; ++k)
                    if (k != spot.place && tiles_.passing_mover(tile.places[k].ground) == static_cast<int>(floor.mover))
                        visit(spot.layer, number, k, cell);
        }
        if (spot.layer == kFurnished && !trial_) look_at_neighbour(number, spot, steps);
    }
    return End::Done;
}

bool Flood::is_within(const Place& place, Cell cell) const {
    return !trial_ || !trial_->within || lies_in(trial_->within->box_m, Vec3(tiles_.middle(cell), place.floor));
}

// Returns the place on which a walker lands after stepping over the edge into a cell of that tile.
std::uint32_t Flood::drop(const Place& here, std::uint32_t tile, Cell to, Layer layer) const {
    const std::uint32_t down = tiles_.drop(here, tiles_[tile], WalkTiles::local(to), layer);
    return down != kNothing && is_within(tiles_[tile].places[down], to) ? down : kNothing;
}

// Finds the obstacle that blocks the walker in each direction in which no step is possible. A part of the building
// takes precedence over objects in it.
void Flood::look_at_neighbour(std::uint32_t number, const Spot& spot, const Steps& steps) {
    const Tile& tile = tiles_[number];
    const Place here = tile.places[spot.place];
    std::uint32_t found = kNothing;
    bool near_edge = false;
    for (std::size_t d = 0; d < 4; ++d) {
        const std::uint32_t other = steps.tile[d], k = steps.place[d];
        if (k != kNothing &&
            tiles_.leads_back(tile, spot.cell, spot.place, std::as_const(tiles_)[other].places[k], kFurnished))
            continue;
        const std::size_t at =
            WalkTiles::local(WalkTiles::neighbour({tile.x * WalkTiles::kTile + spot.cell % WalkTiles::kTile,
                                                   tile.y * WalkTiles::kTile + spot.cell / WalkTiles::kTile},
                                                  static_cast<int>(d)));
        const WalkTiles::Columns& columns = tiles_.columns_of(other);
        std::uint32_t blocker = kNothing;
        for (std::uint32_t i = columns.first[at]; i < columns.first[at + 1]; ++i) {
            const WalkTiles::Interval& interval = columns.intervals[i];
            if (interval.low >= here.floor + 0.01 || interval.high <= here.floor + kWalkRounding_m) continue;
            if (blocker == kNothing || (!tiles_.is_building(blocker) && tiles_.is_building(interval.obstacle)))
                blocker = interval.obstacle;
        }
        if (found == kNothing || !tiles_.is_building(found)) found = blocker;
        if (blocker == kNothing) near_edge = true;
    }
    tiles_[number].places[spot.place].beside = found;
    if (near_edge) tiles_[number].marks[spot.place] |= WalkTiles::kNearEdge;
}

bool Flood::visit(Layer layer, std::uint32_t number, std::uint32_t place, Cell cell) {
    Tile& tile = tiles_[number];
    if (tile.marks[place] & WalkTiles::kReached[layer]) return true;
    Extent& extent = layers_[layer];
    if (!std::exchange(extent.any, true)) extent.low = extent.high = cell;
    const Cell low{std::min(extent.low.x, cell.x), std::min(extent.low.y, cell.y)},
        high{std::max(extent.high.x, cell.x), std::max(extent.high.y, cell.y)};
    const bool wide = static_cast<double>(high.x - low.x + 1) * static_cast<double>(high.y - low.y + 1) > kMostCells;
    if (full_ || wide) {
        part_ = true;
        return false;
    }
    extent.low = low;
    extent.high = high;
    tile.marks[place] |= WalkTiles::kReached[layer];
    tile.open.push_back({place, static_cast<std::uint16_t>(WalkTiles::local(cell)), layer});
    if (!std::exchange(tile.waits, true)) waiting_.push_back(number);
    return true;
}

// Starts the flood at the nearest place to stand around that point.
void Flood::seed_at(const Vec3& at, double level_m, double up_m, double down_m, bool on_building) {
    if (!is_finite(at) || stop_.stop_requested()) return;
    const Cell middle_cell = tiles_.cell_at(at);
    const auto rings = static_cast<std::int64_t>(std::min(level_m / body_.cell_m, 100.0));
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    // A trial searches only the floor with furniture, so the other layer gets no start.
    double best[2] = {kInfinite, trial_ ? -kInfinite : kInfinite};
    Found found[2];
    const auto farthest = [&] { return std::max(best[kFurnished], best[kWalls]); };
    for (std::int64_t ring = 0; ring <= rings && static_cast<double>(ring) * body_.cell_m < farthest(); ++ring) {
        const bool open[2] = {static_cast<double>(ring) * body_.cell_m < best[kFurnished],
                              static_cast<double>(ring) * body_.cell_m < best[kWalls]};
        for (std::int64_t dy = -ring; dy <= ring; ++dy)
            for (std::int64_t dx = -ring; dx <= ring;
                 dx += std::abs(dy) == ring ? 1 : 2 * std::max<std::int64_t>(ring, 1)) {
                const Cell c{middle_cell.x + dx, middle_cell.y + dy};
                const std::uint32_t number = tiles_.tile_of(c);
                const Tile& tile = tiles_[number];
                const std::size_t cell = WalkTiles::local(c);
                for (const Layer layer : {kFurnished, kWalls}) {
                    if (!open[layer]) continue;
                    const Range range = WalkTiles::column(tile, cell, layer);
                    for (std::uint32_t k = range.from; k < range.to; ++k) {
                        const Place& p = tile.places[k];
                        const double rise = p.floor - at.z;
                        if (rise > up_m || rise < -down_m || (on_building && !tiles_.is_building(p.ground))) continue;
                        const Vec2 m = tiles_.middle(c);
                        const double far = std::hypot(m.x - at.x, m.y - at.y) + std::abs(rise);
                        if (far < best[layer]) {
                            best[layer] = far;
                            found[layer] = {number, k, c};
                        }
                    }
                }
            }
    }
    for (const Layer layer : {kFurnished, kWalls})
        if (std::isfinite(best[layer])) visit(layer, found[layer].tile, found[layer].place, found[layer].cell);
}

void Flood::seed() {
    if (trial_ && trial_->within) return seed_at(trial_->within->from_m, 1.0, 0.6, 1.0, false);
    for (const Start& start : scene_.starts) seed_at(start.feet_m, 1.0, 0.6, 3.0, false);
    if (scene_.stated)
        for (const StatedRoom& room : scene_.stated->rooms)
            if (!room.rings.empty()) seed_at(room.at_m, 1.0, 0.6, 0.6, false);
    for (const RoomName& name : scene_.room_names) seed_at(name.at_m, 1.0, 0.6, 3.0, true);
    for (const Switch& s : scene_.switches)
        if (s.leads_elsewhere) seed_at(s.feet_m, 1.0, 0.6, 3.0, false);
    for (const SoundSource& sound : scene_.sounds) seed_at(sound.position_m, 1.5, 0.3, 3.0, true);
    for (const Feature& feature : scene_.features) {
        if (feature.bounds_m.empty()) continue;
        const bool thing = feature.kind == FeatureKind::Object || feature.kind == FeatureKind::Button ||
                           feature.kind == FeatureKind::Trigger || feature.kind == FeatureKind::Teleport;
        const Vec3 centre = feature.bounds_m.centre_m(), size = feature.bounds_m.size_m();
        // The middle of a large object, such as a room or the ceiling of a hall, is no useful start.
        if (!thing || std::max(size.x, size.y) > 6.0) continue;
        seed_at({centre.x, centre.y, feature.bounds_m.min_m.z}, 0.5 * std::max(size.x, size.y) + body_.radius_m + 0.3,
                0.3, 2.0, true);
    }
    // If the flood has no start yet, begins in the middle of the world, from above.
    if (!layers_[kFurnished].any && scene_.starts.empty() && !scene_.bounds_m.empty()) {
        const Vec3 c = scene_.bounds_m.centre_m();
        seed_at({c.x, c.y, scene_.bounds_m.min_m.z}, 5.0, scene_.bounds_m.size_m().z + 0.1, 0.1, false);
    }
}

// Sets the size of the grid, and the number of the first span in each cell.
template <class Span>
bool Flood::number(Layer layer, SpanGrid<Span>& grid, double& lowest) {
    const Extent& extent = layers_[layer];
    grid.cell_m = body_.cell_m;
    grid.width = static_cast<std::uint32_t>(extent.high.x - extent.low.x + 1);
    grid.depth = static_cast<std::uint32_t>(extent.high.y - extent.low.y + 1);
    grid.first.assign(static_cast<std::size_t>(grid.width) * grid.depth + 1, 0);
    lowest = std::numeric_limits<double>::infinity();
    for (std::uint32_t of = 0; of < tiles_.count(); ++of) {
        if (stop_.stop_requested()) return false;
        const Tile& tile = tiles_[of];
        for (std::size_t cell = 0; cell + 1 < tile.first.size(); ++cell) {
            const Range range = WalkTiles::column(tile, cell, layer);
            std::uint32_t here = 0;
            for (std::uint32_t k = range.from; k < range.to; ++k) {
                if (!(tile.marks[k] & WalkTiles::kReached[layer])) continue;
                lowest = std::min(lowest, tile.places[k].floor);
                ++here;
            }
            if (here == 0) continue;
            const auto x = static_cast<std::size_t>(tile.x * WalkTiles::kTile +
                                                    static_cast<std::int64_t>(cell % WalkTiles::kTile) - extent.low.x),
                       y = static_cast<std::size_t>(tile.y * WalkTiles::kTile +
                                                    static_cast<std::int64_t>(cell / WalkTiles::kTile) - extent.low.y);
            grid.first[y * grid.width + x + 1] = here;
        }
    }
    for (std::size_t c = 1; c < grid.first.size(); ++c) grid.first[c] += grid.first[c - 1];
    grid.origin_m = Vec3(tiles_.middle(extent.low) - Vec2(0.5 * body_.cell_m), lowest);
    grid.spans.resize(grid.first.back());
    return true;
}

// Writes each span with its surroundings and the neighbouring spans to which a step leads. Calls `each(span, number,
// tile, place)` with the place from which the span was made.
template <class Span, class Each>
bool Flood::write_spans(Layer layer, SpanGrid<Span>& grid, Each each) {
    double lowest = 0.0;
    if (!number(layer, grid, lowest)) return false;
    const Extent& extent = layers_[layer];
    std::vector<Aabb> door_boxes, liquid_boxes;
    for (const auto& [box, mover] : obstacles_.doors) door_boxes.push_back(box);
    for (const Solid* s : obstacles_.liquids) liquid_boxes.push_back(s->shape.bounds_m);
    const BoxIndex doors(door_boxes), liquids(liquid_boxes);
    for (std::uint32_t number = 0; number < tiles_.count(); ++number) {
        if (tiles_[number].first.empty()) continue;
        const Tile& tile = tiles_[number];
        const Vec2 low = tiles_.middle({tile.x * WalkTiles::kTile, tile.y * WalkTiles::kTile}),
                   high = tiles_.middle({tile.x * WalkTiles::kTile + WalkTiles::kTile - 1,
                                         tile.y * WalkTiles::kTile + WalkTiles::kTile - 1});
        const Vec2 border(body_.cell_m);
        const Aabb whole{Vec3(low - border, -1e9), Vec3(high + border, 1e9)};
        doors.find(whole, near_);
        const bool has_doors = !near_.empty();
        liquids.find(whole, near_);
        const bool has_liquids = !near_.empty();
        for (std::size_t cell = 0; cell < WalkTiles::kTile * WalkTiles::kTile; ++cell) {
            if (stopped()) return false;
            const Range range = WalkTiles::column(tile, cell, layer);
            const Cell c{tile.x * WalkTiles::kTile + static_cast<std::int64_t>(cell % WalkTiles::kTile),
                         tile.y * WalkTiles::kTile + static_cast<std::int64_t>(cell / WalkTiles::kTile)};
            const auto index = [&](Cell of) {
                return static_cast<std::size_t>(of.y - extent.low.y) * grid.width +
                       static_cast<std::size_t>(of.x - extent.low.x);
            };
            std::uint32_t made = 0;
            for (std::uint32_t k = range.from; k < range.to; ++k) {
                if (!(tile.marks[k] & WalkTiles::kReached[layer])) continue;
                const Place& p = tile.places[k];
                const std::uint32_t s = grid.first[index(c)] + made++;
                Span& span = grid.spans[s];
                span.cell = static_cast<std::uint32_t>(index(c)) & 0x1fffffffU;
                span.floor_m = static_cast<float>(p.floor - lowest);
                const Vec3 feet(tiles_.middle(c), p.floor);
                std::uint32_t door = kNothing;
                if (has_doors) {
                    const Aabb here{feet - Vec3(0.5 * body_.cell_m, 0.5 * body_.cell_m, 0.1),
                                    feet + Vec3(0.5 * body_.cell_m, 0.5 * body_.cell_m, body_.height_m)};
                    doors.find(here, near_);
                    if (!near_.empty()) door = obstacles_.doors[near_.front()].second;
                }
                if (has_liquids) {
                    liquids.find({feet, feet + Vec3(0.0, 0.0, kWading_m)}, near_);
                    span.liquid = wades(obstacles_.liquids, near_, feet) ? 1 : 0;
                }
                for (std::size_t d = 0; d < 4; ++d) {
                    const Cell to = WalkTiles::neighbour(c, static_cast<int>(d));
                    const std::size_t at = WalkTiles::local(to);
                    const Tile& other = tiles_[tiles_.beside(number, cell, static_cast<int>(d))];
                    const std::uint32_t n = tiles_.known_step(tile, k, d, other, at, layer);
                    // Keeps a step only if the step back leads to the same place.
                    if (n == kNothing || !tiles_.leads_back(tile, cell, k, other.places[n], layer)) continue;
                    const Range there = WalkTiles::column(other, at, layer);
                    std::uint32_t before = 0;
                    for (std::uint32_t b = there.from; b < n; ++b)
                        before += other.marks[b] & WalkTiles::kReached[layer] ? 1 : 0;
                    span.next[d] = grid.first[index(to)] + before;
                }
                each(span, s, number, cell, k, door, lowest);
            }
        }
    }
    return true;
}

bool Flood::write(WalkSpace& space) {
    for (const WalkObstacle& o : obstacles_.all) space.obstacle_features.push_back(o.feature);
    for (const PassingFloor& o : obstacles_.passing) space.obstacle_features.push_back(o.shape.feature);
    const Extent& extent = layers_[kFurnished];
    const bool written = write_spans(
        kFurnished, space,
        [&](WalkSpan& span, std::uint32_t s, std::uint32_t number, std::size_t cell, std::uint32_t k,
            std::uint32_t door, double lowest) {
            const Tile& tile = tiles_[number];
            const Place& p = tile.places[k];
            span.ceiling_m = static_cast<float>(std::min(p.ceiling - lowest, 1e6));
            span.ground = p.ground;
            span.door = door;
            span.beside = p.beside;
            span.near_edge = (tile.marks[k] & WalkTiles::kNearEdge) != 0;
            for (std::size_t d = 0; d < 4; ++d) {
                if (span.next[d] != kNothing || (tile.steps[k] & WalkTiles::step_bit(kFurnished, d))) continue;
                const Cell to = WalkTiles::neighbour(
                    {tile.x * WalkTiles::kTile + static_cast<std::int64_t>(cell % WalkTiles::kTile),
                     tile.y * WalkTiles::kTile + static_cast<std::int64_t>(cell / WalkTiles::kTile)},
                    static_cast<int>(d));
                const std::size_t at = WalkTiles::local(to);
                const std::uint32_t beside = tiles_.beside(number, cell, static_cast<int>(d));
                const Tile& other = tiles_[beside];
                const std::uint32_t down = drop(p, beside, to, kFurnished);
                if (down == kNothing) continue;
                const Range there = WalkTiles::column(other, at, kFurnished);
                std::uint32_t before = 0;
                for (std::uint32_t b = there.from; b < down; ++b)
                    before += other.marks[b] & WalkTiles::kReached[kFurnished] ? 1 : 0;
                const auto index = static_cast<std::size_t>(to.y - extent.low.y) * space.width +
                                   static_cast<std::size_t>(to.x - extent.low.x);
                space.links.push_back({PassageKind::Drop, s, space.first[index] + before, false, kNoFeature});
            }
        });
    if (!written) return false;
    std::stable_sort(space.links.begin(), space.links.end(),
                     [](const WalkLink& a, const WalkLink& b) { return a.from < b.from; });
    return true;
}

bool Flood::write(SpanGrid<WallSpan>& walls) {
    return write_spans(kWalls, walls,
                       [](WallSpan& span, std::uint32_t, std::uint32_t, std::size_t, std::uint32_t, std::uint32_t door,
                          double) { span.door = door != kNothing ? 1U : 0U; });
}

}  // namespace handrail::navigation
