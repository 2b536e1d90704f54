// Makes short answers: directions of one or two words, and texts that are shortened to a number of words by leaving out
// sentences. Pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/core/dialogue/words.h"

namespace handrail::core {

// Returns the direction `bearing_rad` for a person who faces `heading_rad`, in the words used for a turn: "ahead",
// "slightly left", "half left", "left", "behind left", "behind"; "10 o'clock"; "north-west".
std::string brief_direction_words(double bearing_rad, double heading_rad, settings::DirectionChoice choice);
// Returns "9 steps ahead" or "9 steps, half left", in at most four words.
std::string brief_place_words(double distance_m, double bearing_rad, double heading_rad,
                              settings::DirectionChoice choice, const DistanceWords& how);

// Returns the number of words, which are separated by blanks.
std::size_t count_words(std::string_view text);
// Joins sentences up to `most` words in total. The first sentence is always included. A sentence that is too long is
// left out, but shorter sentences after it may still be included.
std::string brief_text(const std::vector<std::string>& sentences, std::size_t most);

}  // namespace handrail::core
