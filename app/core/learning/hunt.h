// The hunt: a ticking clock is hidden somewhere that can be reached on foot. Walking or reaching there finds it. Pure
// logic; app thread; world metres.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/core/world/walker.h"

namespace handrail::core {

// The places, a quarter of a metre apart, that a walker can reach from where it stands, including over steps and
// stairs, and how far each is from a given one.
class HuntGround {
public:
    // doors_open: the world without doors, so that places behind them count.
    HuntGround(const WalkerWorld& doors_open, const Vec3& feet_m, const WalkerSize& body);
    // One of the places, at least `least_m` on foot from the start if possible; otherwise the farthest. The same number
    // gives the same place.
    Vec3 hiding_place(std::uint64_t number, double least_m) const;
    // From now on, distances are measured to this place.
    void aim(const Vec3& feet_m);
    // Distance on foot from there to the aim; no value: no route is known.
    std::optional<double> way_m(const Vec3& feet_m) const;
    // The farthest place on the route to the aim to which a straight walk is possible from there; no value: no route is
    // known.
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

// True if a walker or a hand at that place has found the clock: within a step, with nothing in between.
bool finds(const WalkerWorld& world, const Vec3& feet_m, const Vec3& clock_feet_m);

}  // namespace handrail::core
