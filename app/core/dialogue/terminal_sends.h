// Tells which keys a terminal can send. A pure function.
#pragma once

#include <string_view>

namespace handrail::core {

// True if a terminal can send the key to the program. No terminal can send a modifier alone or a key of the keypad.
// Some key combinations arrive as another key, a control character or a signal, and do not count: "Control+I" is Tab,
// "Control+C" ends the program, "Control+8" is Backspace.
bool terminal_sends(std::string_view key_name);

}  // namespace handrail::core
