// The places that a floor without furniture falls into: what walls keep apart, what the file states as rooms, the
// ground outside, and the straight stretches of corridors. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "worlds/navigation/walk_space.h"

namespace handrail {

struct OpenPlaces {
    std::vector<std::uint32_t> of_span;    // the place of each span; kNothing: of a door, of stairs, in a liquid
    std::vector<std::string> names;        // of each place, as the file has it; may be empty
    std::vector<std::uint32_t> of_stated;  // the place of each of StatedBuilding::rooms; kNothing: none
    std::uint32_t outside = kNothing;      // the place that is the ground which a reader added
};

// walls: the floor without furniture. cell_area_m2: of one of its cells. radius_m: of the body. Goes with the number of
// spans times its logarithm. What is left is of no use once a stop was requested.
OpenPlaces open_places(const Scene& scene, const SpanGrid<WallSpan>& walls, double cell_area_m2, double radius_m,
                       const std::stop_token& stop);

}  // namespace handrail
