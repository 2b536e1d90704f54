// Divides a floor without furniture into places. Places end at walls, at the borders of rooms that the file states, and
// at the ground outside. Long corridors are divided into straight stretches. Pure functions; any thread may call them.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

struct OpenPlaces {
    // For each span: the place that contains it. kNothing: the span belongs to a door, to stairs or to a liquid.
    std::vector<std::uint32_t> of_span;
    std::vector<std::string> names;        // name of each place in the file; may be empty
    std::vector<std::uint32_t> of_stated;  // for each entry of StatedBuilding::rooms: its place; kNothing: none
    std::uint32_t outside = kNothing;      // the place that consists of the ground added by a reader
};

// `walls` is the floor without furniture, `cell_area_m2` the area of one of its cells, and `radius_m` the walker's
// radius. The time is proportional to n log n for n spans. If `stop` was requested, the result is incomplete and must
// not be used.
OpenPlaces open_places(const Scene& scene, const SpanGrid<WallSpan>& walls, double cell_area_m2, double radius_m,
                       const std::stop_token& stop);

}  // namespace handrail::navigation
