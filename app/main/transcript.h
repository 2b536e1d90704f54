// What was said, played and felt in a session on the virtual clock, as text for people and for a comparison of two
// program versions byte for byte. Pure functions.
#pragma once

#include <string>

#include "app/core/scenario/session_log.h"

namespace handrail::program {

// One line for each sentence ("   1.250 say ..."), each sound and each change of a loop, in the order of time. Every
// tenth of a second a line says where the walker and the hand are. Numbers read back bit for bit. Each of these lines
// ends in a checksum of all ticks until then (a thousand a second), so two sessions that differ anywhere differ in
// their text. Seconds, metres, newtons, radians; world axes. Ends in a line feed.
std::string transcript(const core::SessionLog& log);

}  // namespace handrail::program
