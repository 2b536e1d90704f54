#include "worlds/navigation/walk_tiles.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace handrail::navigation {
namespace {

constexpr std::size_t kMostInColumn = 60;  // most spans in a column; Recast allows at most 62

}  // namespace

WalkTiles::WalkTiles(const Scene& scene, const WalkerMeasures& body, const Obstacles& obstacles,
                     const NearGround& ground)
    : scene_(scene),
      body_(body),
      obstacles_(obstacles),
      ground_(ground),
      index_(boxes_of(obstacles.all)),
      passing_index_(boxes_of(obstacles.passing)) {
    anchor_ = scene.bounds_m.empty() ? Vec3(0.0) : scene.bounds_m.min_m;
    if (!scene.starts.empty()) anchor_ = scene.starts.front().feet_m;
}

void WalkTiles::drop_unreached() {
    while (!kept_.empty()) {
        tiles_[kept_.front()]->columns.reset();
        kept_.pop_front();
    }
    for (const auto& tile : tiles_) drop_unreached(*tile);
}

// Removes the places that were not reached. A step from a reached place always leads to a reached place, so all steps
// stay valid.
void WalkTiles::drop_unreached(Tile& tile) {
    std::vector<Spot>().swap(tile.open);
    if (tile.places.empty()) return;
    std::vector<Place> places;
    std::vector<std::uint8_t> marks, steps;
    const auto count = static_cast<std::size_t>(
        std::count_if(tile.marks.begin(), tile.marks.end(), [](std::uint8_t m) { return m != 0; }));
    places.reserve(count);
    marks.reserve(count);
    steps.reserve(count);
    for (std::size_t cell = 0; cell < kTile * kTile; ++cell) {
        const std::uint32_t from = tile.first[cell], to = tile.first[cell + 1];
        const bool parted = !tile.split.empty() && tile.split[cell] != kSame;
        const std::uint32_t split = parted ? from + tile.split[cell] : from;
        tile.first[cell] = static_cast<std::uint32_t>(places.size());
        for (std::uint32_t k = from; k < to; ++k) {
            if (k == split && parted) tile.split[cell] = static_cast<std::uint8_t>(places.size() - tile.first[cell]);
            if (tile.marks[k] == 0) continue;
            places.push_back(tile.places[k]);
            marks.push_back(tile.marks[k]);
            steps.push_back(tile.steps[k]);
        }
        if (split == to && parted) tile.split[cell] = static_cast<std::uint8_t>(places.size() - tile.first[cell]);
    }
    tile.first.back() = static_cast<std::uint32_t>(places.size());
    tile.places = std::move(places);
    tile.marks = std::move(marks);
    tile.steps = std::move(steps);
    if (tile.places.empty()) {
        std::vector<std::uint32_t>().swap(tile.first);
        std::vector<std::uint8_t>().swap(tile.split);
    }
}

Vec2 WalkTiles::middle(Cell c) const {
    return {anchor_.x + (static_cast<double>(c.x) + 0.5) * body_.cell_m,
            anchor_.y + (static_cast<double>(c.y) + 0.5) * body_.cell_m};
}

WalkTiles::Cell WalkTiles::cell_at(const Vec3& p) const {
    return {static_cast<std::int64_t>(std::floor((p.x - anchor_.x) / body_.cell_m)),
            static_cast<std::int64_t>(std::floor((p.y - anchor_.y) / body_.cell_m))};
}

int WalkTiles::passing_mover(std::uint32_t ground) const {
    return ground == kNothing || ground < obstacles_.all.size()
               ? -1
               : static_cast<int>(obstacles_.passing[ground - obstacles_.all.size()].mover);
}

bool WalkTiles::is_stairs(std::uint32_t ground) const {
    return ground < obstacles_.all.size() && obstacles_.all[ground].stairs;
}

bool WalkTiles::is_building(std::uint32_t ground) const {
    if (ground >= obstacles_.all.size()) return true;
    const Feature* feature = scene_.find(obstacles_.all[ground].feature);
    return !feature || feature->kind != FeatureKind::Object;
}

std::uint32_t WalkTiles::tile_at(std::int64_t tx, std::int64_t ty) {
    const std::uint64_t key = (static_cast<std::uint64_t>(tx) << 32) ^ (static_cast<std::uint64_t>(ty) & 0xffffffffU);
    const auto [found, is_new] = tile_number_.try_emplace(key, static_cast<std::uint32_t>(tiles_.size()));
    if (is_new) {
        Tile& tile = *tiles_.emplace_back(std::make_unique<Tile>());
        tile.x = tx;
        tile.y = ty;
        fill(tile, true);
        tile_bytes_ += sizeof(Tile) + 64 + tile.first.size() * sizeof(std::uint32_t) + tile.split.size() +
                       tile.places.size() * (sizeof(Place) + 2);
        keep(found->second);
    }
    return found->second;
}

std::uint32_t WalkTiles::tile_of(Cell c) {
    const auto floor_div = [](std::int64_t v) { return v >= 0 ? v / kTile : -((-v + kTile - 1) / kTile); };
    return tile_at(floor_div(c.x), floor_div(c.y));
}

// Returns the tile that contains the neighbour of `cell` in the direction `d`.
std::uint32_t WalkTiles::beside(std::uint32_t tile, std::size_t cell, int d) {
    const std::size_t x = cell % kTile, y = cell / kTile;
    const bool inside = d == 0 ? x + 1 < kTile : d == 2 ? x > 0 : d == 1 ? y + 1 < kTile : y > 0;
    if (inside) return tile;
    if (const std::uint32_t known = tiles_[tile]->beside[static_cast<std::size_t>(d)]; known != kNothing) return known;
    const Cell to = neighbour({tiles_[tile]->x, tiles_[tile]->y}, d);
    const std::uint32_t found = tile_at(to.x, to.y);
    return tiles_[tile]->beside[static_cast<std::size_t>(d)] = found;
}

// Makes the columns of a tile. If `places` is set, also makes the places in them.
void WalkTiles::fill(Tile& tile, bool places) {
    const Vec2 low = middle({tile.x * kTile, tile.y * kTile}),
               high = middle({tile.x * kTile + kTile - 1, tile.y * kTile + kTile - 1});
    const Aabb box{Vec3(low, -1e9), Vec3(high, 1e9)};
    struct InCell {
        std::uint32_t cell;
        Interval interval;
    };
    const auto scan = [&](const WalkObstacle& o, std::uint32_t number, std::vector<InCell>& into) {
        const auto clamp = [](double v) {
            return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(kTile - 1)));
        };
        const int x0 = clamp(std::ceil((o.box_m.min_m.x - low.x) / body_.cell_m)),
                  x1 = clamp(std::floor((o.box_m.max_m.x - low.x) / body_.cell_m));
        const int y0 = clamp(std::ceil((o.box_m.min_m.y - low.y) / body_.cell_m)),
                  y1 = clamp(std::floor((o.box_m.max_m.y - low.y) / body_.cell_m));
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                Interval i;
                i.obstacle = number;
                const Vec2 at = low + Vec2(x, y) * body_.cell_m;
                if (obstacles_.column(o, at.x, at.y, i.low, i.high, i.steep))
                    into.push_back({static_cast<std::uint32_t>(y * kTile + x), i});
            }
    };
    // Sorts by cell, then by height, stably.
    const auto sorted = [](const std::vector<InCell>& found, std::array<std::uint32_t, kTile * kTile + 1>& first) {
        std::vector<Interval> all(found.size());
        first.fill(0);
        for (const InCell& f : found) ++first[f.cell + 1];
        for (std::size_t c = 0; c < kTile * kTile; ++c) first[c + 1] += first[c];
        std::array<std::uint32_t, kTile * kTile> next;
        std::copy(first.begin(), first.end() - 1, next.begin());
        for (const InCell& f : found) all[next[f.cell]++] = f.interval;
        for (std::size_t c = 0; c < kTile * kTile; ++c)
            from_below(std::span(all).subspan(first[c], first[c + 1] - first[c]));
        return all;
    };
    std::vector<InCell> found;
    index_.find(box, near_);
    for (const std::uint32_t k : near_) scan(obstacles_.all[k], k, found);
    tile.columns = std::make_unique<Columns>();
    tile.columns->intervals = sorted(found, tile.columns->first);
    if (!places) return;

    found.clear();
    passing_index_.find(box, near_);
    for (const std::uint32_t k : near_)
        scan(obstacles_.passing[k].shape, static_cast<std::uint32_t>(obstacles_.all.size()) + k, found);
    std::array<std::uint32_t, kTile * kTile + 1> first_floor;
    const std::vector<Interval> floors = sorted(found, first_floor);
    const auto furniture = [&](const Interval& i) { return obstacles_.all[i.obstacle].furniture; };
    std::vector<std::uint32_t> first(kTile * kTile + 1, 0);
    std::vector<std::uint8_t> split(kTile * kTile, kSame);
    bool any_split = false;
    std::vector<Place> made;
    for (std::size_t cell = 0; cell < kTile * kTile; ++cell) {
        first[cell] = static_cast<std::uint32_t>(made.size());
        const std::span<const Interval> over(tile.columns->intervals.data() + tile.columns->first[cell],
                                             tile.columns->first[cell + 1] - tile.columns->first[cell]),
            moving(floors.data() + first_floor[cell], first_floor[cell + 1] - first_floor[cell]);
        std::size_t from = made.size();
        const auto put = [&](double floor, double ceiling, std::uint32_t ground) {
            const Vec2 at = low + Vec2(cell % kTile, cell / kTile) * body_.cell_m;
            if (ground_.leaves_out(ground, at)) ground_left_out_ = true;
            else if (made.size() - from < kMostInColumn) made.push_back({floor, ceiling, ground, kNothing});
        };
        free_stretches(
            over, moving, body_.step_up_m, [](const Interval&) { return false; }, put);
        if (std::none_of(over.begin(), over.end(), furniture)) continue;
        split[cell] = static_cast<std::uint8_t>(made.size() - from);
        any_split = true;
        from = made.size();
        free_stretches(over, moving, body_.step_up_m, furniture, put);
    }
    first.back() = static_cast<std::uint32_t>(made.size());
    if (made.empty()) return;
    tile.first = std::move(first);
    if (any_split) tile.split = std::move(split);
    tile.places.assign(made.begin(), made.end());
    tile.marks.assign(made.size(), 0);
    tile.steps.assign(made.size(), 0);
}

const WalkTiles::Columns& WalkTiles::columns_of(std::uint32_t number) {
    Tile& tile = *tiles_[number];
    if (!tile.columns) {
        fill(tile, false);
        keep(number);
    }
    return *tile.columns;
}

// Keeps the columns of a tile. If they need too much memory, frees the oldest columns first.
void WalkTiles::keep(std::uint32_t number) {
    const auto bytes = [this](std::uint32_t of) {
        return sizeof(Columns) + tiles_[of]->columns->intervals.size() * sizeof(Interval);
    };
    kept_bytes_ += bytes(number);
    kept_.push_back(number);
    while (kept_bytes_ > kIntervalBytes && kept_.size() > 1) {
        kept_bytes_ -= bytes(kept_.front());
        tiles_[kept_.front()]->columns.reset();
        kept_.pop_front();
    }
}

std::uint32_t WalkTiles::step(const Place& here, const Tile& tile, std::size_t cell, Layer layer) const {
    const Range range = column(tile, cell, layer);
    std::uint32_t best = kNothing;
    const double step_up_m = body_.step_up_m + kWalkRounding_m;
    double nearest = StairRule::step_m(body_.step_up_m) + kWalkRounding_m;
    for (std::uint32_t k = range.from; k < range.to; ++k) {
        const Place& p = tile.places[k];
        const double rise = std::abs(p.floor - here.floor);
        if (rise > nearest || (rise > step_up_m && !is_stairs(here.ground) && !is_stairs(p.ground)) ||
            std::min(p.ceiling, here.ceiling) - std::max(p.floor, here.floor) < kLeastRoom_m)
            continue;
        if (best != kNothing && rise == nearest) continue;
        nearest = rise;
        best = k;
    }
    return best;
}

// Returns the place on which a walker lands after stepping over the edge.
std::uint32_t WalkTiles::drop(const Place& here, const Tile& tile, std::size_t cell, Layer layer) const {
    const Range range = column(tile, cell, layer);
    std::uint32_t best = kNothing;
    for (std::uint32_t k = range.from; k < range.to; ++k) {
        const Place& p = tile.places[k];
        if (p.floor < here.floor - body_.step_up_m && p.floor >= here.floor - body_.most_drop_m &&
            p.ceiling > here.floor + kLeastRoom_m)
            best = k;
    }
    return best;
}

}  // namespace handrail::navigation
