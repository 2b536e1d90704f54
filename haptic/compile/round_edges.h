// Rounds the convex edges of a building's solids as a hand should feel them (S30, G7). A solid becomes all that a ball
// of the rounding's radius reaches inside it: faces stay where they are, edges and corners turn round. Where a
// neighbour wholly covers a face, the solid first goes on into the neighbour, so that what is flush stays flush; where
// that cannot be and a groove would open between two solids, both stay sharp. In an inner corner a gap narrower than
// the rounding may stay, which no ball of at least that radius feels. Worker thread; about 0.1 ms a solid.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail {

struct RoundingReport {
    static constexpr std::size_t kMostNames = 3;
    static constexpr std::size_t kMostRounded =
        100'000;               // solids of a scene; of more all stay sharp: it takes some 40 us for each
    double radius_m = 0.0;     // what was asked for
    std::size_t rounded = 0;   // solids
    std::size_t less = 0;      // of them: rounded by less, a quarter of their thickness
    std::size_t too_thin = 0;  // sharp: a quarter of their thickness is less than a quarter of what was asked for
    std::size_t at_seams = 0;  // sharp: a groove would open to a neighbour
    std::size_t too_many = 0;  // all sharp: so many solids are more than kMostRounded
    std::vector<std::string> thin_names, seam_names;  // of the first few

    RoundingReport& operator+=(const RoundingReport& other);
    // For the honesty report; none when nothing was asked for.
    std::vector<std::string> sentences() const;
};

// A solid as it is felt: its planes, which lie where the file has them but where a neighbour covers them, and the
// radius of its edges; 0: sharp, as filed.
struct RoundedSolid {
    std::vector<Plane> planes;
    Aabb bounds_m;
    double rounding_m = 0.0;
};

// World metres of a rounding given in millimetres of the hand. At scales for details, closer to 1:15 than to 1:60,
// edges are sharp: they are what is looked for.
double edge_rounding_m(double rounding_hand_mm, double world_m_per_hand_m);

// One for each solid of the scene; none at all where they are too many, or a stop was asked for meanwhile. Touchable
// solids of flat faces are rounded; soft ones, exact round shapes and volumes are not.
std::vector<RoundedSolid> round_edges(const Scene& scene, double radius_m, RoundingReport& report,
                                      const std::stop_token& stop = {});

}  // namespace handrail
