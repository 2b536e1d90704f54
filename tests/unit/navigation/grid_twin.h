// The brute-force twin of routes: a body walked from square to square through the world that walking itself uses (BodyWorld), by lifting it, moving it and
// setting it down; then Dijkstra over the squares, straightened over all pairs of its squares. Shares no code with worlds/navigation and knows no Recast.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "app/core/body_world.h"
#include "app/core/walker.h"
#include "tests/support/scale.h"

namespace handrail::test {

class GridTwin {
public:
    // Doors are left out of the world. `side_m`: of a square.
    GridTwin(const Scene& scene, const BodySize& body, double side_m);

    // Everything that is reached on foot from there belongs to the grid; true when one can stand there.
    bool flood_from(const Vec3& feet_m);
    // The metres from one place to all of `to`; none where it is not reached.
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
    std::vector<Vec3> places_;
    std::vector<std::array<int, 8>> next_;  // towards east, north-east, north, ...
    std::map<std::tuple<long, long, long>, int> known_;
};

// Which places are taken as beginnings of compared routes: every one, and every tenth in instrumented builds; always to all places.
inline constexpr std::size_t kSourceStride = static_cast<std::size_t>(1.0 / kSanitizerScale + 0.5);

// The scene without the leaves of its doors.
std::shared_ptr<const Scene> without_doors(const Scene& scene);

}  // namespace handrail::test
