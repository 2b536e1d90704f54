// Words for the times of learning and hunting. Pure; any thread.
#pragma once

#include <string>

namespace handrail::core {

// Returns "12 seconds" or "2 minutes and 5 seconds".
std::string time_words(double seconds);

}  // namespace handrail::core
