// Durations of learning and hunting in words. Pure; any thread.
#pragma once

#include <string>

namespace handrail::core {

// "12 seconds", "2 minutes and 5 seconds".
std::string time_words(double seconds);

}  // namespace handrail::core
