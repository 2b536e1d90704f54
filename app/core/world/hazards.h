// Examines the ground around a walker: stairs, drops and ramps. Pure functions over an immutable world in world metres,
// for the app thread. Looking ahead costs two rays for every five centimetres.
#pragma once

#include <optional>

#include "app/core/world/walker.h"

namespace handrail::core {

// Limits for a walker of the size `body`. The limits differ in games, where people jump down from heights that would be
// a fall in a building.
struct GroundRules {
    WalkerSize body;
    double drop_m = 0.4;  // a step down of more than this is a drop
};
GroundRules ground_rules(const Scene& scene, const WalkerSize& body);

// Stairs ahead of the walker, with at least three consecutive risers.
struct StairsAhead {
    bool up = true;
    int risers = 0;           // number of risers, as far as they are visible
    bool whole = true;        // true: the stairs end at a landing, not at a wall
    double distance_m = 0.0;  // distance from the walker's centre to the first riser
    double height_m = 0.0;    // height of all risers together
    Vec3 place_m{0.0};        // a point on the edge of the first riser
};
struct DropAhead {
    double distance_m = 0.0;        // distance from the walker's centre to the edge
    std::optional<double> depth_m;  // none: there is no ground within thirty metres
    Vec3 place_m{0.0};              // a point on the edge
};
struct GroundAhead {
    std::optional<StairsAhead> stairs;  // the nearest stairs
    std::optional<DropAhead> drop;
};

// Examines the ground straight ahead up to `range_m`, or until something blocks the way. A gap that the walker can step
// over is not a drop.
GroundAhead ground_ahead(const WalkerWorld& world, const Vec3& feet_m, double bearing_rad, const GroundRules& rules,
                         double range_m);

// Returns a value if there is no ground under the walker's centre. There must also be no ground for the rest of the
// walker if it moves on in this direction.
std::optional<DropAhead> over_drop(const WalkerWorld& world, const Vec3& feet_m, double bearing_rad,
                                   const GroundRules& rules);

// Returns how many metres the ground under the walker's centre rises per metre in this direction. Returns 0 if there is
// no ground.
double ground_slope(const WalkerWorld& world, const Vec3& feet_m, double bearing_rad);

// Returns the seconds between two beats of the warning at this distance from the edge. The warning begins at
// kDropWarning_m.
inline constexpr double kDropWarning_m = 2.0, kStairsCallout_m = 6.0;
double drop_beat_s(double distance_m);

}  // namespace handrail::core
