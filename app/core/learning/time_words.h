// Puts the times of learning and hunting into words. A pure function, which any thread may call.
#pragma once

#include <string>

namespace handrail::core {

// Returns "12 seconds" or "2 minutes and 5 seconds".
std::string time_words(double seconds);

}  // namespace handrail::core
