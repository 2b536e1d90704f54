// The edges of floors that end without a wall, such as platforms and balconies, as rows of short lines. Pure functions;
// any thread.
#pragma once

#include <cstdint>
#include <vector>

#include "worlds/exports/places.h"
#include "worlds/exports/wall_ink.h"
#include "worlds/plan/room_borders.h"

namespace handrail::exports {

struct EdgeInk {
    std::vector<plan::PlanBox> lines;
    std::vector<std::uint32_t> rooms;  // places in Storey::rooms whose edge has some of them
};
inline constexpr double kEdgeLine_mm = 4.0;
// Lines of that length along the edges, `line_mm` wide, with `clear_mm` between them; each takes its place. There are
// none where a route leads to another storey, and none around flights of stairs and the ground outside. `rooms`: see
// rooms_on.
EdgeInk edge_lines(const plan::Storey& storey, const OnPaper& on_paper, const plan::RoomGrid& rooms, Places& places,
                   double line_mm, double clear_mm);

}  // namespace handrail::exports
