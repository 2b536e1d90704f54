// Draws the edges of floors that end without a wall, such as platforms and balconies, as rows of short lines. Pure
// functions; any thread may call them.
#pragma once

#include <cstdint>
#include <vector>

#include "worlds/exports/places.h"
#include "worlds/exports/wall_ink.h"
#include "worlds/plan/room_borders.h"

namespace handrail::exports {

struct EdgeInk {
    std::vector<plan::PlanBox> lines;
    std::vector<std::uint32_t> rooms;  // indices in Storey::rooms of the rooms whose edges have at least one line
};
inline constexpr double kEdgeLine_mm = 4.0;
// Returns lines along the edges, `line_mm` wide, with `clear_mm` between them. Marks the area of the lines in `places`
// as used. There are no lines at routes to another storey, around flights of stairs, or around the ground outside.
// `rooms`: see rooms_on.
EdgeInk edge_lines(const plan::Storey& storey, const OnPaper& on_paper, const plan::RoomGrid& rooms, Places& places,
                   double line_mm, double clear_mm);

}  // namespace handrail::exports
