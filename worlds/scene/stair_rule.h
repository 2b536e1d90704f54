// Determines how a walker climbs stairs that the file states. On stairs the walker has a narrow foot and a bowed head,
// and can climb steps that would stop them elsewhere. So treads that are narrower than the walker's body carry the
// walker, and railings and the edge of the floor above do not stop the walker. Routes, walkers and directions all use
// this rule. Pure functions; any thread may call them. For a scene without stated stairs, construction scans the
// portals once; each stated flight costs a scan of all solids.
#pragma once

#include <algorithm>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail {

inline constexpr double kStairReach_m = 0.05;  // half the width of a foot: the walker's radius on stairs
inline constexpr double kStairHeight_m = 1.6;  // height of a walker with a bowed head
// Height of the highest riser that can be climbed; real models have up to 0.35 m.
inline constexpr double kStairStep_m = 0.4;

class StairRule {
public:
    StairRule() = default;
    explicit StairRule(const Scene& scene);

    bool any() const { return !flights_.empty(); }
    bool is_stairs(FeatureId feature) const { return feature.value < is_stairs_.size() && is_stairs_[feature.value]; }
    // True if the walker has the narrow size relative to this part. That applies to the stairs themselves, and to parts
    // between foot and head of the flight that are above its lower steps, such as the edge of the upper floor. It does
    // not apply to a piece of a wall on top of another piece, because the walker would find a ledge on the lower piece.
    bool narrow(FeatureId feature, const Aabb& box) const;

    // These functions return the walker's size relative to parts for which narrow() is true.
    static double reach_m(double radius_m) { return std::min(radius_m, kStairReach_m); }
    static double height_m(double height_m) { return std::min(height_m, kStairHeight_m); }
    // Returns the height of the highest step that the walker can climb from or to stairs.
    static double step_m(double step_up_m) { return std::max(step_up_m, kStairStep_m); }

private:
    struct Flight {
        Aabb box_m;                // from the foot of the flight up to the floor at its head
        std::vector<Aabb> wide_m;  // walls next to the flight, for which the walker has the whole width of the body
    };
    bool above(const Flight& flight, const Aabb& box) const;
    bool on_wall(const Flight& flight, const Aabb& box) const;
    void find_walls(const Scene& scene);

    std::vector<bool> is_stairs_;  // indexed by feature; empty if there are no stairs
    std::vector<Flight> flights_;
};

}  // namespace handrail
