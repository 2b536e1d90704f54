// What is around a walker: rays through the scene, line of sight only. Pure functions over an immutable world; app
// thread.
#pragma once

#include <optional>
#include <vector>

#include "app/core/world/walker_world.h"

namespace handrail::core {

// Something hit in a direction.
struct Seen {
    double bearing_rad = 0.0;  // world heading of the direction
    double distance_m = 0.0;   // from the walker's centre to the surface
    FeatureId feature = kNoFeature;
    Vec3 point_m{0.0};
};

inline constexpr double kSightRange_m = 100.0;

// The point of a box nearest to another place.
inline Vec3 nearest_place(const Aabb& box, const Vec3& to_m) { return glm::clamp(to_m, box.min_m, box.max_m); }

// The nearest place for a walker that stands inside a solid, within 12 m around and 3 m up and down, where it overlaps
// nothing. No value: there is none.
std::optional<Vec3> nearest_free_feet(const WalkerWorld& world, const Vec3& feet_m, const WalkerShape& body);

// The first surface in that direction, level, at `height_m` above the soles; no value: nothing within range.
std::optional<Seen> look(const WalkerWorld& world, const Vec3& feet_m, double height_m, double bearing_rad,
                         double range_m = kSightRange_m);

// Size of the free space: width across the heading and depth along it; 0 if a side is open.
struct FreeSpace {
    double width_m = 0.0, depth_m = 0.0;
};
FreeSpace free_space(const WalkerWorld& world, const Vec3& feet_m, double height_m, double heading_rad);

// Doors, landmarks, clues, liquids and named objects of which some point is in line of sight, nearest first, at most
// `most`. Tries the middle first, then the nearest point, then the middles of the sides. It uses at most kMostRays
// rays, whose number `rays` receives. If those are used up, farther things are left out.
inline constexpr int kMostRays = 2000;
std::vector<Seen> things_in_sight(const WalkerWorld& world, const Vec3& feet_m, double height_m, std::size_t most,
                                  int* rays = nullptr);

// The nearest surface in the half circle ahead within range, for the wall tone.
std::optional<Seen> nearest_ahead(const WalkerWorld& world, const Vec3& feet_m, double height_m, double heading_rad,
                                  double range_m);

}  // namespace handrail::core
