// The brute-force twin of routes: a body walked from square to square through the world that walking itself uses
// (BodyWorld), by lifting it, moving it and setting it down; then Dijkstra over the squares and the rides on lifts,
// straightened over all pairs of its squares. Shares no code with worlds/navigation and knows no Recast.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "app/core/world/body_world.h"
#include "app/core/world/walker.h"
#include "tests/support/every.h"
#include "worlds/navigation/route.h"

namespace handrail::test {

class GridTwin {
public:
    // Doors are left out of the world. `side_m`: of a square.
    GridTwin(const Scene& scene, const BodySize& body, double side_m);

    // Everything that is reached on foot from there belongs to the grid; true when one can stand there.
    bool flood_from(const Vec3& feet_m);
    // The metres from one place to all of `to`, a ride on a lift counted as its height; none where it is not reached.
    std::vector<std::optional<double>> lengths(const Vec3& from_m, const std::vector<Vec3>& to_m) const;
    std::size_t size() const { return places_.size(); }
    // The nearest square's middle within reach.
    int nearest(const Vec3& feet_m) const;

private:
    std::optional<Vec3> stand(const Vec3& feet_m, double up_m, double down_m) const;
    int number(const Vec3& feet_m);
    bool straight(int from, int to) const;

    std::shared_ptr<const Scene> scene_;
    std::unique_ptr<BodyWorld> world_;
    BodySize body_;
    double side_m_;
    struct Ride {
        Vec3 low_m{0.0}, high_m{0.0};
    };
    std::vector<Ride> rides_;  // the middle of each lift's top at both ends of its way
    std::vector<Vec3> places_;
    std::vector<std::array<int, 8>> next_;  // towards east, north-east, north, ...
    std::map<std::tuple<long, long, long>, int> known_;
};

// Every how manyth place is taken as the beginning of compared routes: to each place further on, and back.
inline std::size_t source_stride() { return every(4, 10); }

inline std::vector<Vec3> from_on(const std::vector<Vec3>& places, std::size_t first) {
    return {places.begin() + static_cast<std::ptrdiff_t>(first), places.end()};
}

// What a route counts where a ride on a lift counts as its height.
double length_with_rides_m(const Route& route);

// The scene without the leaves of its doors.
std::shared_ptr<const Scene> without_doors(const Scene& scene);

}  // namespace handrail::test
