#include "app/core/context/spotlight.h"

#include <array>
#include <cmath>

#include "worlds/base/language.h"

namespace handrail::core {

using settings::SpotlightChoice;

bool Spotlight::shows(const Vec3& place_m) const {
    const Vec3 to = place_m - from_m;
    return std::hypot(to.x, to.y) <= kAtHand_m ||
           std::abs(wrap_angle(std::atan2(to.x, to.y) - heading_rad)) <= half_rad;
}

std::optional<Spotlight> spotlight(const SessionContext& context) {
    const settings::Settings::Sound& sound = context.settings.sound;
    if (sound.spotlight == SpotlightChoice::Off) return std::nullopt;
    Spotlight beam{context.avatar.ears_m(), context.avatar.heading_rad,
                   0.5 * radians_from_degrees(sound.spotlight_deg)};
    const Vec3 to_hand = context.hands.tool.proxy_m - beam.from_m;
    if (sound.spotlight == SpotlightChoice::Hand && context.hands.known() &&
        std::hypot(to_hand.x, to_hand.y) > Spotlight::kAtHand_m)
        beam.heading_rad = std::atan2(to_hand.x, to_hand.y);
    return beam;
}

void turn_spotlight_on(const SessionContext& context, double now_s) {
    constexpr std::array kWords{"off", "ahead", "hand"};
    const SpotlightChoice was = context.settings.sound.spotlight;
    const SpotlightChoice next = was == SpotlightChoice::Off                              ? SpotlightChoice::Ahead
                                 : was == SpotlightChoice::Ahead && context.hands.known() ? SpotlightChoice::Hand
                                                                                          : SpotlightChoice::Off;
    const char* word = kWords.at(static_cast<std::size_t>(next));
    context.set("sound.spotlight", word, now_s);
    context.answer(phrase("spotlight.turned", {{"to", word}, {"degrees", context.settings.sound.spotlight_deg}}),
                   now_s);
}

}  // namespace handrail::core
