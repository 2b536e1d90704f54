// Which keys a terminal can send at all. A pure function.
#pragma once

#include <string_view>

namespace handrail {

// Whether a terminal can send the key: no lone modifier, nothing of the keypad, and none that a control character, a
// signal or a sign stands for ("Control+I" is Tab, "Control+C" ends the program, "Control+8" is Backspace).
bool terminal_sends(std::string_view key_name);

}  // namespace handrail
