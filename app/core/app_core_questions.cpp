// AppCore's part on questions: where am I, what is around, ahead, in one direction; heading, place, scale. App thread only.
#include <algorithm>
#include <cmath>

#include "app/core/app_core.h"
#include "worlds/scene/surfaces.h"

namespace handrail {
namespace {

constexpr std::size_t kMostLandmarks = 2;   // told first
constexpr std::size_t kMostThingsTold = 4;  // in all, by "where am I"
constexpr std::size_t kMostThings = 24;     // looked at
constexpr double kHandPoints_m = 0.3;       // a hand nearer to the body points nowhere
constexpr double kOpen = 0.95, kShut = 0.05;

}  // namespace

Telling AppCore::telling() const { return {settings_.speech.verbosity, settings_.speech.directions, distances(), heading_rad_}; }

Asker AppCore::asker() const { return {*body_world_, feet_m(), heading_rad_}; }

// What can change about a thing, and how a door hangs as one sees it from here.
std::string AppCore::state_of(const Sight& sight) const {
    const Feature* feature = scene_->find(sight.seen.feature);
    if (!feature) return {};
    std::string text;
    for (std::uint32_t i = 0; i < movers_.size(); ++i) {
        const Mover& mover = scene_->movers[i];
        if (mover.feature != sight.seen.feature || !mover.moves()) continue;
        const double away = movers_.away(i);
        if (feature->kind == FeatureKind::Door) {
            text = away > kOpen ? "open" : away < kShut ? "shut" : "half open";
            if (away < kShut && !mover.by_hand && mover.approach_m.empty()) text += ", opened from elsewhere";
        } else if (away > kShut) {
            text = "moved";
        }
    }
    const std::string sides = sides_of_door(*feature, sight.seen.bearing_rad);
    if (!sides.empty()) text += (text.empty() ? "" : ", ") + sides;
    return text;
}

std::string AppCore::tell_sight(const Sight& sight) const { return tell(sight, state_of(sight), telling()); }

std::string AppCore::tell_sights(std::span<const Sight> sights) const {
    std::string text;
    for (const Sight& sight : sights) {
        if (!text.empty()) text += ' ';
        text += tell_sight(sight);
        if (text.back() != '.') text += '.';
    }
    return text;
}

std::string AppCore::where_am_i() const {
    const bool home = glm::length(feet_m() - home_feet_m_) < 0.5 * settings_.walk.step_length_m;
    const bool at_door = std::any_of(scene_->features.begin(), scene_->features.end(), [](const Feature& feature) { return feature.base; });
    std::string text = fmt::format("You are {}, facing {}.", !home ? fmt::format("in {}", scene_->name) : at_door ? "at the door, base" : "at the base",
                                   compass_word(heading_rad_));
    // Two landmarks first, then what a straight look meets on four sides, then what else is near.
    std::vector<Sight> things = in_sight(asker(), kMostThings);
    std::stable_partition(things.begin(), things.end(), [&](const Sight& thing) {
        const Feature* feature = scene_->find(thing.seen.feature);
        return feature && feature->landmark;
    });
    const auto is_landmark = [&](const Sight& thing) {
        const Feature* feature = scene_->find(thing.seen.feature);
        return feature && feature->landmark;
    };
    const auto first_other = std::find_if_not(things.begin(), things.end(), is_landmark);
    const auto landmarks = std::min<std::size_t>(kMostLandmarks, static_cast<std::size_t>(first_other - things.begin()));
    const std::string near = tell_sights(std::span(things).first(landmarks));
    if (!near.empty()) text += " " + near;
    for (int quarter = 0; quarter < 4; ++quarter) {
        const auto seen = sight_along(asker(), heading_rad_ + quarter * kPi / 2.0);
        const std::string side = sentence_case(side_words(quarter, heading_rad_, settings_.speech.directions));
        const bool told = seen && std::any_of(things.begin(), things.begin() + static_cast<std::ptrdiff_t>(landmarks),
                                              [&](const Sight& thing) { return thing.seen.feature == seen->seen.feature; });
        if (told) continue;
        if (!seen) text += fmt::format(" {}: open.", side);
        else if (settings_.speech.verbosity <= 1) text += fmt::format(" {}: {}.", side, seen->name);
        else text += fmt::format(" {}: {}, {}.", side, name_of(seen->seen.feature), distance_words(seen->seen.distance_m, distances()));
    }
    const auto rest = std::span(things).subspan(landmarks);
    const std::string others = tell_sights(rest.first(std::min(rest.size(), kMostThingsTold - landmarks)));
    return others.empty() ? text : text + " " + others;
}

std::string AppCore::around_me() const {
    std::string text;
    const auto quarters = around(asker());
    for (int i = 0; i < 4; ++i) {
        const auto& sight = quarters[static_cast<std::size_t>(i)];
        const std::string side = sentence_case(side_words(i, heading_rad_, settings_.speech.directions));
        std::string told = !sight ? "open." : tell_sight(*sight);
        if (told.back() != '.') told += '.';
        text += fmt::format("{}{}: {}", text.empty() ? "" : " ", side, told);
    }
    return text;
}

std::string AppCore::ahead_of_me() const {
    const std::vector<Sight> sights = ahead(asker());
    return sights.empty() ? "Nothing ahead within 100 metres." : tell_sights(sights);
}

void AppCore::look_round(int by, double now_s) {
    std::optional<double> hand_rad;
    const Vec3 to_hand = tool_.proxy_m - feet_m();
    if (hand_.present && tool_.ticks > 0 && std::hypot(to_hand.x, to_hand.y) > kHandPoints_m) hand_rad = std::atan2(to_hand.x, to_hand.y);
    const double bearing = look_round_.step(by, feet_m(), heading_goal_rad_, hand_rad);
    const std::vector<Sight> sights = look_towards(asker(), bearing);
    const std::string direction = sentence_case(direction_words(bearing, heading_rad_, settings_.speech.directions, false));
    answer(sights.empty() ? fmt::format("{}: open.", direction) : fmt::format("{}: {}", direction, tell_sights(sights)), now_s);
}

std::string AppCore::heading_words() const {
    return fmt::format("Facing {}, {:.0f} degrees", compass_word(heading_goal_rad_), std::fmod(degrees_from_radians(heading_goal_rad_) + 360.0, 360.0));
}

std::string AppCore::coordinates() const {
    std::string text = coordinates_words(feet_m());
    const auto above = [&](const Vec3& place_m) {
        const auto height = above_floor_m(*body_world_, place_m);
        return height ? fmt::format("{:.1f} metres above the floor", *height) : std::string("with nothing below");
    };
    text += standing() ? ", on the floor." : fmt::format(", {}.", above(feet_m() + Vec3(0.0, 0.0, 0.01)));
    if (hand_.present && tool_.ticks > 0) text += fmt::format(" Your hand: {}, {}.", coordinates_words(tool_.proxy_m), above(tool_.proxy_m));
    return text;
}

std::string AppCore::scale_bar() const {
    return scale_bar_words(!under_roof(*body_world_, feet_m()), telling(), hand_.present ? scale() : 0.0, workspace_heading_rad());
}

}  // namespace handrail
