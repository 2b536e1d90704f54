#include "app/core/words.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace handrail {
namespace {

constexpr std::array kRelative{"ahead", "ahead right", "right", "behind right", "behind", "behind left", "left", "ahead left"};

std::string metres_words(double distance_m) {
    const double half = std::round(distance_m * 2.0) / 2.0;
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
    if (how.in_steps) {
        const int steps = whole_steps(distance_m, how.step_length_m);
        if (steps <= 0) return "close by";
        return steps == 1 ? "1 step" : fmt::format("{} steps", steps);
    }
    return distance_m < 0.25 ? "close by" : metres_words(distance_m);
}

std::string size_words(double width_m, double depth_m, const DistanceWords& how) {
    const auto half = [](double m) { return std::round(m * 2.0) / 2.0; };
    std::string text = fmt::format("{} by {} metres", half(width_m), half(depth_m));
    if (how.in_steps) text += fmt::format(", {} by {} steps", whole_steps(width_m, how.step_length_m), whole_steps(depth_m, how.step_length_m));
    return text;
}

std::string relative_words(double bearing_rad, double heading_rad) { return kRelative[nearest_eighth(wrap_angle(bearing_rad - heading_rad))]; }

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
