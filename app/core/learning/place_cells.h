// Constants of the grid of a place (learning.h) and of what is learnt on it. Metres, world.
#pragma once

#include <array>
#include <utility>

namespace handrail::core {

inline constexpr double kSameFloor_m = 0.6;   // floors closer in height count as one
inline constexpr double kRoomHeight_m = 2.6;  // height above a floor that is examined
// Steps from a cell to its four neighbours.
inline constexpr std::array kCellWays{std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)};

}  // namespace handrail::core
