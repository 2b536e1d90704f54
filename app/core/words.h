// Numbers and directions as people say them. Pure functions; every distance and direction that is spoken goes through here.
#pragma once

#include <string>

#include "worlds/base/vec.h"

namespace handrail {

struct DistanceWords {
    bool in_steps = true;
    double step_length_m = 0.7;
};

// "5 steps", "1 step", "close by" (under half a step); in metres to the half metre: "3.5 metres". From 10 steps on rounded to 5 over 20.
std::string distance_words(double distance_m, const DistanceWords& how);
// "6 by 4 metres, 9 by 6 steps".
std::string size_words(double width_m, double depth_m, const DistanceWords& how);
// "ahead", "ahead right", "right", ...: the direction of `bearing_rad` for one who faces `heading_rad`.
std::string relative_words(double bearing_rad, double heading_rad);
// "12 minutes", "1 minute".
std::string minutes_words(double seconds);
// "a Falcon", "an omega": the article by the name's first letter.
std::string with_article(std::string_view name);
// First letter in upper case, for the start of a sentence; other bytes stay.
std::string sentence_case(std::string text);

// Turned into (-pi, pi].
double wrap_angle(double radians);

}  // namespace handrail
