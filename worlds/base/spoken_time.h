// Formats dates and times of day as is usual in the spoken language, in the time zone of this machine. Any thread may
// call these functions.
#pragma once

#include <string>
#include <string_view>

namespace handrail {

// Turns a UTC time in ISO 8601, such as "2026-11-22T17:30:00Z", into "22 November 2026". Any other text is returned
// unchanged.
std::string day_words(std::string_view iso_utc);
// Like day_words, with the time of day: "22 November 2026, 17:30".
std::string day_and_time_words(std::string_view iso_utc);

}  // namespace handrail
