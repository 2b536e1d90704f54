// Numbers and directions in spoken words. Pure functions. Every distance and direction that is announced goes through
// here.
#pragma once

#include <string>
#include <string_view>

#include "settings/settings.h"
#include "worlds/base/vec.h"

namespace handrail::core {

struct DistanceWords {
    bool in_steps = true;
    double step_length_m = 0.7;
    bool rounded = true;
};

// "5 steps", "1 step", "close by" if under half a step; metres to the half metre: "3.5 metres". Above 20, steps and
// metres are rounded to 5. Not rounded: "4.7 steps", "3.4 metres".
std::string distance_words(double distance_m, const DistanceWords& how);
// True if that distance is announced as "close by".
bool is_close_by(double distance_m, const DistanceWords& how);
// "6 by 4 metres, 9 by 6 steps".
std::string size_words(double width_m, double depth_m, const DistanceWords& how);
// The direction of `bearing_rad` for a person who faces `heading_rad`, in the person's own choice of words: "ahead",
// "25 degrees left", "left", "behind"; "at 11 o'clock"; "north-west".
std::string direction_words(double bearing_rad, double heading_rad, settings::DirectionChoice choice,
                            bool rounded = true);
// The turn as announced, in degrees, positive to the right; 0 is ahead, 180 is behind. Rounded to 5 degrees, or to one
// degree if not `rounded`.
double told_turn_deg(double bearing_rad, double heading_rad, bool rounded = true);
// The hour on a clock face that lies in front of the person, for a turn in radians, positive to the right: 1 to 12;
// ahead is 12.
long hour_of(double turn_rad);
// A heading in whole degrees clockwise from north, 0 to 360.
long whole_degrees(double heading_rad);
// "9 steps at 1 o'clock", "9 steps ahead", "9 steps, 25 degrees right", "9 steps north-east", "close by, ahead".
std::string place_words(double distance_m, double bearing_rad, double heading_rad, settings::DirectionChoice choice,
                        const DistanceWords& how);
// A label for a side. quarter: quarter circles clockwise from straight ahead, 0 to 3. "ahead", "3 o'clock", "south".
std::string side_words(int quarter, double heading_rad, settings::DirectionChoice choice);
// The 16 compass points: "north", "north-north-east", ...
std::string fine_compass_word(double heading_rad);
// "12 minutes", "1 minute".
std::string minutes_words(double seconds);
// "I found a Falcon.", "I found an omega."; name: of a device.
std::string found_words(std::string_view name);
// "north wall, plaster": joins two labels, one of which may be empty.
std::string joined(std::string_view one, std::string_view other);
// Makes the first letter upper case, for the start of a sentence.
std::string sentence_case(std::string text);

// Wraps an angle into (-pi, pi].
double wrap_angle(double radians);

}  // namespace handrail::core
