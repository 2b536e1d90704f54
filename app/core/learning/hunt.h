// Implements the logic of the hunt: a ticking clock is hidden somewhere that can be reached on foot, and a walker or a
// hand that comes near finds it. Pure logic for the app thread, in world metres.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/core/world/walker.h"

namespace handrail::core {

// A grid of the places that a walker can reach from its present place, a quarter of a metre apart, including over steps
// and stairs. The class also measures the distance on foot from each place to one aim.
class HuntGround {
public:
    // `doors_open` is the world without doors, so that places behind doors are included.
    HuntGround(const WalkerWorld& doors_open, const Vec3& feet_m, const WalkerSize& body);
    // Returns a place of the grid that is at least `least_m` on foot from the start. If there is none, it returns the
    // farthest place. The same `number` gives the same place.
    Vec3 hiding_place(std::uint64_t number, double least_m) const;
    // Sets the aim. Distances are measured to this aim from now on.
    void aim(const Vec3& feet_m);
    // Returns the distance on foot from `feet_m` to the aim, or no value if no route is known.
    std::optional<double> way_m(const Vec3& feet_m) const;
    // Returns the farthest place on the route to the aim that a walker can reach from `feet_m` in a straight line.
    // Returns no value if no route is known.
    std::optional<Vec3> next_m(const WalkerWorld& doors_open, const Vec3& feet_m, const WalkerSize& body) const;
    std::size_t size() const { return nodes_.size(); }

private:
    struct Node {
        Vec3 feet_m{0.0};
        double way_m = -1.0;
        std::vector<std::uint32_t> beside;
    };
    std::optional<std::uint32_t> nearest(const Vec3& feet_m) const;
    void measure(std::uint32_t from);

    std::vector<Node> nodes_;
};

// Returns true if a walker or a hand at `feet_m` has found the clock. The clock must be within a step, and nothing may
// be in between.
bool finds(const WalkerWorld& world, const Vec3& feet_m, const Vec3& clock_feet_m);

}  // namespace handrail::core
