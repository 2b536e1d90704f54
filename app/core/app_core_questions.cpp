// AppCore's part on questions: where am I, what is around, ahead, in one direction; heading, place, scale. App thread only.
#include <algorithm>
#include <cmath>

#include "app/core/app_core.h"
#include "worlds/base/language.h"
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
            text = phrase(away > kOpen ? "questions.open" : away < kShut ? "questions.shut" : "questions.half_open");
            if (away < kShut && locked(i)) text = joined(text, phrase("questions.opened_from_elsewhere"));
        } else if (away > kShut) {
            text = phrase("questions.moved");
        }
    }
    return joined(text, sides_of_door(*feature, sight.seen.bearing_rad));
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
    const std::string compass = compass_word(heading_rad_);
    std::string text = !home     ? phrase("questions.you_are_in", {{"world", spoken_name(*scene_)}, {"compass", compass}})
                       : at_door ? phrase("questions.you_are_at_door", {{"compass", compass}})
                                 : phrase("questions.you_are_at_base", {{"compass", compass}});
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
        text += ' ';
        if (!seen) text += phrase("questions.side_open", {{"side", side}});
        else if (settings_.speech.verbosity <= 1) text += phrase("questions.side", {{"side", side}, {"what", seen->name}});
        else {
            const std::string what = joined(name_of(seen->seen.feature), distance_words(seen->seen.distance_m, distances()));
            text += phrase("questions.side", {{"side", side}, {"what", what}});
        }
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
        if (!text.empty()) text += ' ';
        if (!sight) text += phrase("questions.side_open", {{"side", side}});
        else text += phrase("questions.side_sights", {{"side", side}, {"sights", tell_sights(std::span(&*sight, 1))}});
    }
    return text;
}

std::string AppCore::ahead_of_me() const {
    const std::vector<Sight> sights = ahead(asker());
    return sights.empty() ? phrase("questions.nothing_ahead", {{"metres", kSightRange_m}}) : tell_sights(sights);
}

void AppCore::look_round(int by, double now_s) {
    std::optional<double> hand_rad;
    const Vec3 to_hand = tool_.proxy_m - feet_m();
    if (hand_.present && tool_.ticks > 0 && std::hypot(to_hand.x, to_hand.y) > kHandPoints_m) hand_rad = std::atan2(to_hand.x, to_hand.y);
    const double bearing = look_round_.step(by, feet_m(), heading_goal_rad_, hand_rad);
    const std::vector<Sight> sights = look_towards(asker(), bearing);
    const std::string direction = sentence_case(direction_words(bearing, heading_rad_, settings_.speech.directions, false));
    answer(sights.empty() ? phrase("questions.side_open", {{"side", direction}})
                          : phrase("questions.side_sights", {{"side", direction}, {"sights", tell_sights(sights)}}),
           now_s);
}

std::string AppCore::heading_words() const {
    return phrase("questions.facing_degrees", {{"compass", compass_word(heading_goal_rad_)}, {"degrees", whole_degrees(heading_goal_rad_)}});
}

std::string AppCore::coordinates() const {
    const auto told = [&](const Vec3& place_m, const Vec3& above_m) {
        const std::string coordinates = coordinates_words(place_m);
        const auto height = above_floor_m(*body_world_, above_m);
        return height ? phrase("questions.above_floor", {{"coordinates", coordinates}, {"metres", *height}})
                      : phrase("questions.nothing_below", {{"coordinates", coordinates}});
    };
    std::string text =
        standing() ? phrase("questions.on_floor", {{"coordinates", coordinates_words(feet_m())}}) : told(feet_m(), feet_m() + Vec3(0.0, 0.0, 0.01));
    if (hand_.present && tool_.ticks > 0) text += " " + phrase("questions.your_hand", {{"place", told(tool_.proxy_m, tool_.proxy_m)}});
    return text;
}

std::string AppCore::scale_bar() const {
    return scale_bar_words(!under_roof(*body_world_, feet_m()), telling(), hand_.present ? scale() : 0.0, workspace_heading_rad());
}

}  // namespace handrail
