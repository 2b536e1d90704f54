// Puts numbers, distances and directions into spoken words. Every distance and direction that is announced comes from
// these functions. Pure functions.
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

// Returns a distance in words: "5 steps", "1 step", or "close by" below half a step. Metres are rounded to half a
// metre: "3.5 metres". Above 20, steps and metres are rounded to multiples of 5. If the person wants exact values, the
// distance is not rounded in this way: "4.7 steps", "3.4 metres".
std::string distance_words(double distance_m, const DistanceWords& how);
// Returns true if distance_words() returns "close by" for this distance.
bool is_close_by(double distance_m, const DistanceWords& how);
// Returns the size of a room or area: "6 by 4 metres, 9 by 6 steps".
std::string size_words(double width_m, double depth_m, const DistanceWords& how);
// Returns the direction `bearing_rad` for a person who faces `heading_rad`, in the kind of words that the person has
// chosen: "ahead", "25 degrees left", "left", "behind"; "at 11 o'clock"; "north-west".
std::string direction_words(double bearing_rad, double heading_rad, settings::DirectionChoice choice,
                            bool rounded = true);
// Returns the turn from `heading_rad` to `bearing_rad` in degrees as it is announced, positive to the right. 0 is
// ahead, 180 is behind. The turn is rounded to 5 degrees, or to one degree if `rounded` is false.
double spoken_turn_deg(double bearing_rad, double heading_rad, bool rounded = true);
// Returns the hour, 1 to 12, that a turn in radians points to on a clock face lying in front of the person. Positive
// turns are to the right; 12 is ahead.
long hour_of(double turn_rad);
// Returns a heading in whole degrees clockwise from north, 0 to 360.
long whole_degrees(double heading_rad);
// Returns a distance and a direction in words: "9 steps at 1 o'clock", "9 steps ahead", "9 steps, 25 degrees right", "9
// steps north-east", "close by, ahead".
std::string place_words(double distance_m, double bearing_rad, double heading_rad, settings::DirectionChoice choice,
                        const DistanceWords& how);
// Returns a label for one side of the person: "ahead", "3 o'clock", "south". `quarter` counts quarter circles clockwise
// from straight ahead, 0 to 3.
std::string side_words(int quarter, double heading_rad, settings::DirectionChoice choice);
// Returns one of the 16 compass points: "north", "north-north-east", ...
std::string fine_compass_word(double heading_rad);
// Returns a duration in words: "12 minutes", "1 minute".
std::string minutes_words(double seconds);
// Returns "I found a Falcon." or "I found an omega." for a device with this name.
std::string found_words(std::string_view name);
// Returns true if the last character is an ASCII digit.
bool ends_in_digit(std::string_view text);
// Joins two labels with a comma: "north wall, plaster". Between two numbers it uses a semicolon, so that a voice does
// not read them as one: "Room 5; 7 steps". If one of the labels is empty, returns the other one.
std::string joined(std::string_view one, std::string_view other);
// Joins two sentences with a space. If one of them is empty, returns the other one.
std::string beside(const std::string& first, const std::string& then);
// Changes the first letter of `text` to upper case, for the start of a sentence.
std::string sentence_case(std::string text);

// Wraps an angle into (-pi, pi].
double wrap_angle(double radians);

}  // namespace handrail::core
