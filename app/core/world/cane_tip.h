// Finds what the tip of a virtual white cane meets. The cane is held with the grip in front of the body and its tip on
// the ground ahead, so it meets what stands on the ground, and misses what hangs higher than its shaft. Pure functions
// over an immutable world in world metres, for the app thread. One call costs at most five rays.
#pragma once

#include <optional>

#include "app/core/world/hazards.h"

namespace handrail::core {

enum class CaneMeets : std::uint8_t {
    Ground,    // level ground, or a ramp
    Higher,    // the top of a step up
    Lower,     // the ground behind a step down
    Drop,      // the ground is farther down than a step, or there is none
    Obstacle,  // something that the walker cannot step onto
};

struct CaneTip {
    CaneMeets meets = CaneMeets::Ground;
    Vec3 place_m{0.0};              // where the tip is; for a drop, where it would be on level ground
    std::optional<double> depth_m;  // for a drop: its depth; no value: there is no ground within thirty metres
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
};

// Returns the horizontal distance from the walker's centre to the tip on level ground.
double cane_reach_m(double length_m);
// Puts the tip on the ground in the direction `bearing_rad`. If `lifted`, the tip passes just above the ground and can
// only meet an obstacle or a step up; the result is Ground if it meets nothing.
CaneTip put_cane(const WalkerWorld& world, const Vec3& feet_m, double bearing_rad, double length_m,
                 const GroundRules& rules, bool lifted = false);

}  // namespace handrail::core
