// Finds the places where people could stand, tile by tile on request. Each tile has columns of the obstacles over each
// cell, and the places with and without furniture. It also has the steps from each place to its neighbours. Only the
// flood uses this class.
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

namespace handrail::navigation {

class WalkTiles {
public:
    static constexpr int kTile = 32;                         // cells along a side of a tile
    static constexpr std::size_t kIntervalBytes = 32 << 20;  // most memory for columns that are kept for later use
    enum Layer : std::uint8_t { kFurnished, kWalls };
    static constexpr std::uint8_t kReached[2] = {1, 2}, kNearEdge = 4;
    static constexpr std::uint8_t kSame = 255;
    static constexpr std::uint8_t step_bit(Layer layer, std::size_t d) {
        return static_cast<std::uint8_t>(1U << (4U * layer + d));
    }

    using Interval = ColumnInterval;
    struct Place {  // a place where people could stand; becomes a span if it is reached
        double floor = 0.0, ceiling = 0.0;
        std::uint32_t ground = kNothing, beside = kNothing;
    };
    struct Spot {
        std::uint32_t place = 0;
        std::uint16_t cell = 0;  // number of the cell in the tile
        Layer layer = kFurnished;
    };
    struct Columns {  // obstacles over each cell of a tile
        std::array<std::uint32_t, kTile * kTile + 1> first{};
        std::vector<Interval> intervals;
    };
    struct Tile {
        std::int64_t x = 0, y = 0;
        // The four neighbouring tiles; kNothing until a search requests them.
        std::array<std::uint32_t, 4> beside = {kNothing, kNothing, kNothing, kNothing};
        std::vector<std::uint32_t> first;  // for each cell: its first place; empty: the tile has no places
        // For each cell: the number of its places that belong to the floor with furniture; these come first. kSame:
        // furniture changes nothing in this cell. Empty: it changes nothing in the whole tile.
        std::vector<std::uint8_t> split;
        std::vector<Place> places;
        std::vector<std::uint8_t> marks;  // marks of each place
        // For each reached place: a step_bit() for each direction in which a step is possible.
        std::vector<std::uint8_t> steps;
        std::vector<Spot> open;
        std::unique_ptr<Columns> columns;  // null while the columns are not kept
        bool waits = false;
    };
    struct Cell {  // position in the grid of the whole world
        std::int64_t x = 0, y = 0;
    };
    struct Range {
        std::uint32_t from = 0, to = 0;
    };

    // The arguments must outlive this object.
    WalkTiles(const Scene& scene, const WalkerMeasures& body, const Obstacles& obstacles, const NearGround& ground);

    // The reference stays valid: tiles do not move.
    Tile& operator[](std::uint32_t tile) { return *tiles_[tile]; }
    const Tile& operator[](std::uint32_t tile) const { return *tiles_[tile]; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(tiles_.size()); }
    std::size_t bytes() const { return tile_bytes_; }
    // Returns true if ground was left out in any tile.
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

    // `tile_of` and `beside` both make the tile if it does not exist yet.
    std::uint32_t tile_of(Cell c);
    std::uint32_t beside(std::uint32_t tile, std::size_t cell, int d);
    // Returns the columns of a tile. Makes them again if they were not kept.
    const Columns& columns_of(std::uint32_t tile);

    // Returns the place in the column of `cell` to which a step from `here` leads; kNothing if there is none.
    std::uint32_t step(const Place& here, const Tile& tile, std::size_t cell, Layer layer) const;
    // Returns the same as step(), but faster, for a place that the flood has reached. Call it after the flood.
    std::uint32_t known_step(const Tile& from, std::uint32_t place, std::size_t d, const Tile& to, std::size_t cell,
                             Layer layer) const {
        if (!(from.steps[place] & step_bit(layer, d))) return kNothing;
        const Range range = column(to, cell, layer);
        return range.to - range.from == 1 ? range.from : step(from.places[place], to, cell, layer);
    }
    // Returns whether a step from `there`, in another tile, leads back to `place` in the column of `cell`.
    bool leads_back(const Tile& tile, std::size_t cell, std::uint32_t place, const Place& there, Layer layer) const {
        const Range range = column(tile, cell, layer);
        // A step is equally high in both directions, so a column with a single place needs no search.
        return range.to - range.from == 1 || step(there, tile, cell, layer) == place;
    }
    std::uint32_t drop(const Place& here, const Tile& tile, std::size_t cell, Layer layer) const;
    // `passing_mover` returns the mover that carries this ground; -1: none. `is_building` returns whether the ground is
    // part of the building, not an object in it.
    int passing_mover(std::uint32_t ground) const;
    bool is_building(std::uint32_t ground) const;
    bool is_stairs(std::uint32_t ground) const;

    // Call this function after the flood. It frees the places that were not reached, and all columns.
    void drop_unreached();

private:
    static void drop_unreached(Tile& tile);
    std::uint32_t tile_at(std::int64_t tx, std::int64_t ty);
    void fill(Tile& tile, bool places);
    void keep(std::uint32_t tile);

    const Scene& scene_;
    WalkerMeasures body_;
    const Obstacles& obstacles_;
    const NearGround& ground_;
    BoxIndex index_, passing_index_;
    Vec3 anchor_{0.0};
    std::unordered_map<std::uint64_t, std::uint32_t> tile_number_;  // never iterated, because its order is arbitrary
    std::vector<std::unique_ptr<Tile>> tiles_;
    std::deque<std::uint32_t> kept_;  // tiles whose columns are kept, the oldest first
    std::size_t kept_bytes_ = 0, tile_bytes_ = 0;
    bool ground_left_out_ = false;
    std::vector<std::uint32_t> near_;
};

}  // namespace handrail::navigation
