// Rounds the convex edges of a building's solids for the hand. A rounded solid is the union of all balls of
// the rounding's radius that fit inside the solid: faces stay where they are, edges and corners become round. Where a
// neighbour wholly covers a face, the solid is first extended into the neighbour, so that flush surfaces stay flush. If
// an extension is impossible and a groove would open between two solids, both stay sharp. In an inner corner, a gap
// narrower than the rounding may remain. A proxy with at least the rounding's radius does not feel it. Background
// thread; about 0.1 ms per solid.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail::compile {

struct RoundingReport {
    static constexpr std::size_t kMostNames = 3;
    // Greatest number of solids in a scene that is rounded. If there are more, all stay sharp, because rounding takes
    // some 40 us per solid.
    static constexpr std::size_t kMostRounded = 100'000;
    double radius_m = 0.0;    // the requested radius
    std::size_t rounded = 0;  // number of rounded solids
    std::size_t less = 0;     // how many of the rounded solids have a smaller radius, a quarter of their thickness
    // Number of solids that stay sharp because a quarter of their thickness is less than a quarter of the requested
    // radius.
    std::size_t too_thin = 0;
    std::size_t at_seams = 0;  // number of solids that stay sharp because a groove would open to a neighbour
    std::size_t too_many = 0;  // number of solids if it exceeds kMostRounded, so that all stay sharp; otherwise 0
    // Names of the first few solids in too_thin, and of the first few in at_seams.
    std::vector<std::string> thin_names, seam_names;

    RoundingReport& operator+=(const RoundingReport& other);
    // Returns sentences for the honesty report, or none if no rounding was requested.
    std::vector<std::string> sentences() const;
};

// A solid as the hand feels it. `planes` are those of the world file, except where a neighbour covers a face.
// `rounding_m` is the radius of the solid's edges; 0: sharp, as in the world file.
struct RoundedSolid {
    std::vector<Plane> planes;
    Aabb bounds_m;
    double rounding_m = 0.0;
};

// How solids are rounded for which the map states a radius of their own.
struct OwnRounding {
    double world_m_per_hand_m = 0.0;  // scale of the hand; 0: these solids are rounded like all others
    double most_m = 0.0;              // greatest radius in world metres
    bool operator==(const OwnRounding&) const = default;
};
// Returns true if the scene, or a model in it, has a solid with a radius of its own.
bool has_own_rounding(const Scene& scene);

// Converts a rounding in millimetres at the hand to world metres. Returns 0 (sharp edges) at scales for details, closer
// to 1:15 than to 1:60, because the person then explores the edges themselves.
double edge_rounding_m(double rounding_hand_mm, double world_m_per_hand_m);

// Returns one rounded solid for each solid of the scene. Returns an empty vector if there are too many solids or if a
// stop was requested. Only touchable solids with flat faces are rounded, not soft ones, exact round shapes or volumes.
// A solid with a radius of its own gets that radius instead of `radius_m`.
std::vector<RoundedSolid> round_edges(const Scene& scene, double radius_m, RoundingReport& report,
                                      const std::stop_token& stop = {}, const OwnRounding& own = {});

}  // namespace handrail::compile
