// Heights of a body that many ask by. Plain numbers; any thread.
#pragma once

namespace handrail {

// Metres above the soles from which is looked for doors, walls and things, and at which distances on foot begin.
inline constexpr double kWaist_m = 1.0;

}  // namespace handrail
