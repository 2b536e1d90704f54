// Heights of the walker's body that several features use. Plain numbers; any thread.
#pragma once

namespace handrail::core {

// Metres above the soles. Lines that look for doors, walls and things begin here, and distances on foot too.
inline constexpr double kWaist_m = 1.0;

}  // namespace handrail::core
