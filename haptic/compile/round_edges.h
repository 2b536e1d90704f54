// Rounds the convex edges of a building's solids for the hand (S30, G7). A rounded solid is everything that a ball of
// the rounding's radius reaches inside it: faces stay where they are, edges and corners become round. Where a neighbour
// wholly covers a face, the solid is first extended into the neighbour, so that flush surfaces stay flush. If that is
// impossible and a groove would open between two solids, both stay sharp. In an inner corner a gap narrower than the
// rounding may remain, which a proxy of at least that radius does not feel. Background thread; about 0.1 ms a solid.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail::compile {

struct RoundingReport {
    static constexpr std::size_t kMostNames = 3;
    // Most solids of a scene; if there are more, all stay sharp, because each takes some 40 us.
    static constexpr std::size_t kMostRounded = 100'000;
    double radius_m = 0.0;    // the requested radius
    std::size_t rounded = 0;  // number of rounded solids
    std::size_t less = 0;     // how many of these are rounded by less, namely a quarter of their thickness
    // Sharp, because a quarter of their thickness is less than a quarter of the requested radius.
    std::size_t too_thin = 0;
    std::size_t at_seams = 0;  // sharp, because a groove would open to a neighbour
    std::size_t too_many = 0;  // not 0: all are sharp, because this number of solids exceeds kMostRounded
    std::vector<std::string> thin_names, seam_names;  // names of the first few

    RoundingReport& operator+=(const RoundingReport& other);
    // Sentences for the honesty report; none if no rounding was requested.
    std::vector<std::string> sentences() const;
};

// A solid as the hand feels it: its planes, which are where the file has them except where a neighbour covers them, and
// the radius of its edges; 0: sharp, as in the file.
struct RoundedSolid {
    std::vector<Plane> planes;
    Aabb bounds_m;
    double rounding_m = 0.0;
};

// Converts a rounding in millimetres of the hand to world metres. At scales for details, closer to 1:15 than to 1:60,
// edges stay sharp, because edges are then what the person is looking for.
double edge_rounding_m(double rounding_hand_mm, double world_m_per_hand_m);

// Returns one for each solid of the scene; none at all if there are too many, or if a stop was requested. Rounds
// touchable solids with flat faces, but not soft ones, exact round shapes or volumes.
std::vector<RoundedSolid> round_edges(const Scene& scene, double radius_m, RoundingReport& report,
                                      const std::stop_token& stop = {});

}  // namespace handrail::compile
