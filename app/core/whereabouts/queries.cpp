#include "app/core/whereabouts/queries.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/dialogue/brief_words.h"
#include "app/core/whereabouts/exit_words.h"
#include "worlds/base/language.h"
#include "worlds/scene/surfaces.h"

namespace handrail::core {
namespace {

// At most this many exits are announced before the sentence about what is ahead; the others follow it.
constexpr std::size_t kMostWaysFirst = 2;
constexpr std::size_t kMostThingsNamed = 4;  // number of things that are named when the person asks "where am I" again
constexpr std::size_t kMostThings = 24;      // number of things that are examined
// If the hand is within this distance of the walker, it does not point in any direction.
constexpr double kHandPoints_m = 0.3;
// Levels of verbosity from which on an announcement has the name, more details, or everything.
constexpr int kSayName = 2, kSayMore = 3, kSayAll = 4;
constexpr double kSamePlace_m = 0.05, kSameTurn_rad = 0.02;
constexpr double kOpen = 0.95, kShut = 0.05;

}  // namespace

bool Queries::act(Command command, double now_s) {
    if (!answer(command, now_s)) return false;
    context_.events.report(HelpRequested{command}, now_s);
    return true;
}

bool Queries::answer(Command command, double now_s) {
    const auto said = [&](std::string words) { context_.answer(std::move(words), now_s); };
    if (command == Command::WhereAmI) said(where_words_now(now_s));
    else if (command == Command::Heading) said(heading_words());
    else if (command == Command::AroundMe) said(around_me());
    else if (command == Command::AheadOfMe) said(ahead_of_me());
    else if (command == Command::LookNext) look_round(1, now_s);
    else if (command == Command::LookBefore) look_round(-1, now_s);
    else if (command == Command::ScaleBar) said(scale_bar());
    else if (command == Command::Coordinates) said(coordinates());
    else if (command == Command::WhatIsThis) describe_touched(now_s);
    else return false;
    return true;
}

DescriptionStyle Queries::style() const {
    return {context_.settings.speech.verbosity, context_.settings.speech.directions, distances(context_),
            context_.avatar.heading_rad};
}

Viewpoint Queries::viewpoint() const {
    Viewpoint viewpoint{*context_.world.solids, context_.avatar.feet_m(), context_.avatar.heading_rad,
                        context_.avatar.walker->size()};
    if (const std::uint32_t room = room_here(); room != navigation::kNothing)
        for (const navigation::Portal& portal : rooms_.graph().portals)
            if (portal.kind == navigation::PassageKind::Door && (portal.rooms[0] == room || portal.rooms[1] == room))
                viewpoint.doorways.push_back({portal.feature, portal.place_m});
    return viewpoint;
}

std::string Queries::state_of(FeatureId thing) const {
    const Feature* feature = context_.world.scene->find(thing);
    if (!feature) return {};
    std::string text;
    for (std::uint32_t i = 0; i < context_.world.movers.size(); ++i) {
        const Mover& mover = context_.world.scene->movers[i];
        if (mover.feature != thing || !mover.moves()) continue;
        const double open = context_.world.movers.part(i);
        if (feature->kind == FeatureKind::Door) {
            text = phrase(open > kOpen ? "questions.open" : open < kShut ? "questions.shut" : "questions.half_open");
            if (open < kShut && locked(context_.world, i))
                text = joined(text, phrase("questions.opened_from_elsewhere"));
        } else if (context_.world.movers.away(i) > kShut) {
            text = phrase("questions.moved");
        }
    }
    return text;
}

// For a door, also returns the side of its hinge and of its handle as seen from here.
std::string Queries::state_of(const Sight& sight) const {
    const Feature* feature = context_.world.scene->find(sight.seen.feature);
    return feature ? joined(state_of(sight.seen.feature), sides_of_door(*feature, sight.seen.bearing_rad))
                   : std::string();
}

std::string Queries::describe_sight(const Sight& sight) const { return describe(sight, state_of(sight), style()); }

std::string Queries::describe_sights(std::span<const Sight> sights) const {
    std::string text;
    for (const Sight& sight : sights) {
        if (!text.empty()) text += ' ';
        text += describe_sight(sight);
        if (text.back() != '.') text += '.';
    }
    return text;
}

// Returns "table, 2 steps; north wall, plaster, 5 steps" for things in a direction that has already been announced.
std::string Queries::describe_there(std::span<const Sight> sights) const {
    std::string text;
    for (const Sight& sight : sights)
        text += (text.empty() ? "" : "; ") + core::describe_there(sight, state_of(sight), style());
    return text;
}

std::string Queries::place_and_heading() const {
    const auto stands_at = [&](const Vec3& feet_m) {
        return glm::length(context_.avatar.feet_m() - feet_m) < 0.5 * context_.settings.walk.step_length_m;
    };
    const bool home = stands_at(context_.world.home_feet_m);
    const bool at_door = std::any_of(context_.world.scene->features.begin(), context_.world.scene->features.end(),
                                     [](const Feature& feature) { return feature.base; });
    std::string place;
    if (const std::uint32_t room = room_here(); room != navigation::kNothing) place = rooms_.graph().rooms[room].name;
    else if (!rooms_.found() && stands_at(context_.world.begun_feet_m)) place = context_.world.begun_at;
    if (home) place = joined(place, phrase(at_door ? "questions.at_door" : "questions.at_base"));
    if (place.empty()) place = spoken_name(*context_.world.scene);
    return phrase("questions.place_facing",
                  {{"place", sentence_case(place)}, {"compass", fine_compass_word(context_.avatar.heading_goal_rad)}});
}

// Returns the walker's room, or kNothing if the rooms are not known yet or there is only one.
std::uint32_t Queries::room_here() const {
    if (!rooms_.found() || rooms_.graph().rooms.size() < 2) return navigation::kNothing;
    return navigation::room_at(rooms_.graph(), rooms_.space(), context_.avatar.feet_m());
}

// Returns the exits, nearest first. If the rooms are not known, returns the doors in sight.
std::vector<std::string> Queries::ways_out() const {
    if (const std::uint32_t room = room_here(); room != navigation::kNothing)
        return exit_sentences(context_, rooms_.graph(), room, ExitOrder::Nearest);
    std::vector<std::string> doors;
    for (const Sight& sight : in_sight(viewpoint(), kMostThings)) {
        const Feature* feature = context_.world.scene->find(sight.seen.feature);
        if (!feature || feature->kind != FeatureKind::Door) continue;
        const std::string where =
            brief_place_words(sight.seen.distance_m, sight.seen.bearing_rad, context_.avatar.heading_goal_rad,
                              context_.settings.speech.directions, distances(context_));
        doors.push_back(phrase("rooms.exit", {{"exit", sentence_case(sight.name)}, {"where", where}}));
    }
    return doors;
}

std::string Queries::where_am_i(std::size_t most_words) const {
    std::vector<std::string> ways = ways_out();
    std::vector<std::string> sentences{place_and_heading()};
    const auto first = ways.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(ways.size(), kMostWaysFirst));
    sentences.insert(sentences.end(), ways.begin(), first);
    sentences.push_back(side_sentence(0));
    sentences.insert(sentences.end(), first, ways.end());
    if (context_.settings.speech.verbosity < kSayMore) return brief_text(sentences, most_words);
    return brief_text(sentences, std::numeric_limits<std::size_t>::max()) + " " + what_else();
}

// Returns what is on one side: "Right: east wall, plaster, 2 steps."
std::string Queries::side_sentence(int quarter) const {
    const auto seen = sight_along(viewpoint(), context_.avatar.heading_rad + quarter * kPi / 2.0);
    const std::string side =
        sentence_case(side_words(quarter, context_.avatar.heading_rad, context_.settings.speech.directions));
    if (!seen) return phrase("questions.side_open", {{"side", side}});
    return phrase("questions.side", {{"side", side}, {"what", core::describe_there(*seen, state_of(*seen), style())}});
}

// Names landmarks first, then what is right, behind and left, then everything else nearby.
std::string Queries::what_else() const {
    std::vector<Sight> things = in_sight(viewpoint(), kMostThings);
    const auto is_landmark = [&](const Sight& thing) {
        const Feature* feature = context_.world.scene->find(thing.seen.feature);
        return feature && feature->landmark;
    };
    std::erase_if(things, [&](const Sight& thing) {
        const Feature* feature = context_.world.scene->find(thing.seen.feature);
        return feature && feature->kind == FeatureKind::Door;
    });
    std::stable_partition(things.begin(), things.end(), is_landmark);
    if (things.size() > kMostThingsNamed) things.resize(kMostThingsNamed);
    const auto landmarks =
        static_cast<std::size_t>(std::find_if_not(things.begin(), things.end(), is_landmark) - things.begin());
    std::string text = describe_sights(std::span(things).first(landmarks));
    for (int quarter = 1; quarter < 4; ++quarter) {
        const auto seen = sight_along(viewpoint(), context_.avatar.heading_rad + quarter * kPi / 2.0);
        if (seen && std::any_of(things.begin(), things.end(),
                                [&](const Sight& thing) { return thing.seen.feature == seen->seen.feature; }))
            continue;  // This thing is mentioned separately.
        text += (text.empty() ? "" : " ") + side_sentence(quarter);
    }
    const std::string rest = describe_sights(std::span(things).subspan(landmarks));
    return rest.empty() ? text : text + (text.empty() ? "" : " ") + rest;
}

// Answers "where am I". If the person asks again at the same place, returns what the first answer left out.
std::string Queries::where_words_now(double now_s) {
    if (rooms_.known()) rooms_.notice(now_s, true);
    const Stood here{context_.avatar.feet_m(), context_.avatar.heading_goal_rad};
    const bool again = queried_at_ && glm::length(queried_at_->feet_m - here.feet_m) < kSamePlace_m &&
                       std::abs(wrap_angle(queried_at_->heading_rad - here.heading_rad)) < kSameTurn_rad &&
                       context_.settings.speech.verbosity < kSayMore;
    if (again) queried_at_.reset();
    else queried_at_ = here;
    return again ? what_else() : where_am_i();
}

std::string Queries::around_me() const {
    std::string text;
    const auto quarters = around(viewpoint());
    for (int i = 0; i < 4; ++i) {
        const auto& sight = quarters[static_cast<std::size_t>(i)];
        std::string side = side_words(i, context_.avatar.heading_rad, context_.settings.speech.directions);
        // A thing that is nearer to the diagonal than to this side gets its own direction: "Half left".
        if (sight && !sight->surface) {
            const double off_rad = wrap_angle(sight->seen.bearing_rad - context_.avatar.heading_rad - i * 0.5 * kPi);
            if (std::abs(off_rad) > kPi / 8.0)
                side = brief_direction_words(sight->seen.bearing_rad, context_.avatar.heading_rad,
                                             context_.settings.speech.directions);
        }
        side = sentence_case(std::move(side));
        if (!text.empty()) text += ' ';
        if (!sight) text += phrase("questions.side_open", {{"side", side}});
        else
            text += phrase("questions.side",
                           {{"side", side}, {"what", core::describe_there(*sight, state_of(*sight), style())}});
    }
    return text;
}

std::string Queries::ahead_of_me() {
    const std::vector<Sight> sights = ahead(viewpoint());
    for (const Sight& sight : sights)
        if (!sight.surface) {
            queried_thing_ = sight.seen.feature;
            break;
        }
    return sights.empty() ? phrase("questions.nothing_ahead", {{"metres", kSightRange_m}}) : describe_sights(sights);
}

void Queries::look_round(int by, double now_s) {
    std::optional<double> hand_rad;
    const Vec3 to_hand = context_.hands.tool.proxy_m - context_.avatar.feet_m();
    if (context_.hands.answers() && std::hypot(to_hand.x, to_hand.y) > kHandPoints_m)
        hand_rad = std::atan2(to_hand.x, to_hand.y);
    const double bearing = look_round_.step(by, context_.avatar.feet_m(), context_.avatar.heading_goal_rad, hand_rad);
    const std::vector<Sight> sights = look_towards(viewpoint(), bearing);
    const std::string direction = sentence_case(
        direction_words(bearing, context_.avatar.heading_rad, context_.settings.speech.directions, false));
    context_.answer(sights.empty() ? phrase("questions.side_open", {{"side", direction}})
                                   : phrase("questions.side", {{"side", direction}, {"what", describe_there(sights)}}),
                    now_s);
}

std::string Queries::heading_words() const {
    return phrase("questions.facing_degrees", {{"compass", fine_compass_word(context_.avatar.heading_goal_rad)},
                                               {"degrees", whole_degrees(context_.avatar.heading_goal_rad)}});
}

std::string Queries::coordinates() const {
    const auto place_words = [&](const Vec3& place_m, const Vec3& above_m) {
        const std::string coordinates = coordinates_words(place_m);
        const auto height = above_floor_m(*context_.world.solids, above_m);
        return height ? phrase("questions.above_floor", {{"coordinates", coordinates}, {"metres", *height}})
                      : phrase("questions.nothing_below", {{"coordinates", coordinates}});
    };
    std::string text =
        context_.avatar.walker->state().on_ground
            ? phrase("questions.on_floor", {{"coordinates", coordinates_words(context_.avatar.feet_m())}})
            : place_words(context_.avatar.feet_m(), context_.avatar.feet_m() + Vec3(0.0, 0.0, 0.01));
    if (context_.hands.right.present && context_.hands.tool.ticks > 0)
        text += " " + phrase("questions.your_hand",
                             {{"place", place_words(context_.hands.tool.proxy_m, context_.hands.tool.proxy_m)}});
    return text;
}

std::string Queries::scale_bar() const {
    return scale_bar_words(!under_roof(*context_.world.solids, context_.avatar.feet_m()), style(),
                           context_.hands.right.present ? scale(context_) : 0.0, workspace_heading_rad(context_));
}

void Queries::describe_touched(double now_s) {
    if (!context_.hands.right.present) return context_.answer(phrase("session.no_hand_to_ask"), now_s);
    if (context_.hands.left_behind) return context_.answer(ahead_of_me(), now_s);
    if (!context_.hands.two()) return context_.answer(touched_words(context_.hands.tool), now_s);
    context_.answer(phrase("session.both_hands", {{"right", touched_words(context_.hands.tool)},
                                                  {"left", touched_words(context_.hands.left_tool)}}),
                    now_s);
}

// The answer has the name of the thing at every verbosity. If the person asks again, the answer has everything that is
// known.
std::string Queries::touched_words(const servo::ToolState& tool) {
    FeatureId& described = &tool == &context_.hands.tool ? described_ : left_described_;
    if (!tool.touches()) {
        described = kNoFeature;
        return phrase("session.touches_nothing");
    }
    const FeatureId id = tool.touched();
    queried_thing_ = id;
    const int verbosity =
        std::exchange(described, id) == id ? kSayAll : std::max(kSayName, context_.settings.speech.verbosity);
    std::string text = cues::describe_feature(*context_.world.scene, id, verbosity);
    if (verbosity == kSayAll && context_.settings.speech.distances_in_steps)
        text += " " + steps_of_size(context_.world.scene->features[id.value], distances(context_));
    return text.empty() ? sentence_case(name_of(context_, id)) : text;
}

}  // namespace handrail::core
