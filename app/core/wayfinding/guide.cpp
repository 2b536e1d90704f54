#include "app/core/wayfinding/guide.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/core/context/context_words.h"
#include "app/core/context/kinds_first.h"
#include "app/core/context/thing_here.h"
#include "app/core/wayfinding/find_list.h"
#include "app/core/wayfinding/hand_path.h"
#include "app/core/wayfinding/place_table.h"
#include "app/core/wayfinding/storey_list.h"
#include "app/core/whereabouts/storeys.h"
#include "app/core/world/body_heights.h"
#include "app/core/world/questions.h"
#include "audio-cues/plan/speakable.h"
#include "worlds/base/language.h"
#include "worlds/navigation/foot_distances.h"

namespace handrail::core {
namespace {

constexpr double kNoRoute_m = 1e6;  // a distance larger than any distance on foot
// At most this many routes are planned for a list; each plan costs some milliseconds.
constexpr std::size_t kMostOnFoot = 16;

bool is_surface(FeatureKind kind) {
    return kind == FeatureKind::Wall || kind == FeatureKind::Floor || kind == FeatureKind::Ceiling ||
           kind == FeatureKind::Slope;
}

// Appends the doors and stairs on the route to `words`, if there are any.
std::string with_passages(const std::string& words, const HandRoute& way) {
    if (way.passes.empty()) return words;
    return beside(words, phrase("lead.by_way_of", {{"passages", fmt::format("{}", fmt::join(way.passes, ", "))}}));
}

}  // namespace

void Guide::enter_world() {
    goal_.reset();
    planned_.clear();
    laps_ = {};
    help_limit_.reset();
    plans_.enter_world();
    ear_.stop();
    arrival_.forget();
    ground_.enter_world();
    hand_.enter_world();
    seek_.enter_world();
    doors_.forget_announced();
}

bool Guide::act(Command command, double now_s) {
    if (command == Command::SetBeacon) beacon_here(now_s);
    else if (command == Command::MuteBeacon) mute_beacon(now_s);
    else if (command == Command::TakeMe) take_me(now_s);
    else if (command == Command::Find) open_find(now_s);
    else if (command == Command::CrossLines) toggle_lines(now_s);
    else if (command == Command::Routes) list_routes(now_s);
    else if (command == Command::Storeys) list_storeys(now_s);
    else if (command == Command::Places) list_places(now_s);
    else if (command == Command::RepeatLeg) ear_.announce_leg(now_s);
    else if (command == Command::NextLeg) ear_.announce_next_leg(now_s);
    else if (command == Command::RestOfRoute) ear_.announce_rest(now_s);
    else if (command == Command::FaceRoute) face_route(now_s);
    else if (command == Command::LeapNext || command == Command::LeapLast)
        return leap_along(command == Command::LeapNext, now_s);
    else return false;
    return true;
}

bool Guide::follow_to(const Vec3& goal_m, const std::string& name, bool by_room, double now_s) {
    if (!rooms_.known()) return false;
    if (by_room) {
        const std::uint32_t room = navigation::room_at(rooms_.graph(), rooms_.space(), goal_m);
        return room != navigation::kNothing && ear_.follow_to_room(room, {}, now_s);
    }
    ear_.follow_to(goal_m, name, {}, now_s);
    return ear_.following() && !ear_.to_nearest();
}

std::vector<std::string> Guide::take_legs() {
    std::vector<std::string> legs = ear_.following() ? ear_.rest_of_route() : std::vector<std::string>{};
    ear_.stop();
    return legs;
}

// ---- every tick ----

void Guide::follow(double now_s) {
    ground_.tick();
    if (!ear_.following()) return;
    if (plans_.by_hand()) plans_.pass(finding_place_m(context_));
    else if (plans_.running()) plans_.pass(ear_.along_m());
    ear_.renew();
    const bool to_room = ear_.leads_to_room();
    const RouteFollower::Said said = ear_.tick(now_s);
    const std::string name = ear_.name();
    if (said.left) {
        // The person has left the route. It is planned again from the present place, and that is announced once.
        context_.events.report(LeftRoute{name, LedBy::Ear}, now_s);
        if (plans_.runs_to(name)) go_on(phrase("lead.left_way"), now_s);
        else ear_.follow_again(phrase("lead.left_way"), now_s);
    } else if (!said.text.empty()) {
        if (said.arrived) context_.play(cues::SoundKind::Arrived, now_s);
        if (said.arrived && plans_.runs_to(name) && next_stop(said.text, now_s)) return;
        if (!said.arrived) return ear_.announce_leg_unprompted(said.text, false, now_s);
        arrival_.tell(said.text, {.room = to_room, .led = on_route()}, now_s);
        context_.events.report(Arrived{name, LedBy::Ear, ear_.to_nearest()}, now_s);
        plans_.end();
        if (beacon().name() == name) silence_beacon();
    }
}

void Guide::announce_anew(cues::SpeechTopic topic, double now_s) {
    ear_.announce_anew(topic, now_s);
    if (topic != cues::SpeechTopic::Summary) return;
    if (ear_.following()) return seek_.announce_anew(now_s);
    if (beacon().on()) tell_beacon(now_s);
    if (seek_.warmer().on()) tell_warmer(now_s);
}

void Guide::lead(double now_s) {
    if (hand_.wants_new_path(goal_, now_s)) {
        context_.events.report(LeftRoute{goal_->name, LedBy::Hand}, now_s);
        const int errors = hand_.errors();
        lead_to(Goal(*goal_), phrase("lead.left_way"), now_s);
        hand_.count_errors_from(errors + 1);
    }
    const auto arrival = hand_.tick(goal_, now_s);
    if (!arrival) return;
    if (arrival->by_pull) laps_.finish(hand_.errors(), context_.settings.guidance.fades);
    const std::string name = goal_ ? goal_->name : std::string();
    if (arrival->to_nearest) plans_.end();
    if (plans_.runs_to(name) && plans_.by_hand() && next_stop(phrase("ways.reached", {{"stop", name}}), now_s)) return;
    context_.events.report(Arrived{name, arrival->by_pull ? LedBy::Hand : LedBy::Lines, arrival->to_nearest}, now_s);
    arrival_.tell(phrase(arrival->to_nearest ? "lead.nearest_place" : "lead.here", {{"goal", name}}),
                  {.answers = true, .led = on_route()}, now_s);
}

void Guide::call(double now_s) {
    if (seek_.tick_beacon(now_s)) {
        // The route ends together with the beacon, so that the arrival is announced only once.
        if (ear_.name() == beacon().name() && !plans_.running()) ear_.stop();
        context_.events.report(Arrived{beacon().name(), LedBy::Beacon}, now_s);
        tell_found(beacon().name(), now_s);
    }
    if (seek_.tick_warmer(now_s)) tell_found(seek_.warmer().name(), now_s);
}

// Announces that the person has found a thing by its sound.
void Guide::tell_found(const std::string& name, double now_s) {
    context_.play(cues::SoundKind::Arrived, now_s);
    arrival_.tell(phrase("lead.here", {{"goal", name}}), {.answers = true, .led = on_route()}, now_s);
}

// ---- following a saved route ----

void Guide::go_along(const std::vector<Stop>& stops, bool by_hand, double now_s) {
    hand_.end();
    ear_.stop();
    const Vec3 here = by_hand ? finding_place_m(context_) : context_.avatar.feet_m();
    plans_.begin(stops, near_stop(stops.front(), here, kAtStop_m), by_hand);
    go_on({}, now_s);
}

// Continues to the next stop with a name. `first` is announced before everything else.
void Guide::go_on(const std::string& first, double now_s) {
    const Stop& stop = plans_.stop();
    if (plans_.by_hand()) return lead_to(goal_of(context_, stop), first, now_s);
    ear_.follow(plans_.on(context_.avatar.feet_m()), stop.name, first, now_s, RouteForm::Whole);
}

// Continues the saved route after its stop was reached. If the route continues, announces that after `words`, which
// announce the arrival, and returns true.
bool Guide::next_stop(const std::string& words, double now_s) {
    const StopPassed passed{plans_.stop().name, plans_.by_hand() ? LedBy::Hand : LedBy::Ear};
    if (!plans_.next()) return false;
    context_.events.report(passed, now_s);
    go_on(words, now_s);
    return true;
}

// ---- to rooms ----

void Guide::list_routes(double now_s) {
    if (!rooms_.have(now_s)) return;
    const navigation::RoomGraph& graph = rooms_.graph();
    const Vec3& feet_m = context_.avatar.feet_m();
    const navigation::FootDistances on_foot(graph, rooms_.here(), feet_m);
    struct Near {
        // Distance on foot; rooms without a known route come after all others, ordered by direct distance.
        double order_m = 0.0;
        std::uint32_t room = 0;
        std::optional<double> way_m;
    };
    std::vector<Near> near;
    for (std::uint32_t r = 0; r < graph.rooms.size(); ++r) {
        if (r == rooms_.here()) continue;
        const Vec3& middle_m = graph.rooms[r].middle_m;
        near.push_back({on_foot.to(r, middle_m).value_or(kNoRoute_m + glm::length(middle_m - feet_m)), r, {}});
    }
    const auto in_order = [](const Near& a, const Near& b) { return a.order_m < b.order_m; };
    std::stable_sort(near.begin(), near.end(), in_order);
    // For the nearest rooms, the list shows the same distance on foot that is announced when the room is chosen. For
    // rooms farther away, the distance on foot is announced only after the choice.
    const std::size_t planned = std::min(near.size(), kMostOnFoot);
    for (std::size_t i = 0; i < planned; ++i)
        if (const navigation::Route route = ear_.to_room(near[i].room, on_foot); route.reaches) {
            near[i].order_m = route.length_m;
            near[i].way_m = route.length_m;
        }
    std::stable_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(planned), in_order);
    ListSpec list;
    list.title = phrase("rooms.way_to");
    std::vector<std::uint32_t> rooms;
    if (ear_.following()) {
        list.items.push_back({phrase("way.goes_on"), {}, false});
        list.items.back().also_typed = phrase("way.goes_on_question");
        list.items.push_back({phrase("rooms.stop_following"), {}, false});
        rooms.assign(2, navigation::kNothing);
    }
    std::vector<std::vector<std::string>> kinds = kinds_of_rooms(*context_.world.scene, graph);
    std::vector<std::vector<std::string>> kinds_of_items(list.items.size());
    for (const auto& [order_m, room, way_m] : near) {
        kinds_of_items.push_back(std::move(kinds[room]));
        const std::string far = way_m ? distance_words(*way_m, distances(context_)) : std::string();
        list.items.push_back({sentence_case(graph.rooms[room].name),
                              joined(far, storey_words(context_, graph.rooms[room].middle_m.z)), false});
        rooms.push_back(room);
    }
    if (list.items.empty()) return context_.answer(phrase("rooms.no_other"), now_s);
    list.chosen = [this, rooms](std::size_t at) {
        if (rooms[at] == navigation::kNothing && at == 0) return ear_.announce_onward(context_.tick_s);
        if (rooms[at] == navigation::kNothing) {
            ear_.stop();
            plans_.end();
            return context_.answer(phrase("lead.stopped"), context_.tick_s);
        }
        go_to_room(rooms[at], context_.tick_s);
    };
    open_kinds_first(context_, std::move(list), kinds_of_items, now_s);
}

void Guide::list_storeys(double now_s) {
    open_storey_list(
        context_, rooms_, doors_, [this](std::uint32_t room, double then_s) { go_to_room(room, then_s); }, now_s);
}

void Guide::list_places(double now_s) {
    if (!rooms_.have(now_s)) return;
    open_places(
        context_, rooms_,
        [this](const PlaceRow& row, double then_s) {
            if (row.room_index == navigation::kNothing) return open_tools(row.goal, then_s);
            if (row.room_index == rooms_.here())
                return context_.answer(phrase("answer.in_room", {{"room", row.name}}), then_s);
            go_to_room(row.room_index, then_s);
        },
        now_s);
}

void Guide::go_to_room(std::uint32_t room, double now_s) {
    plans_.end();
    planned_.note(stop_in_room(rooms_, room), context_.avatar.feet_m());
    if (!ear_.follow_to_room(room, {}, now_s) && on_no_route) on_no_route(room, now_s);
}

// Leaps from leg to leg while a route is followed by ear. Returns false if the leap is not along a route.
bool Guide::leap_along(bool on, double now_s) {
    if (!ear_.following()) return false;
    if (on_leap) on_leap();
    return on ? ear_.leap_on(now_s) : ear_.leap_back(now_s);
}

void Guide::face_route(double now_s) {
    const auto heading_rad = ear_.leg_heading_rad();
    if (!heading_rad) return ear_.announce_onward(now_s);
    if (on_face) on_face(*heading_rad, now_s);
}

// ---- to things ----

void Guide::open_find(double now_s) {
    open_find_list(
        context_, rooms_, [this](const Goal& goal, double then_s) { open_tools(goal, then_s); }, now_s);
}

void Guide::open_tools(const Goal& goal, double now_s) {
    goal_ = goal;
    ListSpec list;
    list.title = goal.name;
    for (const char* way : {"guide.beacon", "guide.take_me", "guide.warmer", "guide.lines"})
        list.items.push_back({phrase(way), ""});
    list.items.push_back({phrase("guide.where_is_it"), where_words(context_, announced_box(rooms_, goal))});
    list.items.back().also_typed = phrase("guide.where_is_it_question");
    list.chosen = [this, goal](std::size_t i) {
        if (i == 0) set_beacon(goal, context_.tick_s);
        if (i == 1) lead_as_planned(goal, context_.tick_s);
        if (i == 2) seek_warmer(goal, context_.tick_s);
        if (i == 3) cross_lines(goal, context_.tick_s);
        if (i == 4)
            context_.answer(joined(goal.name, where_words(context_, announced_box(rooms_, goal))), context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

void Guide::go_to_thing(const Goal& goal, double now_s) {
    goal_ = goal;
    lead_as_planned(goal, now_s);
}

void Guide::call_from(const Goal& goal) {
    context_.events.report(Led{goal.name, LedBy::Beacon}, context_.tick_s);
    goal_ = goal;
    seek_.start_beacon(goal);
}

void Guide::set_beacon(const Goal& goal, double now_s) {
    call_from(goal);
    tell_beacon(now_s);
}

// Announces what the beacon is on, where that is from here, and how the beacon guides.
void Guide::tell_beacon(double now_s) { context_.announce(cues::SpeechTopic::Summary, beacon_words(now_s), now_s); }

// Puts the beacon on what the hand touches, or else on what is straight ahead. If there is neither, the person chooses
// from a list.
void Guide::beacon_here(double now_s) {
    const auto here = thing_here(context_);
    const Feature* feature = here ? context_.world.scene->find(here->id) : nullptr;
    if (!feature) return open_find(now_s);
    const bool whole = !is_surface(feature->kind) && !feature->bounds_m.empty();
    set_beacon({sentence_case(cues::speakable(spoken_name(*feature))),
                whole ? feature->bounds_m : point_box(here->place_m), here->id},
               now_s);
}

void Guide::mute_beacon(double now_s) {
    if (beacon().on()) {
        silence_beacon();
        return context_.answer(phrase("guide.beacon_off"), now_s);
    }
    if (goal_) return set_beacon(Goal(*goal_), now_s);
    context_.answer(phrase("guide.no_beacon", {{"key", context_.keys.keys_of(Command::SetBeacon)}}), now_s);
}

void Guide::seek_warmer(const Goal& goal, double now_s) {
    goal_ = goal;
    if (seek_.warmer().on() && seek_.warmer().name() == goal.name) {
        seek_.silence_warmer();
        return context_.answer(phrase("guide.warmer_off"), now_s);
    }
    seek_.start_warmer(goal);
    tell_warmer(now_s);
}

// Announces to what "warmer" guides, and how.
void Guide::tell_warmer(double now_s) {
    const std::string how = seek_.warmer_words(now_s);
    context_.announce(cues::SpeechTopic::Summary,
                      phrase("guide.warmer_on", {{"name", seek_.warmer().name()}}) + (how.empty() ? how : ". " + how),
                      now_s);
}

// ---- guidance ----

void Guide::take_me(double now_s) {
    if (hand_.at_work()) {
        hand_.end();
        context_.play(cues::SoundKind::GuideStop, now_s);
        return context_.answer(phrase("lead.let_go"), now_s);
    }
    if (!hand_.may_lead() && ear_.following()) {
        ear_.stop();
        plans_.end();
        silence_beacon();
        return context_.answer(phrase("lead.stopped"), now_s);
    }
    if (!hand_.may_lead() && beacon().on()) return mute_beacon(now_s);
    if (!goal_) return open_find(now_s);
    lead_to(Goal(*goal_), {}, now_s);
}

void Guide::leave_route() {
    hand_.end();
    ear_.stop();
    plans_.end();
    seek_.silence_beacon();
}

// Guides to a goal, and notes it as the next stop of the planned route.
void Guide::lead_as_planned(const Goal& goal, double now_s) {
    plans_.end();
    const Vec3 from = hand_.may_lead() && hand_.force_may_act() ? finding_place_m(context_) : context_.avatar.feet_m();
    if (rooms_.known()) planned_.note(stop_at_goal(context_, rooms_, goal, from), from);
    lead_to(goal, {}, now_s);
}

// Guides the hand if there is one, or else guides by ear. `first` is announced before everything else.
void Guide::lead_to(const Goal& goal, const std::string& first, double now_s) {
    goal_ = goal;
    if (!hand_.may_lead()) return lead_by_ear(goal, first, now_s);
    if (const std::string why = hand_.why_no_force(); !why.empty()) return lead_by_ear(goal, beside(first, why), now_s);
    const HandRoute way = plans_.for_hand(goal, servo::GuidancePath::kMostPoints);
    if (way.points_m.empty()) return lead_by_ear(goal, beside(first, way.problem), now_s);
    // The number of the feature distinguishes things with the same name.
    laps_.begin(fmt::format("{} {}", goal.name, goal.feature.value));
    const std::string where = where_words(context_, announced_box(rooms_, goal));
    const auto taking = [&] {
        if (!way.reaches)
            return phrase("lead.to_nearest",
                          {{"goal", goal.name}, {"short_of", distance_words(way.short_of_m, distances(context_))}});
        return phrase(help() == 0.0 ? "lead.alone" : "lead.taking", {{"goal", goal.name}, {"where", where}});
    };
    std::string words = with_passages(beside(first, taking()), way);
    if (help() == 1.0) words = beside(words, phrase("lead.hold_to_end"));
    else if (help() > 0.0) words = beside(words, phrase("lead.help", {{"percent", std::lround(100.0 * help())}}));
    context_.events.report(Led{goal.name, LedBy::Hand}, now_s);
    hand_.pull(way, help() * context_.settings.guidance.strength, std::move(words), now_s);
}

// Announces the route in words and follows it, as for a room. If nothing is between the walker and the thing, announces
// no route, and the beacon sounds from the thing.
void Guide::lead_by_ear(const Goal& goal, const std::string& first, double now_s) {
    hand_.end();
    ear_.stop();
    silence_beacon();
    if (plans_.runs_to(goal.name) && plans_.by_hand()) {
        plans_.go_on_by_ear();
        return go_on(first, now_s);
    }
    const WalkerWorld& solids = *context_.world.solids;
    const Vec3& feet_m = context_.avatar.feet_m();
    const Vec3 waist_m = feet_m + Vec3(0.0, 0.0, kWaist_m);
    const bool in_sight = free_line(solids, waist_m, place_on(goal.box_m, waist_m), goal.feature);
    navigation::Route route;
    if (rooms_.known()) route = walk_to_thing(rooms_.navigation(), solids, feet_m, goal.box_m, goal.feature);
    const bool straight = route.reaches && route.points_m.size() <= 2;
    if (in_sight || route.points_m.empty()) seek_.start_beacon(goal);
    if (route.points_m.empty() || (in_sight && straight)) {
        context_.events.report(Led{goal.name, LedBy::Beacon}, now_s);
        const std::string where = where_words(context_, announced_box(rooms_, goal));
        return context_.answer(beside(first, phrase("lead.follow_beacon", {{"goal", goal.name}, {"where", where}})),
                               now_s);
    }
    ear_.follow(std::move(route), goal.name, first, now_s, RouteForm::ByLegs);
}

// Sets lines from the hand along the route to the thing. If there is no route, or the person does not want to use it,
// sets three planes through the thing that hold the hand gently.
void Guide::cross_lines(const Goal& goal, double now_s) {
    goal_ = goal;
    if (!context_.hands.right.present) return context_.answer(phrase("lead.lines_need_device"), now_s);
    if (const std::string why = hand_.why_no_force(); !why.empty()) return context_.answer(why, now_s);
    std::string why = phrase("lead.straight");
    if (context_.settings.guidance.along_way) {
        const HandRoute way = plans_.for_hand(goal, HandLead::kMostLinePoints);
        if (way.reaches && way.points_m.size() >= 2) {
            const std::string where = where_words(context_, announced_box(rooms_, goal));
            context_.events.report(Led{goal.name, LedBy::Lines}, now_s);
            return hand_.lines(
                way, with_passages(phrase("lead.lines_along", {{"goal", goal.name}, {"where", where}}), way), now_s);
        }
        why = beside(way.problem, phrase(way.reaches ? "lead.straight" : "lead.no_way"));
    }
    hand_.cross_lines(goal.box_m.centre_m(), beside(phrase("lead.lines", {{"goal", goal.name}}), why), now_s);
}

void Guide::toggle_lines(double now_s) {
    if (hand_.lines_at_work()) {
        hand_.end();
        context_.play(cues::SoundKind::GuideStop, now_s);
        return context_.answer(phrase("lead.lines_off"), now_s);
    }
    if (!goal_) return open_find(now_s);
    cross_lines(Goal(*goal_), now_s);
}

}  // namespace handrail::core
