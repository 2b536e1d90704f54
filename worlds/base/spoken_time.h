// Dates and times of day as people of the language spoken write them, in the time zone of this machine. Any thread.
#pragma once

#include <string>
#include <string_view>

namespace handrail {

// Of a moment in UTC as ISO 8601 has it, "2026-11-22T17:30:00Z": "22 November 2026". A text that is no such moment
// comes back as it is.
std::string day_words(std::string_view iso_utc);
// With the time of day: "22 November 2026, 17:30".
std::string day_and_time_words(std::string_view iso_utc);

}  // namespace handrail
