#include "app/core/words.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "worlds/scene/surfaces.h"

namespace handrail {
namespace {

constexpr double kRoundedTo_deg = 5.0;
constexpr std::string_view kCloseBy = "close by";
constexpr std::array kRelative{"ahead", "ahead right", "right", "behind right", "behind", "behind left", "left", "ahead left"};

std::string metres_words(double distance_m) {
    double half = std::round(distance_m * 2.0) / 2.0;
    if (half > 20.0) half = std::round(distance_m / 5.0) * 5.0;
    if (half == 1.0) return "1 metre";
    return fmt::format("{} metres", half);
}

int whole_steps(double distance_m, double step_length_m) {
    const int steps = static_cast<int>(std::lround(distance_m / step_length_m));
    return steps > 20 ? ((steps + 2) / 5) * 5 : steps;
}

}  // namespace

double wrap_angle(double radians) {
    double a = std::fmod(radians, 2.0 * kPi);
    if (a > kPi) a -= 2.0 * kPi;
    if (a <= -kPi) a += 2.0 * kPi;
    return a;
}

std::string distance_words(double distance_m, const DistanceWords& how) {
    if (!how.rounded) return fmt::format("{:.1f} {}", distance_m / (how.in_steps ? how.step_length_m : 1.0), how.in_steps ? "steps" : "metres");
    if (how.in_steps) {
        const int steps = whole_steps(distance_m, how.step_length_m);
        if (steps <= 0) return std::string(kCloseBy);
        return steps == 1 ? "1 step" : fmt::format("{} steps", steps);
    }
    return distance_m < 0.25 ? std::string(kCloseBy) : metres_words(distance_m);
}

std::string size_words(double width_m, double depth_m, const DistanceWords& how) {
    const auto half = [](double m) { return std::round(m * 2.0) / 2.0; };
    std::string text = fmt::format("{} by {} metres", half(width_m), half(depth_m));
    if (how.in_steps) text += fmt::format(", {} by {} steps", whole_steps(width_m, how.step_length_m), whole_steps(depth_m, how.step_length_m));
    return text;
}

std::string relative_words(double bearing_rad, double heading_rad) { return kRelative[nearest_eighth(wrap_angle(bearing_rad - heading_rad))]; }

std::string direction_words(double bearing_rad, double heading_rad, DirectionChoice choice, bool rounded) {
    const double turn_rad = wrap_angle(bearing_rad - heading_rad);
    if (choice == DirectionChoice::Compass) return std::string(rounded ? compass_word(bearing_rad) : fine_compass_word(bearing_rad));
    if (choice == DirectionChoice::Clock) {
        const long hour = (std::lround(turn_rad / (kPi / 6.0)) + 12) % 12;
        return fmt::format("at {} o'clock", hour == 0 ? 12 : hour);
    }
    const double to = rounded ? kRoundedTo_deg : 1.0;
    const double degrees = std::round(degrees_from_radians(std::abs(turn_rad)) / to) * to;
    if (degrees == 0.0) return "ahead";
    if (degrees == 180.0) return "behind";
    const std::string_view side = turn_rad > 0.0 ? "right" : "left";
    return degrees == 90.0 ? std::string(side) : fmt::format("{:.0f} degrees {}", degrees, side);
}

std::string place_words(double distance_m, double bearing_rad, double heading_rad, DirectionChoice choice, const DistanceWords& how) {
    const std::string distance = distance_words(distance_m, how), direction = direction_words(bearing_rad, heading_rad, choice, how.rounded);
    const bool close = distance == kCloseBy, degrees = direction.find("degrees") != std::string::npos;
    if (direction == "left" || direction == "right") return fmt::format("{}{} to the {}", distance, close ? "," : "", direction);
    return fmt::format("{}{} {}", distance, close || degrees ? "," : "", direction);
}

std::string side_words(int quarter, double heading_rad, DirectionChoice choice) {
    if (choice == DirectionChoice::Compass) return std::string(compass_word(heading_rad + quarter * kPi / 2.0));
    if (choice == DirectionChoice::Clock) return fmt::format("{} o'clock", quarter == 0 ? 12 : 3 * quarter);
    return kRelative[static_cast<std::size_t>(2 * quarter)];
}

std::string_view fine_compass_word(double heading_rad) {
    constexpr std::array<std::string_view, 16> kWords{"north",      "north-north-east", "north-east", "east-north-east",  "east",       "east-south-east",
                                                      "south-east", "south-south-east", "south",      "south-south-west", "south-west", "west-south-west",
                                                      "west",       "west-north-west",  "north-west", "north-north-west"};
    return kWords[static_cast<std::size_t>((std::lround(heading_rad / (kPi / 8.0)) % 16 + 16) % 16)];
}

std::string minutes_words(double seconds) {
    const long minutes = std::lround(seconds / 60.0);
    return minutes == 1 ? "1 minute" : fmt::format("{} minutes", minutes);
}

std::string with_article(std::string_view name) {
    const bool vowel = !name.empty() && std::string_view("aeiouAEIOU").find(name.front()) != std::string_view::npos;
    return fmt::format("{} {}", vowel ? "an" : "a", name);
}

std::string sentence_case(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

}  // namespace handrail
