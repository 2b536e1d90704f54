// What was said, played and felt in a session on the virtual clock, as text for people and for comparing two versions
// of the program byte for byte. Pure.
#pragma once

#include <string>

#include "app/core/scenario/session_log.h"

namespace handrail {

// A line for each sentence ("   1.250 say ..."), sound and change of a loop, in the order of time; every tenth of a
// second where the body and the hand are. Numbers are written so that they read back bit for bit, and each line of
// places ends in a checksum of all ticks (a thousand a second) until then: two sessions that differ anywhere differ in
// their text. Seconds, metres, newtons, radians; world axes. Ends in a line feed.
std::string transcript(const SessionLog& log);

}  // namespace handrail
