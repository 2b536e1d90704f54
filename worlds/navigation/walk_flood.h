// Finds all places that a walker can reach on foot by a breadth-first flood fill, tile by tile. It does so once with
// furniture and once without, and writes the places as spans. Only walk_space uses this class.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <stop_token>
#include <unordered_map>
#include <vector>

#include "worlds/navigation/walk_tiles.h"

namespace handrail::navigation {

class Flood {
public:
    // Returns the greatest number of spans. Coarse columns may have more spans, so that the columns of a large station
    // do not become too coarse for its doors.
    static std::size_t most_spans(double cell_m) { return cell_m > 0.15 ? 4'000'000 : 2'000'000; }
    static constexpr double kMostCells = 40e6;              // most cells of the grid over everything that was reached
    static constexpr std::size_t kMostBytes = 400'000'000;  // most memory of all tiles

    // `partly`: if there is too much floor, the flood ends and keeps what it has reached by then. `trial`: see
    // make_trial_space; null: everything is made. All arguments must outlive this object.
    Flood(const Scene& scene, const WalkerMeasures& body, const Obstacles& obstacles, const NearGround& ground,
          bool partly, const std::stop_token& stop, const WalkTrial* trial = nullptr);

    // TooLarge: there is too much floor, or the grid is too large. run() returns it only if `partly` is false.
    enum class End : std::uint8_t { Done, TooLarge, Stopped };
    End run();
    // Call write() after run(). Both functions return false if a stop was requested.
    bool write(WalkSpace& space);
    bool write(SpanGrid<WallSpan>& walls);
    // Returns true if there is more floor than the flood has reached.
    bool is_part() const { return part_; }
    bool ground_left_out() const { return tiles_.ground_left_out(); }
    std::size_t reached() const { return layers_[kFurnished].reached; }
    std::size_t reached_without_furniture() const { return layers_[kWalls].reached; }

private:
    using Layer = WalkTiles::Layer;
    static constexpr Layer kFurnished = WalkTiles::kFurnished, kWalls = WalkTiles::kWalls;
    using Tile = WalkTiles::Tile;
    using Place = WalkTiles::Place;
    using Spot = WalkTiles::Spot;
    using Cell = WalkTiles::Cell;
    using Range = WalkTiles::Range;

    struct Found {
        std::uint32_t tile = kNothing, place = 0;
        Cell cell;
    };
    struct Extent {
        std::size_t reached = 0;
        bool any = false;
        Cell low, high;
    };

    // Marks the place as reached. If there is too much floor already, returns false and does not mark the place.
    bool visit(Layer layer, std::uint32_t tile, std::uint32_t place, Cell cell);
    End spread_all();
    End spread(std::uint32_t tile);
    // Finds rooms to which nothing leads, which the program announces as out of reach. Defined in walk_closed.cpp.
    End reach_closed_rooms();
    // For each visited place, the number of the search that visited it. Nothing iterates over this map, because its
    // order is arbitrary.
    using SeenPlaces = std::unordered_map<std::uint64_t, std::uint32_t>;
    bool is_closed_room(const Found& from, SeenPlaces& seen);
    bool under_the_sky_at_the_start();
    // For each direction, the tile and the place to which a walker steps from a place.
    struct Steps {
        std::array<std::uint32_t, 4> tile{}, place{};
    };
    void look_at_neighbour(std::uint32_t tile, const Spot& spot, const Steps& steps);
    void seed_at(const Vec3& at, double level_m, double up_m, double down_m, bool on_building);
    void seed();
    template <class Span>
    bool number(Layer layer, SpanGrid<Span>& grid, double& lowest);
    template <class Span, class Each>
    bool write_spans(Layer layer, SpanGrid<Span>& grid, Each each);
    bool is_within(const Place& place, Cell cell) const;
    std::uint32_t drop(const Place& here, std::uint32_t tile, Cell to, Layer layer) const;
    bool stopped() { return (++stop_queries_ & 0xfff) == 0 && stop_.stop_requested(); }

    const Scene& scene_;
    WalkerMeasures body_;
    const Obstacles& obstacles_;
    std::stop_token stop_;
    const WalkTrial* trial_;
    const bool partly_;
    bool full_ = false, part_ = false;
    WalkTiles tiles_;
    std::deque<std::uint32_t> waiting_;
    std::size_t stop_queries_ = 0;
    std::vector<std::uint32_t> near_;
    std::array<Extent, 2> layers_;
};

}  // namespace handrail::navigation
