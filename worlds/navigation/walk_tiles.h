// The places where one could stand, found tile by tile as they are asked for: columns of what stands over each cell,
// with furniture and without it, and the steps from a place to those beside it. For the flood only.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <unordered_map>
#include <vector>

#include "worlds/geometry/box_index.h"
#include "worlds/navigation/near_ground.h"
#include "worlds/navigation/walk_clearance.h"
#include "worlds/navigation/walk_obstacles.h"

namespace handrail {

class WalkTiles {
public:
    static constexpr int kTile = 32;                         // cells along a side of what is looked at together
    static constexpr std::size_t kIntervalBytes = 32 << 20;  // of columns kept to be looked at again
    enum Layer : std::uint8_t { kFurnished, kWalls };
    static constexpr std::uint8_t kReached[2] = {1, 2}, kNearEdge = 4;
    static constexpr std::uint8_t kSame = 255;
    static constexpr std::uint8_t step_bit(Layer layer, std::size_t d) {
        return static_cast<std::uint8_t>(1U << (4U * layer + d));
    }

    using Interval = ColumnInterval;
    struct Place {  // a span in the making
        double floor = 0.0, ceiling = 0.0;
        std::uint32_t ground = kNothing, beside = kNothing;
    };
    struct Spot {
        std::uint32_t place = 0;
        std::uint16_t cell = 0;  // of the tile
        Layer layer = kFurnished;
    };
    struct Columns {  // what stands over each cell of a tile
        std::array<std::uint32_t, kTile * kTile + 1> first{};
        std::vector<Interval> intervals;
    };
    struct Tile {
        std::int64_t x = 0, y = 0;
        std::array<std::uint32_t, 4> beside = {kNothing, kNothing, kNothing, kNothing};  // tiles, once asked for
        std::vector<std::uint32_t> first;  // of each cell its first place; empty: there is none in the tile
        std::vector<std::uint8_t> split;   // of each cell how many of its places are those with furniture; kSame:
                                           // furniture changes nothing. Empty: nowhere
        std::vector<Place> places;
        std::vector<std::uint8_t> marks;  // of each place
        std::vector<std::uint8_t> steps;  // of each reached one, the bits step_bit() of the ways one can step from it
        std::vector<Spot> open;
        std::unique_ptr<Columns> columns;  // while they are kept
        bool waits = false;
    };
    struct Cell {  // anywhere in the world
        std::int64_t x = 0, y = 0;
    };
    struct Range {
        std::uint32_t from = 0, to = 0;
    };

    // What is given by reference outlives this object.
    WalkTiles(const Scene& scene, const WalkBody& body, const Obstacles& obstacles, const NearGround& ground);

    // A tile stays where it is.
    Tile& operator[](std::uint32_t tile) { return *tiles_[tile]; }
    const Tile& operator[](std::uint32_t tile) const { return *tiles_[tile]; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(tiles_.size()); }
    std::size_t bytes() const { return tile_bytes_; }
    // True if ground was left out of a tile.
    bool ground_left_out() const { return ground_left_out_; }

    static Cell neighbour(Cell c, int d) { return {c.x + (d == 0) - (d == 2), c.y + (d == 1) - (d == 3)}; }
    static std::size_t local(Cell c) {
        static_assert((kTile & (kTile - 1)) == 0);
        return (static_cast<std::size_t>(c.y) & (kTile - 1)) * kTile + (static_cast<std::size_t>(c.x) & (kTile - 1));
    }
    static Range column(const Tile& tile, std::size_t cell, Layer layer) {
        if (tile.first.empty()) return {};
        const std::uint32_t from = tile.first[cell], to = tile.first[cell + 1];
        if (tile.split.empty() || tile.split[cell] == kSame) return {from, to};
        const std::uint32_t parted = from + tile.split[cell];
        return layer == kFurnished ? Range{from, parted} : Range{parted, to};
    }
    Vec2 middle(Cell c) const;
    Cell cell_at(const Vec3& p) const;

    // Both make the tile where it is not known yet.
    std::uint32_t tile_of(Cell c);
    std::uint32_t beside(std::uint32_t tile, std::size_t cell, int d);
    // Made anew where they were not kept.
    const Columns& columns_of(std::uint32_t tile);

    // The place in that column one comes to by a step, kNothing for none.
    std::uint32_t step(const Place& here, const Tile& tile, std::size_t cell, Layer layer) const;
    // The same after the flood, from a place that it reached.
    std::uint32_t known_step(const Tile& from, std::uint32_t place, std::size_t d, const Tile& to, std::size_t cell,
                             Layer layer) const {
        if (!(from.steps[place] & step_bit(layer, d))) return kNothing;
        const Range range = column(to, cell, layer);
        return range.to - range.from == 1 ? range.from : step(from.places[place], to, cell, layer);
    }
    // True where the step from `place` in the column of `cell` to `there` of another tile leads back as well.
    bool leads_back(const Tile& tile, std::size_t cell, std::uint32_t place, const Place& there, Layer layer) const {
        const Range range = column(tile, cell, layer);
        return range.to - range.from == 1 || step(there, tile, cell, layer) == place;  // a step is as high both ways
    }
    std::uint32_t drop(const Place& here, const Tile& tile, std::size_t cell, Layer layer) const;
    // The mover that carries this ground, -1: none. And whether it is no thing that stands in the building.
    int passing_mover(std::uint32_t ground) const;
    bool is_building(std::uint32_t ground) const;
    bool is_stairs(std::uint32_t ground) const;

    // After the flood: what was not reached goes, and so do all columns.
    void drop_unreached();

private:
    static void drop_unreached(Tile& tile);
    std::uint32_t tile_at(std::int64_t tx, std::int64_t ty);
    void fill(Tile& tile, bool places);
    void keep(std::uint32_t tile);

    const Scene& scene_;
    WalkBody body_;
    const Obstacles& obstacles_;
    const NearGround& ground_;
    BoxIndex index_, passing_index_;
    Vec3 anchor_{0.0};
    std::unordered_map<std::uint64_t, std::uint32_t>
        tile_number_;  // looked up, never walked through: no order of its own
    std::vector<std::unique_ptr<Tile>> tiles_;
    std::deque<std::uint32_t> kept_;  // tiles with columns, the oldest first
    std::size_t kept_bytes_ = 0, tile_bytes_ = 0;
    bool ground_left_out_ = false;
    std::vector<std::uint32_t> near_;
};

}  // namespace handrail
