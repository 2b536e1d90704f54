// Limits the ground outside to the part near the building. A reader lays the ground around everything in the file, but
// only the part near the building and its paths is useful for rooms and routes. Only walk_space uses this class. It
// costs one bit for each square of the ground, at most four million bits.
#pragma once

#include <vector>

#include "worlds/navigation/walk_obstacles.h"

namespace handrail::navigation {

class NearGround {
public:
    // Leaves out ground that is farther than `within_m` from the boxes of all other objects. Neighbouring buildings are
    // not such objects.
    NearGround(const Scene& scene, const Obstacles& obstacles, double within_m);

    // Returns true if the obstacle is ground, and that ground is left out at `at_m`.
    bool leaves_out(std::uint32_t obstacle, const Vec2& at_m) const;
    double within_m() const { return within_m_; }

private:
    double within_m_;
    std::vector<bool> is_ground_;  // for each obstacle: whether it is ground; empty: there is no ground
    Vec2 least_{0.0};
    double square_m_ = 1.0;
    std::size_t wide_ = 0, deep_ = 0;
    std::vector<bool> near_;  // for each square: whether its ground is kept
};

}  // namespace handrail::navigation
