// Finds floor to which nothing leads: a room without a door, or with a door that nobody gets through. If obstacles
// enclose such floor on all sides, it becomes a room that is announced as out of reach. So tops of walls, roofs and
// ledges do not become rooms.
#include <algorithm>
#include <cmath>
#include <utility>

#include "worlds/navigation/walk_flood.h"

namespace handrail::navigation {
namespace {

constexpr double kLeast_m2 = 2.0;    // least floor area of a closed room; anything smaller is a shaft
constexpr std::int64_t kEvery = 10;  // number of cells between two tested places
constexpr double kInFloor_m = 0.01;  // an obstacle must begin lower than this above the floor to enclose it

std::uint64_t key_of(std::uint32_t tile, std::uint32_t place) { return (std::uint64_t{tile} << 32) | place; }

std::int64_t first_from(std::int64_t cell) { return (cell >= 0 ? cell + kEvery - 1 : cell) / kEvery * kEvery; }

}  // namespace

Flood::End Flood::reach_closed_rooms() {
    const bool sky = under_the_sky_at_the_start();
    SeenPlaces seen;
    for (std::uint32_t floor = 0; floor < obstacles_.all.size(); ++floor) {
        const WalkObstacle& o = obstacles_.all[floor];
        const Vec3 size = o.box_m.size_m();
        if (o.furniture || !tiles_.is_building(floor) || size.x * size.y < kLeast_m2) continue;
        const Cell low = tiles_.cell_at(o.box_m.min_m), high = tiles_.cell_at(o.box_m.max_m);
        for (std::int64_t y = first_from(low.y); y <= high.y; y += kEvery)
            for (std::int64_t x = first_from(low.x); x <= high.x; x += kEvery) {
                if (stopped()) return End::Stopped;
                if (tiles_.bytes() > kMostBytes / 2) return End::Done;
                const Cell cell{x, y};
                const std::uint32_t number = tiles_.tile_of(cell);
                const Range range = WalkTiles::column(tiles_[number], WalkTiles::local(cell), kWalls);
                for (std::uint32_t k = range.from; k < range.to; ++k) {
                    const Place& place = tiles_[number].places[k];
                    if (place.ground != floor || (!sky && place.ceiling >= kSky) ||
                        (tiles_[number].marks[k] & WalkTiles::kReached[kWalls]) || seen.contains(key_of(number, k)))
                        continue;
                    if (!is_closed_room({number, k, cell}, seen)) continue;
                    const double floor_m = place.floor;
                    visit(kWalls, number, k, cell);
                    const Range furnished = WalkTiles::column(tiles_[number], WalkTiles::local(cell), kFurnished);
                    for (std::uint32_t f = furnished.from; f < furnished.to; ++f)
                        if (std::abs(tiles_[number].places[f].floor - floor_m) <= body_.step_up_m)
                            visit(kFurnished, number, f, cell);
                    if (const End end = spread_all(); end != End::Done) return end;
                }
            }
    }
    return End::Done;
}

// Returns whether the start is under the open sky. If it is, the world may have no ceilings at all.
bool Flood::under_the_sky_at_the_start() {
    if (scene_.starts.empty()) return false;
    const Cell cell = tiles_.cell_at(scene_.starts.front().feet_m);
    const Tile& tile = tiles_[tiles_.tile_of(cell)];
    const Range range = WalkTiles::column(tile, WalkTiles::local(cell), kWalls);
    return std::any_of(tile.places.begin() + range.from, tile.places.begin() + range.to,
                       [&](const Place& place) { return place.ceiling >= kSky; }) &&
           range.from + 1 == range.to;
}

// Visits everything that a walker could reach from `from` if there were no furniture. Returns false if that area is
// small, was reached already, is partly under open sky and partly not, or has an edge to fall from. The search ends as
// soon as one of these is certain. A later search ends as soon as it comes to a place in `seen`.
bool Flood::is_closed_room(const Found& from, SeenPlaces& seen) {
    const auto trial = static_cast<std::uint32_t>(seen.size());
    const bool sky = tiles_[from.tile].places[from.place].ceiling >= kSky;
    std::vector<Found> open{from};
    seen.emplace(key_of(from.tile, from.place), trial);
    std::size_t count = 0;
    while (!open.empty()) {
        const Found at = open.back();
        open.pop_back();
        ++count;
        const Place here = tiles_[at.tile].places[at.place];
        if ((here.ceiling >= kSky) != sky) return false;
        for (int d = 0; d < 4; ++d) {
            const std::uint32_t other = tiles_.beside(at.tile, WalkTiles::local(at.cell), d);
            const Cell to = WalkTiles::neighbour(at.cell, d);
            const std::size_t local = WalkTiles::local(to);
            if (const std::uint32_t k = tiles_.step(here, tiles_[other], local, kWalls); k != kNothing) {
                if (tiles_[other].marks[k] & WalkTiles::kReached[kWalls]) return false;
                const auto [known, is_new] = seen.emplace(key_of(other, k), trial);
                if (known->second != trial) return false;
                if (is_new) open.push_back({other, k, to});
                continue;
            }
            const WalkTiles::Columns& columns = tiles_.columns_of(other);
            const auto stands_there = [&](const WalkTiles::Interval& i) {
                return i.low < here.floor + kInFloor_m && i.high > here.floor - body_.step_up_m;
            };
            if (std::none_of(columns.intervals.begin() + columns.first[local],
                             columns.intervals.begin() + columns.first[local + 1], stands_there))
                return false;
        }
    }
    return static_cast<double>(count) * body_.cell_m * body_.cell_m >= kLeast_m2;
}

}  // namespace handrail::navigation
