// What the grid of a place (learning.h) and what is learnt on it have in common. Metres, world.
#pragma once

#include <array>
#include <utility>

namespace handrail {

inline constexpr double kSameFloor_m = 0.6;   // floors nearer than this in height are one
inline constexpr double kRoomHeight_m = 2.6;  // what is looked at above a floor
// From a cell to its four neighbours.
inline constexpr std::array kCellWays{std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)};

}  // namespace handrail
