#include "app/core/dialogue/words.h"

#include <array>
#include <cmath>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/scene/surfaces.h"

namespace handrail::core {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr double kRoundedTo_deg = 5.0;
constexpr std::array kSides{"direction.ahead", "direction.right", "direction.behind", "direction.left"};

std::string steps_words(int steps) { return phrase("words.steps", {{"steps", steps}}); }
std::string metres_words(double metres) { return phrase("words.metres", {{"metres", metres}}); }

double half_metres(double m) { return std::round(m * 2.0) / 2.0; }

int whole_steps(double distance_m, double step_length_m) {
    const int steps = static_cast<int>(std::lround(distance_m / step_length_m));
    return steps > 20 ? ((steps + 2) / 5) * 5 : steps;
}

}  // namespace

long hour_of(double turn_rad) {
    const long hour = (std::lround(turn_rad / (kPi / 6.0)) + 12) % 12;
    return hour == 0 ? 12 : hour;
}

double wrap_angle(double radians) {
    double a = std::fmod(radians, 2.0 * kPi);
    if (a > kPi) a -= 2.0 * kPi;
    if (a <= -kPi) a += 2.0 * kPi;
    return a;
}

bool is_close_by(double distance_m, const DistanceWords& how) {
    if (!how.rounded) return false;
    return how.in_steps ? whole_steps(distance_m, how.step_length_m) <= 0 : distance_m < 0.25;
}

std::string distance_words(double distance_m, const DistanceWords& how) {
    contract_pre(distance_m >= 0.0);
    if (is_close_by(distance_m, how)) return phrase("words.close_by");
    if (!how.rounded) {
        if (how.in_steps) return phrase("words.exact_steps", {{"steps", distance_m / how.step_length_m}});
        return phrase("words.exact_metres", {{"metres", distance_m}});
    }
    if (how.in_steps) return steps_words(whole_steps(distance_m, how.step_length_m));
    const double half = half_metres(distance_m);
    return metres_words(half > 20.0 ? std::round(distance_m / 5.0) * 5.0 : half);
}

std::string size_words(double width_m, double depth_m, const DistanceWords& how) {
    contract_pre(width_m >= 0.0 && depth_m >= 0.0);
    const double width = half_metres(width_m), depth = half_metres(depth_m);
    if (!how.in_steps) return phrase("words.size", {{"width", width}, {"depth", depth}});
    return phrase("words.size_and_steps", {{"width", width},
                                           {"depth", depth},
                                           {"steps_wide", whole_steps(width_m, how.step_length_m)},
                                           {"steps_deep", whole_steps(depth_m, how.step_length_m)}});
}

double spoken_turn_deg(double bearing_rad, double heading_rad, bool rounded) {
    const double to = rounded ? kRoundedTo_deg : 1.0;
    return std::round(degrees_from_radians(wrap_angle(bearing_rad - heading_rad)) / to) * to;
}

long whole_degrees(double heading_rad) {
    return std::lrint(std::fmod(degrees_from_radians(heading_rad) + 360.0, 360.0));
}

std::string direction_words(double bearing_rad, double heading_rad, settings::DirectionChoice choice, bool rounded) {
    contract_pre(std::isfinite(bearing_rad) && std::isfinite(heading_rad));
    if (choice == settings::DirectionChoice::Compass)
        return rounded ? compass_word(bearing_rad) : fine_compass_word(bearing_rad);
    if (choice == settings::DirectionChoice::Clock)
        return phrase("direction.clock", {{"hour", hour_of(wrap_angle(bearing_rad - heading_rad))}});
    const double turn_deg = spoken_turn_deg(bearing_rad, heading_rad, rounded), degrees = std::abs(turn_deg);
    if (degrees == 0.0) return phrase("direction.ahead");
    if (degrees == 180.0) return phrase("direction.behind");
    if (degrees == 90.0) return phrase(turn_deg > 0.0 ? "direction.right" : "direction.left");
    return phrase(turn_deg > 0.0 ? "direction.degrees_right" : "direction.degrees_left", {{"degrees", degrees}});
}

std::string place_words(double distance_m, double bearing_rad, double heading_rad, settings::DirectionChoice choice,
                        const DistanceWords& how) {
    const std::string distance = distance_words(distance_m, how);
    const TextValue far{"distance", distance}, near{"near", is_close_by(distance_m, how) ? "yes" : "no"};
    if (choice == settings::DirectionChoice::Compass) {
        const std::string compass = how.rounded ? compass_word(bearing_rad) : fine_compass_word(bearing_rad);
        return phrase("place.compass", {far, near, {"compass", compass}});
    }
    if (choice == settings::DirectionChoice::Clock)
        return phrase("place.clock", {far, near, {"hour", hour_of(wrap_angle(bearing_rad - heading_rad))}});
    const double turn_deg = spoken_turn_deg(bearing_rad, heading_rad, how.rounded), degrees = std::abs(turn_deg);
    if (degrees == 0.0) return phrase("place.ahead", {far, near});
    if (degrees == 180.0) return phrase("place.behind", {far, near});
    if (degrees == 90.0) return phrase(turn_deg > 0.0 ? "place.right" : "place.left", {far, near});
    return phrase(turn_deg > 0.0 ? "place.degrees_right" : "place.degrees_left", {far, {"degrees", degrees}});
}

std::string side_words(int quarter, double heading_rad, settings::DirectionChoice choice) {
    contract_pre(quarter >= 0 && quarter < 4);
    if (choice == settings::DirectionChoice::Compass) return compass_word(heading_rad + quarter * kPi / 2.0);
    if (choice == settings::DirectionChoice::Clock)
        return phrase("direction.hour", {{"hour", quarter == 0 ? 12 : 3 * quarter}});
    return phrase(kSides[static_cast<std::size_t>(quarter)]);
}

std::string fine_compass_word(double heading_rad) {
    constexpr std::array kPoints{
        "compass.north", "compass.north_north_east", "compass.north_east", "compass.east_north_east",
        "compass.east",  "compass.east_south_east",  "compass.south_east", "compass.south_south_east",
        "compass.south", "compass.south_south_west", "compass.south_west", "compass.west_south_west",
        "compass.west",  "compass.west_north_west",  "compass.north_west", "compass.north_north_west"};
    return phrase(kPoints[static_cast<std::size_t>((std::lround(heading_rad / (kPi / 8.0)) % 16 + 16) % 16)]);
}

std::string minutes_words(double seconds) {
    return phrase("words.minutes", {{"minutes", std::lround(seconds / 60.0)}});
}

std::string found_words(std::string_view name) {
    const bool vowel = !name.empty() && std::string_view("aeiouAEIOU").find(name.front()) != std::string_view::npos;
    return phrase("words.found", {{"name", name}, {"vowel", vowel ? "yes" : "no"}});
}

bool ends_in_digit(std::string_view text) { return !text.empty() && is_digit(text.back()); }

std::string joined(std::string_view one, std::string_view other) {
    if (one.empty() || other.empty()) return std::string(one.empty() ? other : one);
    const bool numbers_meet = ends_in_digit(one) && is_digit(other.front());
    return phrase(numbers_meet ? "words.joined_numbers" : "words.joined", {{"one", one}, {"other", other}});
}

std::string beside(const std::string& first, const std::string& then) {
    return first.empty() || then.empty() ? first + then : first + " " + then;
}

std::string sentence_case(std::string text) {
    text = capitalised(text);
    return text;
}

}  // namespace handrail::core
