// Defines the constants of the grid of a place (learning.h) and of the progress on it, in world metres.
#pragma once

#include <array>
#include <utility>

namespace handrail::core {

inline constexpr double kSameFloor_m = 0.6;   // floors whose heights differ by less than this are the same floor
inline constexpr double kRoomHeight_m = 2.6;  // the space above a floor is examined up to this height
// Offsets from a cell to its four neighbours.
inline constexpr std::array kCellWays{std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)};

}  // namespace handrail::core
