// The brute-force comparison for routes. A walker is moved from square to square through the world that walking itself
// uses (WalkerWorld), by lifting it, moving it and setting it down. Then Dijkstra's algorithm runs over the squares and
// the lift rides, and the path is straightened over all pairs of its squares. It shares no code with worlds/navigation
// and does not use Recast.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "app/core/world/walker.h"
#include "app/core/world/walker_world.h"
#include "tests/support/every.h"
#include "tests/support/names.h"
#include "worlds/navigation/route.h"

namespace handrail::test {

class GridTwin {
public:
    // Doors are left out of the world. `side_m`: the size of a square.
    GridTwin(const Scene& scene, const WalkerSize& body, double side_m);

    // Adds everything that can be reached on foot from there to the grid. Returns true if a walker can stand there.
    bool flood_from(const Vec3& feet_m);
    // The distances in metres from one place to all of `to`; none for a place that is not reached. A lift ride counts
    // as its height.
    std::vector<std::optional<double>> lengths(const Vec3& from_m, const std::vector<Vec3>& to_m) const;
    std::size_t size() const { return places_.size(); }
    // The index of the nearest square within reach.
    int nearest(const Vec3& feet_m) const;

private:
    std::optional<Vec3> stand(const Vec3& feet_m, double up_m, double down_m) const;
    int number(const Vec3& feet_m);
    bool straight(int from, int to) const;

    std::shared_ptr<const Scene> scene_;
    std::unique_ptr<WalkerWorld> world_;
    WalkerSize body_;
    double side_m_;
    struct Ride {
        Vec3 low_m{0.0}, high_m{0.0};
    };
    std::vector<Ride> rides_;  // the middle of each lift's top, at both ends of its travel
    std::vector<Vec3> places_;
    std::vector<std::array<int, 8>> next_;  // in the order east, north-east, north, ...
    std::map<std::tuple<long, long, long>, int> known_;
};

// The stride between the places from which compared routes start. They lead to each later place and back.
inline std::size_t source_stride() { return every(4, 10); }

inline std::vector<Vec3> from_on(const std::vector<Vec3>& places, std::size_t first) {
    return {places.begin() + static_cast<std::ptrdiff_t>(first), places.end()};
}

// The length of a route, with each lift ride counted as its height.
double length_with_rides_m(const Route& route);

// The scene without its door leaves.
std::shared_ptr<const Scene> without_doors(const Scene& scene);

}  // namespace handrail::test
