// Answers in few words: directions of one or two, sentences counted and left out where there is no room for them. Pure
// functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/core/dialogue/words.h"

namespace handrail {

// The direction of `bearing_rad` for one who faces `heading_rad`, as turns are told: "ahead", "slightly left", "half
// left", "left", "behind left", "behind"; "10 o'clock"; "north-west".
std::string brief_direction_words(double bearing_rad, double heading_rad, DirectionChoice choice);
// "9 steps ahead", "9 steps, half left": never more than four words.
std::string brief_place_words(double distance_m, double bearing_rad, double heading_rad, DirectionChoice choice,
                              const DistanceWords& how);

// How many words are heard: whatever blanks part.
std::size_t count_words(std::string_view text);
// Sentences as long as they are no more than `most` words together; the first is always there. Those that are too long
// are left out, shorter ones after them are not.
std::string brief_text(const std::vector<std::string>& sentences, std::size_t most);

}  // namespace handrail
