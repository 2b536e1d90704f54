// How far out the ground outside is walked on: a reader lays it round everything that is in the file, but only what is
// near the building and its paths matters for rooms and routes. For walk_space only. Costs a bit for each small square
// of the ground, at most four million.
#pragma once

#include <vector>

#include "worlds/navigation/walk_obstacles.h"

namespace handrail {

class NearGround {
public:
    // Ground farther than `within_m` from the boxes of everything else, neighbouring buildings excepted, is left out.
    NearGround(const Scene& scene, const Obstacles& obstacles, double within_m);

    // True if that obstacle is ground which is left out there.
    bool leaves_out(std::uint32_t obstacle, const Vec2& at_m) const;
    double within_m() const { return within_m_; }

private:
    double within_m_;
    std::vector<bool> is_ground_;  // of each obstacle; empty: there is none
    Vec2 least_{0.0};
    double square_m_ = 1.0;
    std::size_t wide_ = 0, deep_ = 0;
    std::vector<bool> near_;  // of each square
};

}  // namespace handrail
