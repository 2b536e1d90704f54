// Divides a floor without furniture into places: by walls, by the rooms that the file states, the ground outside, and
// the straight stretches of corridors. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

struct OpenPlaces {
    // The place of each span; kNothing: the span belongs to a door, to stairs or to a liquid.
    std::vector<std::uint32_t> of_span;
    std::vector<std::string> names;        // of each place, as the file states it; may be empty
    std::vector<std::uint32_t> of_stated;  // the place of each entry of StatedBuilding::rooms; kNothing: none
    std::uint32_t outside = kNothing;      // the place that is the ground added by a reader
};

// `walls` is the floor without furniture, `cell_area_m2` the area of one of its cells, and `radius_m` the walker's
// radius. The time is proportional to n log n for n spans. After a stop request the result is not usable.
OpenPlaces open_places(const Scene& scene, const SpanGrid<WallSpan>& walls, double cell_area_m2, double radius_m,
                       const std::stop_token& stop);

}  // namespace handrail::navigation
