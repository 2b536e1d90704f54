#include "app/core/dialogue/brief_words.h"

#include <array>
#include <cmath>

#include "app/core/dialogue/words.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/scene/surfaces.h"

namespace handrail::core {

std::string brief_direction_words(double bearing_rad, double heading_rad, settings::DirectionChoice choice) {
    contract_pre(std::isfinite(bearing_rad) && std::isfinite(heading_rad));
    if (choice == settings::DirectionChoice::Compass) return compass_word(bearing_rad);
    const double turn_rad = wrap_angle(bearing_rad - heading_rad);
    if (choice == settings::DirectionChoice::Clock) return phrase("direction.hour", {{"hour", hour_of(turn_rad)}});
    // The index counts sixteenths of a full turn. 1 is "slightly", 2 is "half", 3 to 5 are to the side, and 6 and 7 are
    // diagonally behind.
    constexpr std::array kRight{"direction.ahead",        "direction.slightly_right", "direction.half_right",
                                "direction.right",        "direction.right",          "direction.right",
                                "direction.behind_right", "direction.behind_right",   "direction.behind"};
    constexpr std::array kLeft{"direction.ahead",       "direction.slightly_left", "direction.half_left",
                               "direction.left",        "direction.left",          "direction.left",
                               "direction.behind_left", "direction.behind_left",   "direction.behind"};
    const auto sixteenths = static_cast<std::size_t>(std::lround(std::abs(turn_rad) / (kPi / 8.0)));
    return phrase(turn_rad >= 0.0 ? kRight[sixteenths] : kLeft[sixteenths]);
}

std::string brief_place_words(double distance_m, double bearing_rad, double heading_rad,
                              settings::DirectionChoice choice, const DistanceWords& how) {
    const std::string distance = distance_words(distance_m, how),
                      direction = brief_direction_words(bearing_rad, heading_rad, choice);
    const std::string ahead = phrase("direction.ahead"), behind = phrase("direction.behind");
    const bool runs_on = !is_close_by(distance_m, how) &&
                         (direction == ahead || direction == behind || choice == settings::DirectionChoice::Compass);
    return runs_on ? phrase("place.runs_on", {{"distance", distance}, {"direction", direction}})
                   : joined(distance, direction);
}

std::size_t count_words(std::string_view text) {
    std::size_t words = 0;
    bool inside = false;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\n' || c == '\t';
        if (!blank && !inside) ++words;
        inside = !blank;
    }
    return words;
}

std::string brief_text(const std::vector<std::string>& sentences, std::size_t most) {
    std::string text;
    std::size_t words = 0;
    for (const std::string& sentence : sentences) {
        const std::size_t more = count_words(sentence);
        if (more == 0 || (!text.empty() && words + more > most)) continue;
        if (!text.empty()) text += ' ';
        text += sentence;
        words += more;
    }
    return text;
}

}  // namespace handrail::core
