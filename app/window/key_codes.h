// Key codes and modifier bits of X and Wayland, as GLFW's. Both systems use the same modifier bits, those of XKB.
#pragma once

#include <array>

namespace handrail {

inline constexpr unsigned kShiftBit = 1, kControlBit = 4, kAltBit = 8;

unsigned modifier_bits(int glfw_modifiers);
int glfw_modifiers(unsigned modifier_bits);

// GLFW's scancode -> its key token, letters by their labels, 0 if GLFW has none. Modifiers are left out: alone they
// mean something only when they come up again. Reads GLFW's table, so on its thread.
using KeysByCode = std::array<int, 256>;
KeysByCode keys_by_code();

}  // namespace handrail
