// Writes what was said, played and felt in a session on the virtual clock as a text. People can read the text, and the
// texts of two program versions can be compared byte for byte. Pure functions.
#pragma once

#include <string>

#include "app/core/scenario/session_log.h"

namespace handrail::program {

// Returns a text with one line for each sentence ("   1.250 say ..."), each sound and each change of a loop, in the
// order of time. Every tenth of a second, a line contains the positions of the walker and the hand. Each such line ends
// in a checksum of all ticks until then, a thousand a second. So the texts of two sessions differ if the sessions
// differ anywhere. Numbers read back bit for bit. Seconds, metres, newtons, radians; world axes. The text ends in a
// line feed.
std::string transcript(const core::SessionLog& log);

}  // namespace handrail::program
