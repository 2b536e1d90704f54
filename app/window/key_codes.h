// Converts key codes and modifier bits of X and Wayland to those of GLFW. Both systems use the modifier bits of XKB.
#pragma once

#include <array>

namespace handrail::window {

inline constexpr unsigned kShiftBit = 1, kControlBit = 4, kAltBit = 8;

unsigned modifier_bits(int glfw_modifiers);
int glfw_modifiers(unsigned modifier_bits);

// For each of GLFW's scancodes: GLFW's key token. The token of a letter key follows the key's label. 0: GLFW has no
// token for the key. Modifier keys have no token here, because a modifier that is pressed alone acts only on its
// release. Call keys_by_code() on GLFW's thread, because it reads GLFW's table.
using KeysByCode = std::array<int, 256>;
KeysByCode keys_by_code();

}  // namespace handrail::window
