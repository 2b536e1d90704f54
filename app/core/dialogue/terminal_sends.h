// Which keys a terminal can send. A pure function.
#pragma once

#include <string_view>

namespace handrail::core {

// True if a terminal can send the key. It cannot send a modifier alone or a key of the keypad. Some keys also arrive as
// a control character, a signal or another key: "Control+I" is Tab, "Control+C" ends the program, "Control+8" is
// Backspace.
bool terminal_sends(std::string_view key_name);

}  // namespace handrail::core
