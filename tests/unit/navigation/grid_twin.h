// Finds routes by brute force, as a reference for tests. The class moves a walker from square to square through the
// world that walking itself uses (WalkerWorld): it lifts the walker, moves it, and sets it down. Then Dijkstra's
// algorithm runs over the squares and the lift rides. Finally the class straightens the path over all pairs of squares.
// It shares no code with worlds/navigation and does not use Recast.
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
    // Omits doors from the world. `side_m` is the size of a square.
    GridTwin(const Scene& scene, const WalkerSize& body, double side_m);

    // Adds all squares to the grid that a walker can reach from `feet_m`. Returns true if a walker can stand there.
    bool flood_from(const Vec3& feet_m);
    // Returns the distances in metres from `from_m` to all of `to_m`; empty for a place that the walker cannot reach.
    // The length of a lift ride is its height.
    std::vector<std::optional<double>> lengths(const Vec3& from_m, const std::vector<Vec3>& to_m) const;
    std::size_t size() const { return places_.size(); }
    // Returns the index of the nearest square within 2 m of `feet_m`; -1 if there is none.
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
    std::vector<Ride> rides_;  // the middle of each lift's platform, at both ends of its travel
    std::vector<Vec3> places_;
    std::vector<std::array<int, 8>> next_;  // the eight neighbours of each square: east, north-east, north, ...
    std::map<std::tuple<long, long, long>, int> known_;
};

// Returns the stride between the places from which the compared routes start. From each of them, routes lead to all
// later places and back.
inline std::size_t source_stride() { return every(4, 10); }

inline std::vector<Vec3> from_on(const std::vector<Vec3>& places, std::size_t first) {
    return {places.begin() + static_cast<std::ptrdiff_t>(first), places.end()};
}

// Returns the length of a route. The length of a lift ride is its height.
double length_with_rides_m(const Route& route);

// Returns the scene without its door leaves.
std::shared_ptr<const Scene> without_doors(const Scene& scene);

}  // namespace handrail::test
