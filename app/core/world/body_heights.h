// Defines heights of the walker's body that several features use. Plain numbers, which any thread may use.
#pragma once

namespace handrail::core {

// Metres above the soles. Rays that search for doors, walls and things start at this height. Distances on foot are also
// measured at this height.
inline constexpr double kWaist_m = 1.0;

}  // namespace handrail::core
