// The ground around a walker: stairs, drops and ramps. Pure functions over an immutable world, world metres; app
// thread. Looking ahead costs two rays for every five centimetres.
#pragma once

#include <optional>

#include "app/core/world/walker.h"

namespace handrail::core {

// Limits for a walker of this size. In games, people jump down what would be a fall in a building.
struct GroundRules {
    WalkerSize body;
    double drop_m = 0.4;  // a larger step down is a drop
};
GroundRules ground_rules(const Scene& scene, const WalkerSize& body);

// Stairs: at least three consecutive risers.
struct StairsAhead {
    bool up = true;
    int risers = 0;           // total, or as many as can be seen
    bool whole = true;        // they end at a landing, not at a wall
    double distance_m = 0.0;  // from the walker's centre to the first riser
    double height_m = 0.0;    // of all risers
    Vec3 place_m{0.0};        // edge of the first riser
};
struct DropAhead {
    double distance_m = 0.0;        // from the walker's centre to the edge
    std::optional<double> depth_m;  // none: no ground within thirty metres
    Vec3 place_m{0.0};              // of the edge
};
struct GroundAhead {
    std::optional<StairsAhead> stairs;  // the nearest
    std::optional<DropAhead> drop;
};

// Examines the ground straight ahead up to `range_m`, or until something blocks. A gap that the walker spans is not a
// drop.
GroundAhead ground_ahead(const WalkerWorld& world, const Vec3& feet_m, double bearing_rad, const GroundRules& rules,
                         double range_m);

// Returns a value if there is no ground under the walker's centre, nor for the rest of it as it goes on in this
// direction.
std::optional<DropAhead> over_drop(const WalkerWorld& world, const Vec3& feet_m, double bearing_rad,
                                   const GroundRules& rules);

// Rise of the ground under the walker's centre per metre in this direction; 0 if there is no ground.
double ground_slope(const WalkerWorld& world, const Vec3& feet_m, double bearing_rad);

// Seconds between two beats of the warning at this distance from the edge; the warning begins at kDropWarning_m.
inline constexpr double kDropWarning_m = 2.0, kStairsCallout_m = 6.0;
double drop_beat_s(double distance_m);

}  // namespace handrail::core
