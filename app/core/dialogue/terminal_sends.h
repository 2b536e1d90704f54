// Determines which keys a terminal can send. It is a pure function.
#pragma once

#include <string_view>

namespace handrail::core {

// Returns true if a terminal can send the key to the program. No terminal can send a modifier alone or a key of the
// keypad. The result is also false for a key combination that arrives as another key, a control character or a signal.
// "Control+I" arrives as Tab, "Control+C" ends the program, and "Control+8" arrives as Backspace.
bool terminal_sends(std::string_view key_name);

}  // namespace handrail::core
