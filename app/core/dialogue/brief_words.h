// Short answers: directions of one or two words, and texts cut to a number of words by leaving sentences out. Pure
// functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/core/dialogue/words.h"

namespace handrail::core {

// The direction of `bearing_rad` for a person who faces `heading_rad`, worded like a turn: "ahead", "slightly left",
// "half left", "left", "behind left", "behind"; "10 o'clock"; "north-west".
std::string brief_direction_words(double bearing_rad, double heading_rad, settings::DirectionChoice choice);
// "9 steps ahead", "9 steps, half left": never more than four words.
std::string brief_place_words(double distance_m, double bearing_rad, double heading_rad,
                              settings::DirectionChoice choice, const DistanceWords& how);

// Number of spoken words, that is, of parts between blanks.
std::size_t count_words(std::string_view text);
// Joins sentences up to `most` words in total. The first one is always included. A sentence that is too long is left
// out, but shorter ones after it may still follow.
std::string brief_text(const std::vector<std::string>& sentences, std::size_t most);

}  // namespace handrail::core
