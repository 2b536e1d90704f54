#include "app/core/wayfinding/spoken_route.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/kept/saved_routes.h"
#include "app/core/wayfinding/leg.h"
#include "app/core/wayfinding/route_stage.h"
#include "app/core/wayfinding/whole_route_words.h"
#include "app/core/whereabouts/climbs.h"
#include "app/core/whereabouts/storeys.h"
#include "worlds/base/language.h"
#include "worlds/navigation/reach.h"
#include "worlds/navigation/route_place.h"

namespace handrail::core {
namespace {

constexpr double kTakenUpAhead_m = 2.0;  // how far ahead the person joins the old route again
constexpr double kAtPlace_m = 0.2;       // if the walker is within this distance of the goal, no wall can be in between
// The old route is kept if it is shorter than the new route times this factor.
constexpr double kWorthTurningBack = 1.15;

}  // namespace

void SpokenRoute::follow_to(const Vec3& goal_m, const std::string& name, const std::string& first, double now_s) {
    follow(rooms_.navigation().plan(context_.avatar.feet_m(), goal_m), name, first, now_s, RouteForm::ByLegs);
}

void SpokenRoute::stop() {
    follower_.stop();
    directions_.stop();
    room_.reset();
    announced_.reset();
    stopped_.reset();
    preference_ = navigation::RoutePreference::Safest;
    unfinished_.reset();
    leapt_from_.clear();
    no_legs_m_.reset();
    faces_ = rest_requested_ = length_owed_ = to_passage_ = false;
}

// Plans more of an unfinished route. The route that is followed changes once it is finished.
void SpokenRoute::plan_on() {
    if (!unfinished_) return;
    const bool planned_on = plan_stretch(rooms_, *unfinished_);
    if (planned_on && !unfinished_->ahead_m.empty()) return;
    const FarRoute far = *std::exchange(unfinished_, std::nullopt);
    follow_silently(planned_on ? far.route : planned_to_room(context_, rooms_, *room_), std::string(name_));
}

navigation::Route SpokenRoute::to_room(std::uint32_t room, const navigation::FootDistances& on_foot) const {
    return with_straight_lines(route_to_room(context_, rooms_, room, on_foot));
}

bool SpokenRoute::follow_to_room(std::uint32_t room, const std::string& first, double now_s) {
    const std::string name = sentence_case(rooms_.graph().rooms[room].name);
    const FarRoute way =
        route_to_room(context_, rooms_, room, {rooms_.graph(), rooms_.here(), context_.avatar.feet_m()});
    stop();
    to_nearest_ = false;
    const bool reaches = (way.route.reaches && way.route.points_m.size() > 1 &&
                          follow_by_legs({room, rooms_.graph().rooms[room].middle_m}, way, name, first, now_s)) ||
                         follow(way.ahead_m.empty() ? way.route : planned_to_room(context_, rooms_, room), name, first,
                                now_s, RouteForm::Whole);
    if (reaches) room_ = room;
    return reaches;
}

// Announces a route with its first leg and follows it with directions leg by leg. `first` is announced before
// everything else. Returns false and announces nothing if no directions can be planned.
bool SpokenRoute::follow_by_legs(const DirectionsEnd& end, FarRoute far, const std::string& name,
                                 const std::string& first, double now_s) {
    if (!begin_legs(far.route, end, name)) return false;
    const navigation::Route route = with_straight_lines(far);
    follow_silently(route, name);
    if (!far.ahead_m.empty()) unfinished_ = std::move(far);
    // The first call may skip legs that are already over, so the length is announced without them.
    const std::string leg = directions_.leg();
    std::string words = beside(first, phrase("rooms.way", {{"goal", name}, {"route", overview(route)}}));
    if (!leg.empty()) words += ' ' + leg;
    length_owed_ = directions_.state() == RouteDirections::State::Planned;
    context_.announce(cues::SpeechTopic::Summary, std::move(words), now_s);
    context_.events.report(Led{name, LedBy::Ear}, now_s);
    return true;
}

// Begins the directions leg by leg to the end of the route, or to the first passage on it without legs. Returns false
// if there are none.
bool SpokenRoute::begin_legs(const navigation::Route& route, const DirectionsEnd& end, const std::string& name) {
    const auto stage = first_stage(context_, route, end, name);
    if (!stage) return false;
    to_passage_ = stage->end.at_passage;
    if (!to_passage_) preference_ = navigation::RoutePreference::OnFoot;
    directions_.begin(stage->end, stage->name);
    return directions_.at_work();
}

// Returns the length of the route and the rooms on it. While the first legs are being planned, returns the rooms only.
std::string SpokenRoute::overview(const navigation::Route& route) const {
    const std::string through = rooms_between(rooms_, route);
    if (directions_.state() != RouteDirections::State::Planned) return length_words(through);
    return through.empty() ? phrase("leg.looks") : phrase("route.through", {{"rooms", through}});
}

// Returns the length of the route that is followed, through these rooms. The length is the sum of the legs that the
// person hears; it is approximate while their rest is being planned.
std::string SpokenRoute::length_words(const std::string& through) const {
    return summary_words(left_words(), !to_passage_ && directions_.whole() && directions_.at_work(), through, counts());
}

// Returns what the summary of the followed route counts. The turns and doors are those of the legs once all legs are
// known, and before that those of the planned path. A route that is still being planned is not counted.
RouteCounts SpokenRoute::counts() const {
    if (unfinished_) return {};
    RouteCounts counts = counts_of(follower_.route(), nodes_to(context_, follower_.route(), name_));
    if (const auto of_legs = to_passage_ ? std::nullopt : directions_.counts())
        counts = {of_legs->turns, of_legs->doors};
    const std::uint32_t to = navigation::room_at(rooms_.graph(), rooms_.space(), follower_.goal_m());
    counts.storeys = storeys_up(*context_.world.scene, rooms_.graph(), rooms_.here(), to);
    return counts;
}

std::string SpokenRoute::left_words() const {
    const auto of_legs = to_passage_ ? std::nullopt : directions_.total_words();
    return of_legs.value_or(distance_words(follower_.left_m(), distances(context_)));
}

void SpokenRoute::follow_again(const std::string& first, double now_s) {
    if (room_) {
        follow_to_room(*room_, first, now_s);
        return;
    }
    follow_to(Vec3(goal_m()), std::string(name_), first, now_s);
}

// Follows a route without announcing it. The route on display changes.
void SpokenRoute::follow_silently(navigation::Route route, const std::string& goal) {
    name_ = goal;
    announced_.reset();
    plans_.know(route.points_m);
    planned_in_ = context_.world.scene;
    // A route with one point, to where the person stands, would not be followed and could not end with an arrival.
    if (route.points_m.size() == 1) route.points_m.push_back(route.points_m.front());
    follower_.follow(route, nodes_to(context_, route, goal));
}

bool SpokenRoute::follow(navigation::Route route, const std::string& name, const std::string& first, double now_s,
                         RouteForm form) {
    stop();
    std::string goal = name, words = first;
    if (route.points_m.empty()) {
        context_.answer(beside(words, phrase("rooms.no_way_no_floor")), now_s);
        return false;
    }
    if (!route.reaches) {
        const std::uint32_t end = navigation::room_at(rooms_.graph(), rooms_.space(), route.points_m.back());
        const std::string short_of = distance_words(route.short_of_m, distances(context_));
        const std::string room = end == navigation::kNothing ? std::string() : rooms_.graph().rooms[end].name;
        words = beside(words, phrase(room.empty() ? "rooms.not_reached" : "rooms.not_reached_in",
                                     {{"goal", name}, {"room", room}, {"short_of", short_of}}));
        if (route.points_m.size() < 2) {
            context_.answer(words, now_s);
            return false;
        }
        goal = phrase("rooms.nearest_place_to", {{"goal", name}});
    }
    to_nearest_ = !route.reaches;
    if (form == RouteForm::ByLegs && route.points_m.size() > 1 &&
        follow_by_legs({navigation::kNothing, route.points_m.back()}, {route}, goal, words, now_s))
        return !to_nearest_;
    follow_silently(navigation::Route(route), goal);
    const std::string how = route_words(route, legs_to(route, goal), distances(context_), 1, counts());
    context_.announce(cues::SpeechTopic::Summary, beside(words, phrase("rooms.way", {{"goal", goal}, {"route", how}})),
                      now_s);
    context_.events.report(Led{goal, LedBy::Ear}, now_s);
    return !to_nearest_;
}

// Returns the legs of a route as it is planned, for routes without directions leg by leg.
std::vector<std::string> SpokenRoute::legs_to(const navigation::Route& route, const std::string& goal) const {
    return route_legs(route, nodes_to(context_, route, goal), context_.avatar.heading_rad, distances(context_));
}

void SpokenRoute::renew() {
    if (std::exchange(planned_in_, context_.world.scene) == context_.world.scene ||
        !rooms_.navigation().meets_leaf(follower_.ahead_m()))
        return;
    const Vec3& feet_m = context_.avatar.feet_m();
    navigation::Route route =
        plans_.runs_to(name_) ? plans_.on(feet_m) : rooms_.navigation().plan(feet_m, follower_.goal_m(), preference_);
    if (!route.reaches || route.points_m.size() < 2) return;
    unfinished_.reset();
    follow_silently(std::move(route), std::string(name_));
}

void SpokenRoute::announce_onward(double now_s) { context_.answer(on_words(), now_s); }

std::string SpokenRoute::on_words() {
    if (!follower_.following()) return phrase("way.none");
    const Vec3& feet_m = context_.avatar.feet_m();
    leave_stop();
    const auto leg = next_leg(planned(), feet_m, 0.5 * context_.settings.walk.step_length_m);
    if (!leg) return phrase("way.no_floor");
    announced_ = leg->route;
    const Vec3 off = leg->to_m - feet_m;
    const navigation::Route& route = leg->route;
    const std::string where = where_words(context_, std::hypot(off.x, off.y), std::atan2(off.x, off.y)),
                      all = sentence_case(distance_words(route.length_m, distances(context_)));
    std::string leaf = leaf_on_route(leg->to_m);
    const bool over_edge = std::any_of(route.passages.begin(), route.passages.end(), [&](const auto& passage) {
        return passage.kind == navigation::PassageKind::Drop && passage.at_m < leg->along_m + 1.0;
    });
    if (leaf.empty() && !over_edge)
        if (const auto aside_m = place_aside(leg->to_m)) {
            stopped_->aside_m = aside_m;
            const Vec3 way = *aside_m - feet_m;
            return phrase("way.next",
                          {{"goal", name_},
                           {"where", where_words(context_, std::hypot(way.x, way.y), std::atan2(way.x, way.y))},
                           {"all", all}});
        }
    if (!leaf.empty()) leaf = " " + capitalised(phrase("leg.leaf_in_way", {{"door", leaf}}));
    for (const navigation::RoutePassage& passage : route.passages)
        if (passage.at_m < leg->along_m + 1.0) {
            const bool open = must_be_opened(context_, passage.kind, passage.feature);
            const std::string what = joined(passage_now(context_, passage.kind, passage.feature, passage.rise_m),
                                            open ? phrase("questions.shut") : "");
            if (open && leaf.empty()) leaf = " " + phrase("leg.open_it");
            if (passage.kind == navigation::PassageKind::Climb && stands_at(passage))
                return phrase(
                    "way.at_stairs",
                    {{"goal", name_}, {"passage", what}, {"key", context_.keys.keys_of(Command::Use)}, {"all", all}});
            if (stands_in(passage))
                return phrase("way.in_lift", {{"goal", name_},
                                              {"passage", what},
                                              {"key", context_.keys.keys_of(Command::Use)},
                                              {"storeys", context_.keys.keys_of(Command::Storeys)},
                                              {"all", all}});
            return phrase("way.next_passage", {{"goal", name_}, {"where", where}, {"passage", what}, {"all", all}}) +
                   leaf;
        }
    return phrase("way.next", {{"goal", name_}, {"where", where}, {"all", all}}) + leaf;
}

// Returns true if the person stands near enough to these stairs to climb them with a key.
bool SpokenRoute::stands_at(const navigation::RoutePassage& passage) const {
    const Vec3 off = passage.place_m - context_.avatar.feet_m();
    return std::hypot(off.x, off.y) < Climbs::kAtEnd_m;
}

std::optional<navigation::RoutePassage> SpokenRoute::climb_here() const {
    if (!follower_.following()) return std::nullopt;
    const std::vector<navigation::RoutePassage> passages = planned().passages;
    if (passages.empty() || passages.front().kind != navigation::PassageKind::Climb || !stands_at(passages.front()))
        return std::nullopt;
    return passages.front();
}

// Returns true if the person stands in this lift, which does not move automatically.
bool SpokenRoute::stands_in(const navigation::RoutePassage& passage) const {
    return passage.kind == navigation::PassageKind::Lift && passage.feature &&
           context_.avatar.ground == passage.feature;
}

// Plans the rest of the route from here. If the new route leads back against the old one and is not much shorter,
// returns the old one. Otherwise, if two routes are equally long, each plan might choose the other one, and the person
// would walk to and fro.
navigation::Route SpokenRoute::planned() const {
    const Vec3& feet_m = context_.avatar.feet_m();
    if (plans_.runs_to(name_)) return plans_.looked_at(feet_m);
    navigation::Route anew = rooms_.navigation().plan(feet_m, follower_.goal_m(), preference_);
    const navigation::Route& followed = announced_ ? *announced_ : follower_.route();
    const navigation::RoutePlace here =
        navigation::near_on_path(followed.points_m, feet_m, announced_ ? 0.0 : follower_.along_m());
    const double ahead_m = here.along_m + kTakenUpAhead_m;
    if (here.distance_m > kLeftWay_m || ahead_m >= followed.length_m || anew.points_m.size() < 2) return anew;
    const Vec3 on_m = navigation::place_along(followed.points_m, ahead_m);
    const double least_m = 0.5 * context_.settings.walk.step_length_m;
    const auto leg = next_leg(anew, feet_m, least_m);
    const Vec3 back = leg->to_m - feet_m, on = on_m - feet_m;
    if (back.x * on.x + back.y * on.y >= 0.0 || rooms_.navigation().meets_leaf(follower_.ahead_m())) return anew;
    navigation::Route kept = rooms_.navigation().plan(feet_m, on_m, preference_);
    if (!kept.reaches) return anew;
    kept = joined(std::move(kept), rest_of(followed, ahead_m));
    return kept.length_m < kWorthTurningBack * anew.length_m ? kept : anew;
}

// Announces `words`. If `words` is empty because directions are still being planned, says that instead. A later tick
// announces the directions.
void SpokenRoute::announce(const std::string& words, cues::SpeechTopic topic, double now_s) {
    if (!words.empty()) return context_.announce(topic, words, now_s, {.answers = true, .place_m = leg_place_m()});
    if (directions_.at_work()) return context_.answer(phrase("leg.looks"), now_s);
    if (!follower_.following()) return announce_onward(now_s);
    // There are no further directions leg by leg, so the whole route is announced, as for a guided hand.
    no_legs_m_ = context_.avatar.feet_m();
    if (navigation::Route route = planned(); route.reaches && route.points_m.size() > 1)
        follow_silently(std::move(route), std::string(name_));
    announce_onward(now_s);
}

// Returns true if the rest of the route is announced leg by leg. After a lift, or away from a place where no legs were
// found, it may be, although the route was not before.
bool SpokenRoute::goes_by_legs() {
    constexpr double kElsewhere_m = 2.0;
    if (directions_.at_work() || !follower_.following()) return directions_.at_work();
    const bool tried = no_legs_m_ && glm::length(context_.avatar.feet_m() - *no_legs_m_) < kElsewhere_m;
    if (tried || plans_.runs_to(name_)) return false;
    navigation::Route rest = planned();
    if (!rest.reaches || rest.points_m.size() < 2) return false;
    const Vec3 end_m = room_ ? rooms_.graph().rooms[*room_].middle_m : rest.points_m.back();
    if (!begin_legs(rest, {room_.value_or(navigation::kNothing), end_m}, name_)) return false;
    follow_silently(std::move(rest), std::string(name_));
    return true;
}

void SpokenRoute::announce_leg(double now_s) {
    rest_requested_ = false;
    if (!goes_by_legs()) return announce_onward(now_s);
    announce(directions_.leg(), cues::SpeechTopic::Leg, now_s);
}

void SpokenRoute::announce_leg_unprompted(std::string words, bool anew, double now_s) {
    if (words.empty()) return;
    context_.announce(cues::SpeechTopic::Leg, std::move(words), now_s, {.anew = anew, .place_m = leg_place_m()});
}

// Returns a place one metre from the ears in the direction of the announced leg.
std::optional<Vec3> SpokenRoute::leg_place_m() const {
    const auto heading_rad = directions_.at_work() ? directions_.heading_rad() : std::nullopt;
    if (!heading_rad) return std::nullopt;
    return context_.avatar.ears_m() + forward_of_heading(*heading_rad);
}

// Announces again how the route continues from here, because the line about it was cut off.
void SpokenRoute::announce_anew(cues::SpeechTopic topic, double now_s) {
    if (!follower_.following()) return;
    if (topic == cues::SpeechTopic::Leg)
        return announce_leg_unprompted(directions_.at_work() ? directions_.leg() : on_words(), true, now_s);
    const navigation::Route route = planned();
    if (route.points_m.size() < 2) return;
    const std::string how =
        directions_.at_work() ? overview(route) : route_words(route, legs_to(route, name_), distances(context_), 1);
    context_.announce(cues::SpeechTopic::Summary, phrase("rooms.way", {{"goal", name_}, {"route", how}}), now_s,
                      {.anew = true});
}

void SpokenRoute::announce_next_leg(double now_s) {
    rest_requested_ = false;
    if (!goes_by_legs()) return announce_onward(now_s);
    announce(directions_.next_leg(), cues::SpeechTopic::Leg, now_s);
}

void SpokenRoute::announce_rest(double now_s) {
    const std::vector<std::string> legs = rest_of_route();
    rest_requested_ = legs.empty();
    announce(fmt::format("{}", fmt::join(legs, " ")), cues::SpeechTopic::Leg, now_s);
}

bool SpokenRoute::leap_on(double now_s) {
    if (!follower_.following() || directions_.state() == RouteDirections::State::Planned) return false;
    const Place from{context_.avatar.feet_m(), context_.avatar.heading_rad};
    bool last = false;
    if (const auto end = directions_.move_on()) {
        context_.session_requests.place(end->at_m, end->heading_rad, now_s);
        last = end->last && !to_passage_;
    } else if (const auto node = follower_.next_node()) {
        context_.session_requests.place(node->at_m, node->heading_rad, now_s);
        last = node->last;
    } else {
        return false;
    }
    leapt_from_.push_back(from);
    context_.play(cues::SoundKind::Arrived, now_s);
    const std::string leg = last ? std::string() : directions_.at_work() ? directions_.leg() : on_words();
    announce(leg.empty() ? place_facing_words(context_, rooms_) : place_facing_words(context_, rooms_) + " " + leg,
             cues::SpeechTopic::Leg, now_s);
    return true;
}

bool SpokenRoute::leap_back(double now_s) {
    if (leapt_from_.empty()) return false;
    const Place to = leapt_from_.back();
    leapt_from_.pop_back();
    context_.session_requests.place(to.feet_m, to.heading_rad, now_s);
    // The present leg is now another one. Its words follow as soon as it is planned.
    if (directions_.at_work()) directions_.plan_from_here();
    context_.play(cues::SoundKind::Arrived, now_s);
    announce(directions_.at_work() ? place_facing_words(context_, rooms_)
                                   : place_facing_words(context_, rooms_) + " " + on_words(),
             cues::SpeechTopic::Leg, now_s);
    return true;
}

std::vector<std::string> SpokenRoute::rest_of_route() {
    if (!follower_.following()) return {};
    if (goes_by_legs()) {
        std::vector<std::string> legs = directions_.rest();
        if (to_passage_ && !legs.empty()) append_legs_behind(legs, context_, planned(), name_);
        return legs;
    }
    const navigation::Route route = planned();
    if (route.points_m.size() < 2 && !route.reaches) return {};
    std::vector<std::string> legs = legs_to(route, name_);
    if (legs.empty()) legs.push_back(phrase("route.there"));
    return legs;
}

std::optional<double> SpokenRoute::leg_heading_rad() const {
    if (!follower_.following()) return std::nullopt;
    if (const auto heading_rad = directions_.heading_rad()) return heading_rad;
    const Vec3& feet_m = context_.avatar.feet_m();
    const auto leg = next_leg(planned(), feet_m, 0.5 * context_.settings.walk.step_length_m);
    if (!leg) return std::nullopt;
    return std::atan2(leg->to_m.x - feet_m.x, leg->to_m.y - feet_m.y);
}

RouteFollower::Said SpokenRoute::tick(double now_s) {
    plan_on();
    if (directions_.at_work()) return tick_words(now_s);
    return follower_.tick(context_.avatar.feet_m(), distances(context_), [this](bool at_end) { return there(at_end); });
}

// Returns true if the person has arrived. If the goal is a room, the walker must stand inside it. Otherwise, the walker
// must be at the goal, with nothing in between.
bool SpokenRoute::there(bool at_end) const {
    const Vec3& feet_m = context_.avatar.feet_m();
    if (room_) {
        const navigation::RoomGraph& graph = rooms_.graph();
        if (navigation::stands_inside(graph, rooms_.space(), *rooms_.file_scene(), feet_m, *room_)) return true;
        // If a room is too small to stand inside, the walker must be at its middle.
        return at_end && glm::length(feet_m - graph.rooms[*room_].middle_m) < kAtPlace_m;
    }
    return at_end && (glm::length(feet_m - follower_.goal_m()) < kAtPlace_m ||
                      rooms_.space().straight(feet_m, follower_.goal_m()));
}

RouteFollower::Said SpokenRoute::tick_words(double now_s) {
    RouteFollower::Said said;
    const RouteDirections::News news = directions_.tick();
    if (news.planned) {
        if (!directions_.at_work()) {
            // There are no directions leg by leg, so the whole route is announced, as for a guided hand.
            const std::optional<std::uint32_t> room = room_;
            const bool to_nearest = to_nearest_, on_foot = !to_passage_;
            if (follow(planned(), std::string(name_), {}, now_s, RouteForm::Whole)) room_ = room;
            to_nearest_ = to_nearest_ || to_nearest;
            no_legs_m_ = context_.avatar.feet_m();
            if (on_foot) preference_ = navigation::RoutePreference::OnFoot;
            return said;
        }
        // The person requested these legs before they were planned, so they are announced now.
        if (!rest_requested_) {
            std::string words = directions_.leg();
            if (std::exchange(length_owed_, false)) words = length_words({}) + ' ' + words;
            context_.announce(cues::SpeechTopic::Leg, std::move(words), now_s,
                              {.answers = true, .place_m = leg_place_m()});
        } else if (!directions_.rest().empty()) {
            announce_rest(now_s);
        }
    }
    announce_facing(now_s);
    said.left = news.left;
    said.arrived = news.arrived;
    if (!news.arrived) return said;
    if (to_passage_) {
        directions_.stop();
        said.arrived = false;
        said.text = on_words();
        return said;
    }
    said.text = phrase("route.arrived", {{"goal", sentence_case(name_)}});
    stop();
    return said;
}

// Plays a soft tone from ahead once, when the person has turned to the direction of the leg.
void SpokenRoute::announce_facing(double now_s) {
    constexpr double kFacing_rad = 0.05, kLoudness = 0.4;
    const auto heading_rad = directions_.heading_rad();
    const bool faces = heading_rad && std::abs(wrap_angle(*heading_rad - context_.avatar.heading_rad)) < kFacing_rad;
    if (!std::exchange(faces_, faces) && faces) {
        cues::CueRequest tone =
            sound_at(cues::SoundKind::BeaconAhead,
                     context_.avatar.ears_m() + forward_of_heading(context_.avatar.heading_rad), now_s);
        tone.loudness = kLoudness;
        context_.cues.cue(std::move(tone));
    }
}

}  // namespace handrail::core
