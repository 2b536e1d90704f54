// Limits how far out the ground outside is walked on. A reader lays the ground around everything in the file, but only
// the part near the building and its paths matters for rooms and routes. Used by walk_space only. Costs a bit for each
// small square of the ground, at most four million.
#pragma once

#include <vector>

#include "worlds/navigation/walk_obstacles.h"

namespace handrail::navigation {

class NearGround {
public:
    // Leaves out ground farther than `within_m` from the boxes of everything else, except neighbouring buildings.
    NearGround(const Scene& scene, const Obstacles& obstacles, double within_m);

    // Returns true if the obstacle is ground that is left out at that place.
    bool leaves_out(std::uint32_t obstacle, const Vec2& at_m) const;
    double within_m() const { return within_m_; }

private:
    double within_m_;
    std::vector<bool> is_ground_;  // for each obstacle; empty: there is no ground
    Vec2 least_{0.0};
    double square_m_ = 1.0;
    std::size_t wide_ = 0, deep_ = 0;
    std::vector<bool> near_;  // for each square
};

}  // namespace handrail::navigation
