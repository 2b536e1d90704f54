// Numbers and directions as people say them. Pure functions; every distance and direction that is spoken goes through
// here.
#pragma once

#include <string>
#include <string_view>

#include "settings/settings.h"
#include "worlds/base/vec.h"

namespace handrail {

struct DistanceWords {
    bool in_steps = true;
    double step_length_m = 0.7;
    bool rounded = true;
};

// "5 steps", "1 step", "close by" (under half a step); in metres to the half metre: "3.5 metres". Over 20 of either
// rounded to 5. Not rounded: "4.7 steps", "3.4 metres".
std::string distance_words(double distance_m, const DistanceWords& how);
// Whether that is told as "close by".
bool is_close_by(double distance_m, const DistanceWords& how);
// "6 by 4 metres, 9 by 6 steps".
std::string size_words(double width_m, double depth_m, const DistanceWords& how);
// The direction of `bearing_rad` for one who faces `heading_rad`, by the person's own choice: "ahead", "25 degrees
// left", "left", "behind"; "at 11 o'clock"; "north-west".
std::string direction_words(double bearing_rad, double heading_rad, DirectionChoice choice, bool rounded = true);
// How far to turn, as it is told: degrees, positive to the right, to five or, not rounded, to one; 0 is ahead, 180
// either way behind.
double told_turn_deg(double bearing_rad, double heading_rad, bool rounded = true);
// The hour of a clock lying before one that a turn of so many radians, positive to the right, points at: 1 to 12, ahead
// is 12.
long hour_of(double turn_rad);
// A heading in degrees clockwise from north, 0 to 360, to the degree.
long whole_degrees(double heading_rad);
// "9 steps at 1 o'clock", "9 steps ahead", "9 steps, 25 degrees right", "9 steps north-east", "close by, ahead".
std::string place_words(double distance_m, double bearing_rad, double heading_rad, DirectionChoice choice,
                        const DistanceWords& how);
// Which side: a quarter of a circle from straight ahead, clockwise, 0 to 3, as a label: "ahead", "3 o'clock", "south".
std::string side_words(int quarter, double heading_rad, DirectionChoice choice);
// The 16 points: "north", "north-north-east", ...
std::string fine_compass_word(double heading_rad);
// "12 minutes", "1 minute".
std::string minutes_words(double seconds);
// "I found a Falcon.", "I found an omega.": of a device by its name.
std::string found_words(std::string_view name);
// "north wall, plaster": of two labels, one of which may be empty.
std::string joined(std::string_view one, std::string_view other);
// First letter in upper case, for the start of a sentence.
std::string sentence_case(std::string text);

// Turned into (-pi, pi].
double wrap_angle(double radians);

}  // namespace handrail
