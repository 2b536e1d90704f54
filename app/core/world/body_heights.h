// Heights of the walker's body that several features use. Plain numbers; any thread.
#pragma once

namespace handrail::core {

// Metres above the soles. Rays that search for doors, walls and things start at this height, and so do distances on
// foot.
inline constexpr double kWaist_m = 1.0;

}  // namespace handrail::core
