// Key codes and modifier bits of X and Wayland as those of GLFW. Both systems use the modifier bits of XKB.
#pragma once

#include <array>

namespace handrail::window {

inline constexpr unsigned kShiftBit = 1, kControlBit = 4, kAltBit = 8;

unsigned modifier_bits(int glfw_modifiers);
int glfw_modifiers(unsigned modifier_bits);

// Maps GLFW's scancodes to its key tokens, letters by their labels; 0 if GLFW has no token. Modifier keys are left out,
// as a modifier pressed alone acts only on its release. Call it on GLFW's thread, whose table it reads.
using KeysByCode = std::array<int, 256>;
KeysByCode keys_by_code();

}  // namespace handrail::window
