// How a body climbs stairs that the file states: on a narrow foot, with a bowed head, and over steps that would stop it
// elsewhere. Treads narrower than the body then carry it, and railings and the edge of the floor above let it pass.
// Routes, walkers and directions in words all use this rule. Pure; any thread. A scene without stated stairs costs one
// look at its portals; stated stairs cost a look at all solids each.
#pragma once

#include <algorithm>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail {

inline constexpr double kStairReach_m = 0.05;  // from the middle of the body to its sides: half the width of a foot
inline constexpr double kStairHeight_m = 1.6;  // of somebody who bows their head
inline constexpr double kStairStep_m = 0.4;    // the highest riser that is climbed; real models have up to 0.35 m

class StairRule {
public:
    StairRule() = default;
    explicit StairRule(const Scene& scene);

    bool any() const { return !flights_.empty(); }
    bool is_stairs(FeatureId feature) const { return feature.value < is_stairs_.size() && is_stairs_[feature.value]; }
    // True if a body meets this part as it does stairs: a part of them, or one between their foot and their head that
    // is above their lower steps, such as the edge of the upper floor. A piece of a wall that stands on the piece below
    // it is no such part: the body would find a ledge on the lower one.
    bool narrow(FeatureId feature, const Aabb& box) const;

    // The size of a body against such a part.
    static double reach_m(double radius_m) { return std::min(radius_m, kStairReach_m); }
    static double height_m(double height_m) { return std::min(height_m, kStairHeight_m); }
    // How high a step from or to stairs is climbed.
    static double step_m(double step_up_m) { return std::max(step_up_m, kStairStep_m); }

private:
    struct Flight {
        Aabb box_m;                // from the foot to the floor at the head
        std::vector<Aabb> wide_m;  // walls next to it, which a body meets with its whole width
    };
    bool above(const Flight& flight, const Aabb& box) const;
    bool on_wall(const Flight& flight, const Aabb& box) const;
    void find_walls(const Scene& scene);

    std::vector<bool> is_stairs_;  // of each feature; empty: there are no stairs
    std::vector<Flight> flights_;
};

}  // namespace handrail
