// What the ground does around a walking body: stairs, drops and ramps. Pure functions over an immutable world, world
// metres; app thread. A look ahead costs two rays for every five centimetres.
#pragma once

#include <optional>

#include "app/core/world/walker.h"

namespace handrail {

// What counts as what, for a body of this size: in games people jump down what would be a fall in a building.
struct GroundRules {
    BodySize body;
    double drop_m = 0.4;  // more than this down is a drop
};
GroundRules ground_rules(const Scene& scene, const BodySize& body);

// Stairs: at least three risers that follow each other.
struct StairsAhead {
    bool up = true;
    int risers = 0;           // in all, or as many as can be seen
    bool whole = true;        // they end at a landing, not at a wall
    double distance_m = 0.0;  // from the middle of the body to the first riser
    double height_m = 0.0;    // of all of them
    Vec3 place_m{0.0};        // of the first riser's edge
};
struct DropAhead {
    double distance_m = 0.0;        // from the middle of the body to the edge
    std::optional<double> depth_m;  // none: no ground within thirty metres
    Vec3 place_m{0.0};              // of the edge
};
struct GroundAhead {
    std::optional<StairsAhead> stairs;  // the nearest
    std::optional<DropAhead> drop;
};

// The ground straight ahead as far as `range_m`, or until something stands in the way. A gap that the body spans is no
// drop.
GroundAhead ground_ahead(const BodyWorld& world, const Vec3& feet_m, double bearing_rad, const GroundRules& rules,
                         double range_m);

// True where the ground under the middle of the body is gone, and will be gone for all of it when it goes on this way.
std::optional<DropAhead> over_drop(const BodyWorld& world, const Vec3& feet_m, double bearing_rad,
                                   const GroundRules& rules);

// How much the ground under the middle of the body rises per metre of this way; 0 where there is none.
double ground_slope(const BodyWorld& world, const Vec3& feet_m, double bearing_rad);

// Between two beats of the warning, for one who is so far from the edge; the warning begins at kDropWarning_m.
inline constexpr double kDropWarning_m = 2.0, kStairsCallout_m = 6.0;
double drop_beat_s(double distance_m);

}  // namespace handrail
