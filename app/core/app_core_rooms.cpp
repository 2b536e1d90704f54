// AppCore's part on rooms and ways: which room one is in, its exits, the way to another room in words and along it. App thread only.
#include <algorithm>
#include <cmath>

#include "app/core/app_core.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
void AppCore::begin_rooms(std::shared_ptr<const Scene> scene) {
    const BodySize size = body_size(*scene, settings_.walk.body_radius_m);
    rooms_.reset();  // what was being looked for is given up before the next begins
    rooms_ = std::make_unique<RoomsOfWorld>(scene, walk_body(*scene, size.radius_m, size.height_m, size.step_up_m), !rooms_beside_);
    leaves_of_.reset();
    rooms_told_ = false;
    room_ = kNothing;
    visited_rooms_.clear();
    drawn_rooms_.reset();
    follower_.stop();
    run_.reset();
}

// Rooms and ways are there to be used; where the same must happen in every run they are looked for now.
bool AppCore::rooms_known() {
    const bool known = rooms_ && (!rooms_beside_ || rooms_->ready()) && rooms_->ready() && rooms_->found();
    if (known) know_leaves();
    return known;
}

// Ways lead round the leaves of doors that stand open, as of when everything came to rest last.
void AppCore::know_leaves() {
    if (!rooms_ || !rooms_->done() || !rooms_->found() || leaves_of_ == scene_) return;
    leaves_of_ = scene_;
    std::vector<OpenLeaf> leaves;
    for (std::uint32_t i = 0; i < movers_.size(); ++i) {
        const Mover& mover = scene_->movers[i];
        if (thing_of_mover_[i] < 0 || scene_->features[mover.feature.value].kind != FeatureKind::Door) continue;
        if (movers_.at(i) == mover.at(0.0)) continue;  // as the file has it: shut, also where it rests open
        const auto thing = static_cast<std::size_t>(thing_of_mover_[i]);
        const Aabb& own = scene_->placed[thing].model->bounds_m;
        const Vec3 size = own.size_m();
        if (size.z < std::min(size.x, size.y)) continue;  // a bridge or trap door, which one walks over
        leaves.push_back({own, things_.at(thing)});
    }
    rooms_->navigation().know_leaves(leaves);
}

// True when rooms are there to speak of; else says why not.
bool AppCore::have_rooms(double now_s) {
    if (!rooms_ || (rooms_beside_ && !rooms_->ready())) {
        answer(phrase("rooms.not_yet"), now_s);
        return false;
    }
    if (rooms_->ready() && rooms_->found()) {
        know_leaves();
        notice_room(now_s, true);
        return true;
    }
    answer(rooms_->problem(), now_s);
    return false;
}

// "Kitchen. " where there is more than one room; empty where nothing is known.
std::string AppCore::room_words(double now_s) {
    if (!rooms_known() || rooms_->graph().rooms.size() < 2) return {};
    notice_room(now_s, true);
    return room_ == kNothing ? std::string() : phrase("rooms.here", {{"room", sentence_case(rooms_->graph().rooms[room_].name)}}) + " ";
}

// Which room one is in now; `quietly`: without a word about it.
void AppCore::notice_room(double now_s, bool quietly) {
    if (!rooms_ || !rooms_->done() || !rooms_->found()) return;
    RoomGraph& graph = rooms_->graph();
    if (!rooms_told_) {
        rooms_told_ = true;
        visited_rooms_.assign(graph.rooms.size(), false);
        lay_given_names(now_s);
        for (const std::string& sentence : rooms_->navigation().said()) say(sentence, SpeechClass::Ambient, now_s);
        quietly = true;
    }
    if (plan_view_) draw_rooms();
    const std::uint32_t now_in = room_at(graph, rooms_->navigation().space(), feet_m());
    if (now_in == kNothing || now_in == room_) return;
    room_ = now_in;
    visited_rooms_[room_] = true;
    if (!quietly && settings_.speech.rooms) say(sentence_case(graph.rooms[room_].name), SpeechClass::Ambient, now_s);
}

// For the plan: once, and again where a name has changed.
void AppCore::draw_rooms() {
    const RoomGraph& graph = rooms_->graph();
    if (drawn_rooms_ && drawn_language_ == graph.language) return;
    drawn_language_ = graph.language;
    std::vector<RoomOutline> outlines = room_outlines(graph, rooms_->navigation().space());
    std::vector<DrawnRoom> drawn;
    for (std::size_t r = 0; r < outlines.size(); ++r)
        drawn.push_back({sentence_case(graph.rooms[r].name), graph.rooms[r].middle_m, graph.rooms[r].area_m2, std::move(outlines[r])});
    drawn_rooms_ = std::make_shared<const std::vector<DrawnRoom>>(std::move(drawn));
}

std::string AppCore::passage_name(PassageKind kind, FeatureId feature, double rise_m) const {
    const auto rising = [rise_m](const std::string& passage) {
        if (rise_m == 0.0) return passage;
        return phrase(rise_m > 0.0 ? "rooms.passage_up" : "rooms.passage_down", {{"passage", passage}, {"metres", std::abs(rise_m)}});
    };
    const Feature* found = scene_->find(feature);
    const std::string name = found ? spoken_name(*found) : std::string();
    switch (kind) {
        case PassageKind::Door:
            return name.empty() ? phrase("rooms.door") : name;
        case PassageKind::Stairs:
            return rising(name.empty() || (found && found->kind != FeatureKind::Object) ? phrase("rooms.stairs") : name);
        case PassageKind::Lift:
            return rising(name.empty() ? phrase("rooms.lift") : name);
        case PassageKind::Drop:
            return rise_m == 0.0 ? phrase("rooms.edge_to_step_down") : rising(phrase("rooms.edge"));
        case PassageKind::Teleporter:
            return name.empty() ? phrase("rooms.teleporter") : name;
        case PassageKind::Opening:
            break;
    }
    return phrase("rooms.opening");
}

// With what is in the way there by now: "Door, locked".
std::string AppCore::passage_now(PassageKind kind, FeatureId feature, double rise_m) const {
    return joined(passage_name(kind, feature, rise_m), lock_words(feature));
}

void AppCore::tell_exits(bool unvisited_only, double now_s) {
    if (!have_rooms(now_s)) return;
    if (room_ == kNothing) return answer(phrase("rooms.nowhere"), now_s);
    const RoomGraph& graph = rooms_->graph();
    std::string told;
    int count = 0;
    for (const std::uint32_t p : exits_of(graph, room_, feet_m(), heading_rad_)) {
        const Portal& portal = graph.portals[p];
        const std::uint32_t other = portal.rooms[0] == room_ ? portal.rooms[1] : portal.rooms[0];
        if (unvisited_only && visited_rooms_[other]) continue;
        ++count;
        const Vec3 off = portal.place_m - feet_m();
        const std::string what = passage_name(portal.kind, portal.feature, 0.0), to = graph.rooms[other].name;
        const std::string exit = sentence_case(what);
        const std::string where = joined(where_words(std::hypot(off.x, off.y), std::atan2(off.x, off.y)), lock_words(portal.feature));
        told += " " + (to == what ? phrase("rooms.exit", {{"exit", exit}, {"where", where}})
                                  : phrase("rooms.exit_to", {{"exit", exit}, {"room", to}, {"where", where}}));
    }
    const std::string room = sentence_case(graph.rooms[room_].name);
    if (count == 0) return answer(phrase(unvisited_only ? "rooms.every_exit_taken" : "rooms.no_exits", {{"room", room}}), now_s);
    answer(phrase(unvisited_only ? "rooms.exits_not_taken" : "rooms.exits", {{"room", room}, {"count", count}}) + told, now_s);
}

void AppCore::list_routes(double now_s) {
    if (!have_rooms(now_s)) return;
    const RoomGraph& graph = rooms_->graph();
    std::vector<std::pair<double, std::uint32_t>> near;
    for (std::uint32_t r = 0; r < graph.rooms.size(); ++r)
        if (r != room_) near.emplace_back(glm::length(graph.rooms[r].middle_m - feet_m()), r);
    std::stable_sort(near.begin(), near.end());
    ListSpec list;
    list.title = phrase("rooms.way_to");
    std::vector<std::uint32_t> rooms;
    if (follower_.following()) {
        list.items.push_back({phrase("way.goes_on"), {}, false});
        list.items.push_back({phrase("rooms.stop_following"), {}, false});
        rooms.assign(2, kNothing);
    }
    for (const auto& [distance_m, room] : near) {
        list.items.push_back({sentence_case(graph.rooms[room].name), distance_words(distance_m, distances()), false});
        rooms.push_back(room);
    }
    if (list.items.empty()) return answer(phrase("rooms.no_other"), now_s);
    list.chosen = [this, rooms](std::size_t at) {
        if (rooms[at] == kNothing && at == 0) return tell_way_on(last_tick_s_);
        if (rooms[at] == kNothing) {
            follower_.stop();
            run_.reset();
            return answer(phrase("lead.stopped"), last_tick_s_);
        }
        way_to_room(rooms[at], last_tick_s_);
    };
    open_list(std::move(list), now_s);
}

void AppCore::way_to_room(std::uint32_t room, double now_s) {
    const Room& to = rooms_->graph().rooms[room];
    run_.reset();
    note_planned(stop_in_room(room), feet_m());
    follow_way(to.middle_m, sentence_case(to.name), {}, now_s);
}

// ---- names that the person gives ----

// Once the rooms are known.
void AppCore::lay_given_names(double now_s) {
    RoomGraph& graph = rooms_->graph();
    std::vector<Error> faults;
    room_names_ = read_room_names(side_file_, faults);
    if (!faults.empty()) say(unreadable_words("room_names.unreadable", faults), SpeechClass::Answer, now_s);
    lay_room_names(graph, rooms_->navigation().space(), side_file_, room_names_);
    if (std::string unfit = unfit_sentence(room_names_); !unfit.empty()) say(std::move(unfit), SpeechClass::Answer, now_s);
    tell_unfit_ways(now_s);
}

void AppCore::ask_room_name(double now_s) {
    if (!have_rooms(now_s)) return;
    if (room_ == kNothing) return answer(phrase("rooms.nowhere"), now_s);
    TextSpec question;
    question.question = phrase("room_names.ask", {{"room", sentence_case(rooms_->graph().rooms[room_].name)}});
    question.done = [this, room = room_](const std::string& typed) { name_room(room, typed, last_tick_s_); };
    question.left = [this] { answer(phrase("room_names.stays"), last_tick_s_); };
    ask_text(std::move(question), now_s);
}

void AppCore::name_room(std::uint32_t room, const std::string& typed, double now_s) {
    const auto name = good_name(typed);
    if (!name) return answer(name.error().message, now_s);
    RoomGraph& graph = rooms_->graph();
    for (std::uint32_t other = 0; other < graph.rooms.size(); ++other)
        if (other != room && lower_ascii(graph.rooms[other].name) == lower_ascii(*name))
            return answer(phrase("room_names.taken", {{"name", *name}, {"own", graph.rooms[room].name}}), now_s);
    const std::uint32_t known = name_of_room(graph, rooms_->navigation().space(), room_names_, room);
    if (known != kNothing) room_names_.erase(room_names_.begin() + known);
    const std::string before = known_as(graph.rooms[room]);
    // Its own name again takes the given one away.
    graph.rooms[room].given = *name != own_name(graph.rooms[room]);
    if (graph.rooms[room].given)
        room_names_.push_back({*name, graph.rooms[room].middle_m, graph.rooms[room].area_m2, side_file_.world_checksum(), true, {}});
    graph.rooms[room].name = *name;
    drawn_rooms_.reset();
    rename_room_in_ways(before, known_as(graph.rooms[room]));
    write_room_names(side_file_, room_names_);
    save_additions(now_s);
    answer(phrase("room_names.given", {{"name", *name}}), now_s);
}

std::vector<RouteNode> AppCore::nodes_to(const Route& route, const std::string& goal) const {
    return nodes_of(route, goal, [this](const RoutePassage& passage) { return passage_now(passage.kind, passage.feature, passage.rise_m); });
}

void AppCore::follow_way(const Vec3& goal_m, const std::string& name, const std::string& first, double now_s) {
    follow_route(rooms_->navigation().plan(feet_m(), goal_m), name, first, now_s);
}

// Where the goal cannot be reached, to the nearest place that can. `first` is said before all else.
void AppCore::follow_route(Route route, const std::string& name, const std::string& first, double now_s) {
    follower_.stop();
    std::string goal = name, words = first.empty() ? first : first + ' ';
    if (route.points_m.empty()) return answer(words + phrase("rooms.no_way_no_floor"), now_s);
    if (!route.reaches) {
        const std::uint32_t end = room_at(rooms_->graph(), rooms_->navigation().space(), route.points_m.back());
        const std::string short_of = distance_words(route.short_of_m, distances());
        words += end == kNothing ? phrase("rooms.not_reached", {{"goal", name}, {"short_of", short_of}})
                                 : phrase("rooms.not_reached_in", {{"goal", name}, {"room", rooms_->graph().rooms[end].name}, {"short_of", short_of}});
        if (route.points_m.size() < 2) return answer(words, now_s);
        words += ' ';
        goal = phrase("rooms.nearest_place_to", {{"goal", name}});
    }
    std::vector<RouteNode> nodes = nodes_to(route, goal);
    answer(words + phrase("rooms.way", {{"goal", goal}, {"route", route_words(route, nodes, heading_rad_, distances())}}), now_s);
    follow_name_ = goal;
    know_way(route.points_m);
    followed_in_ = scene_;
    follower_.follow(std::move(route), std::move(nodes));
}

// A leaf stands across the rest of the way by now: it goes on round it, without a word but what comes.
void AppCore::renew_followed() {
    if (std::exchange(followed_in_, scene_) == scene_ || !rooms_->navigation().meets_leaf(follower_.ahead_m())) return;
    Route route = runs_to(follow_name_) ? way_on(feet_m()) : rooms_->navigation().plan(feet_m(), follower_.goal_m());
    if (!route.reaches || route.points_m.size() < 2) return;
    std::vector<RouteNode> nodes = nodes_to(route, follow_name_);
    know_way(route.points_m);
    follower_.follow(std::move(route), std::move(nodes));
}

// The next straight stretch of a way from here that is longer than half a step; none: there is no way.
std::optional<AppCore::Leg> AppCore::next_leg(Route route) const {
    Leg leg;
    leg.route = std::move(route);
    const std::vector<Vec3>& points = leg.route.points_m;
    if (points.size() < 2) return std::nullopt;
    std::size_t corner = 1;
    while (corner + 1 < points.size() && glm::length(points[corner] - feet_m()) < 0.5 * settings_.walk.step_length_m) ++corner;
    for (std::size_t i = 1; i <= corner; ++i) leg.along_m += glm::length(points[i] - points[i - 1]);
    leg.to_m = points[corner];
    return leg;
}

// How far the way that is followed goes on straight, which way, and to what.
void AppCore::tell_way_on(double now_s) {
    if (!follower_.following()) return answer(phrase("way.none"), now_s);
    const bool kept = runs_to(follow_name_);
    const auto leg = next_leg(kept ? plan_through(rooms_->navigation(), feet_m(), run_->places()) : rooms_->navigation().plan(feet_m(), follower_.goal_m()));
    if (!leg) return answer(phrase("way.no_floor"), now_s);
    const Vec3 off = leg->to_m - feet_m();
    const Route& route = leg->route;
    const std::string where = where_words(std::hypot(off.x, off.y), std::atan2(off.x, off.y)), all = sentence_case(distance_words(route.length_m, distances()));
    for (const RoutePassage& passage : route.passages)
        if (passage.at_m < leg->along_m + 1.0) {
            const std::string what = passage_now(passage.kind, passage.feature, passage.rise_m);
            return answer(phrase("way.next_passage", {{"goal", follow_name_}, {"where", where}, {"passage", what}, {"all", all}}), now_s);
        }
    answer(phrase("way.next", {{"goal", follow_name_}, {"where", where}, {"all", all}}), now_s);
}

void AppCore::follow_on(double now_s) {
    if (!follower_.following()) return;
    pass_stops();
    renew_followed();
    const Vec3 goal = follower_.goal_m();
    const RouteFollower::Said said = follower_.tick(feet_m(), distances());
    if (said.left) {
        // Planned anew from here, and said once.
        const std::string name = follow_name_;
        say(phrase("lead.left_way"), SpeechClass::Contact, now_s);
        if (runs_to(name)) go_on_way({}, now_s);
        else follow_way(goal, name, {}, now_s);
    } else if (!said.text.empty()) {
        if (said.arrived) play(SoundKind::Arrived, now_s);
        if (said.arrived && runs_to(follow_name_) && next_stop(said.text, now_s)) return;
        say(said.text, SpeechClass::Contact, now_s);
        if (!said.arrived) return;
        run_.reset();
        if (guiding_.beacon.name() == follow_name_) guiding_.beacon.clear();
    }
}

}  // namespace handrail
