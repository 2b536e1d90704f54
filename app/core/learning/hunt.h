// The hunt: a clock is hidden somewhere one can walk to, ticks, and is found by going or reaching there. Pure logic;
// app thread; world metres.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/core/world/walker.h"

namespace handrail {

// Places a quarter of a metre apart that a body gets to from where it stands, steps and stairs included, and how far
// each is from one of them.
class HuntGround {
public:
    // doors_open: a world whose doors are not there, so that what lies behind them counts.
    HuntGround(const BodyWorld& doors_open, const Vec3& feet_m, const BodySize& body);
    // One of the places, at least `least_m` from the start on foot where there is one; the farthest else. The same
    // number gives the same place.
    Vec3 hiding_place(std::uint64_t number, double least_m) const;
    // From now on, distances are to this place.
    void aim(const Vec3& feet_m);
    // On foot from there to the aim; none: no way is known from there.
    std::optional<double> way_m(const Vec3& feet_m) const;
    // The farthest place on the way to the aim that can be walked to straight from there; none: no way is known.
    std::optional<Vec3> next_m(const BodyWorld& doors_open, const Vec3& feet_m, const BodySize& body) const;
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

// True where a body there, or a hand, has found it: within a step, with nothing in between.
bool finds(const BodyWorld& world, const Vec3& feet_m, const Vec3& clock_feet_m);

}  // namespace handrail
