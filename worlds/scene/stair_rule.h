// How a walker climbs stairs that the file states: with a narrow foot, a bowed head, and over steps that would stop
// them elsewhere. So treads narrower than the body carry the walker, and railings and the edge of the floor above do
// not stop them. Routes, walkers and directions all use this rule. Pure; any thread. A scene without stated stairs
// costs one scan of its portals; each stated flight costs a scan of all solids.
#pragma once

#include <algorithm>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail {

inline constexpr double kStairReach_m = 0.05;  // from the middle of the walker to their sides: half the width of a foot
inline constexpr double kStairHeight_m = 1.6;  // height of a walker who bows their head
inline constexpr double kStairStep_m = 0.4;    // the highest riser that can be climbed; real models have up to 0.35 m

class StairRule {
public:
    StairRule() = default;
    explicit StairRule(const Scene& scene);

    bool any() const { return !flights_.empty(); }
    bool is_stairs(FeatureId feature) const { return feature.value < is_stairs_.size() && is_stairs_[feature.value]; }
    // True if the walker meets this part with the narrow size. This applies to the stairs themselves, and to parts
    // above their lower steps and between foot and head, such as the edge of the upper floor. It does not apply to a
    // piece of a wall on top of another piece, because the walker would find a ledge on the lower one.
    bool narrow(FeatureId feature, const Aabb& box) const;

    // The walker's size against such a part.
    static double reach_m(double radius_m) { return std::min(radius_m, kStairReach_m); }
    static double height_m(double height_m) { return std::min(height_m, kStairHeight_m); }
    // The highest step that the walker can climb from or to stairs.
    static double step_m(double step_up_m) { return std::max(step_up_m, kStairStep_m); }

private:
    struct Flight {
        Aabb box_m;                // from the foot to the floor at the head
        std::vector<Aabb> wide_m;  // walls next to the flight, which the walker meets with the whole width of the body
    };
    bool above(const Flight& flight, const Aabb& box) const;
    bool on_wall(const Flight& flight, const Aabb& box) const;
    void find_walls(const Scene& scene);

    std::vector<bool> is_stairs_;  // indexed by feature; empty: there are no stairs
    std::vector<Flight> flights_;
};

}  // namespace handrail
