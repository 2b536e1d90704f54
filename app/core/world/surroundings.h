// Finds what is around a walker by rays through the scene. It finds only what is in line of sight. Pure functions over
// an immutable world, for the app thread.
#pragma once

#include <optional>
#include <vector>

#include "app/core/world/walker_world.h"

namespace handrail::core {

// The surface that a ray in one direction hits.
struct Seen {
    double bearing_rad = 0.0;  // heading of the ray in the world
    double distance_m = 0.0;   // distance from the walker's centre to the surface
    FeatureId feature = kNoFeature;
    Vec3 point_m{0.0};
};

inline constexpr double kSightRange_m = 100.0;

// Returns the point of a box that is nearest to `to_m`.
inline Vec3 nearest_place(const Aabb& box, const Vec3& to_m) { return glm::clamp(to_m, box.min_m, box.max_m); }

// For a walker inside a solid, returns the nearest place where the walker overlaps nothing, within 12 m horizontally
// and 3 m vertically. Returns no value if there is no such place.
std::optional<Vec3> nearest_free_feet(const WalkerWorld& world, const Vec3& feet_m, const WalkerShape& body);

// Returns the first surface in this direction, along a horizontal ray at `height_m` above the soles. Returns no value
// if nothing is within range.
std::optional<Seen> look(const WalkerWorld& world, const Vec3& feet_m, double height_m, double bearing_rad,
                         double range_m = kSightRange_m);

// The size of the free space around a walker: width across the heading, depth along it. A value of 0 means that a side
// is open.
struct FreeSpace {
    double width_m = 0.0, depth_m = 0.0;
};
FreeSpace free_space(const WalkerWorld& world, const Vec3& feet_m, double height_m, double heading_rad);

// Returns doors, landmarks, clues, liquids and named objects of which at least one point is in line of sight, the
// nearest first, at most `most`. For each of them, it tries the middle, the nearest point and the middles of the sides.
// It uses at most kMostRays rays, and writes the number of used rays to `rays`. If all rays have been used, farther
// things are left out.
inline constexpr int kMostRays = 2000;
std::vector<Seen> things_in_sight(const WalkerWorld& world, const Vec3& feet_m, double height_m, std::size_t most,
                                  int* rays = nullptr);

// Returns the nearest surface within range in the half circle ahead, for the wall tone.
std::optional<Seen> nearest_ahead(const WalkerWorld& world, const Vec3& feet_m, double height_m, double heading_rad,
                                  double range_m);

}  // namespace handrail::core
