// AppCore's part on kept ways: keeping the one that was planned or walked, hearing, following and being led along a kept one, stop after stop. App thread only.
#include <algorithm>
#include <cmath>

#include "app/core/app_core.h"
#include "app/core/hand_way.h"
#include "audio-cues/plan/speakable.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

constexpr double kAtStop_m = 1.5;     // who is so near a stop need not be led to it
constexpr double kGoesOn_m = 3.0;     // a way planned from so near the end of the one before goes on with it
constexpr double kPassed_m = 0.6;     // of a hand that is led past a stop
constexpr double kPassedEar_m = 0.3;  // along the route, before a stop counts as passed
constexpr double kTrailNear_m = 1.0;
constexpr double kWaist_m = 1.0;

double level_m(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y); }

bool near_stop(const Stop& stop, const Vec3& place_m, double near_m) {
    return level_m(stop.place_m, place_m) <= near_m && std::abs(stop.place_m.z - place_m.z) < 2.0;
}

double heading_of(const Route& route, bool end) {
    const std::vector<Vec3>& points = route.points_m;
    const Vec3 way = end ? points.back() - points[points.size() - 2] : points[1] - points[0];
    return std::atan2(way.x, way.y);
}

std::string names_of(std::span<const Stop> stops) {
    std::vector<std::string> names;
    for (const Stop& stop : stops)
        if (!stop.name.empty()) names.push_back(stop.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

// ---- what is kept ----

void AppCore::enter_ways(double now_s) {
    run_.reset();
    planned_stops_.clear();
    way_begins_m_.reset();
    std::vector<Error> faults;
    ways_ = read_ways(side_file_, faults);
    if (!faults.empty()) say(unreadable_words("ways.unreadable", faults), SpeechClass::Answer, now_s);
    // Where nobody looks for the rooms beside, a way that may not fit is the reason to look now.
    const bool doubtful = std::any_of(ways_.begin(), ways_.end(), [&](const SavedWay& way) { return way.world != side_file_.world_checksum(); });
    if (doubtful && !rooms_beside_ && rooms_known()) notice_room(now_s, true);
}

FoundWay AppCore::found_way(const SavedWay& way) { return look_up(way, *scene_, side_file_, rooms_->navigation(), rooms_->graph()); }

std::string AppCore::way_faults(const FoundWay& found) const {
    return fault_words(found, [this](double way_m) { return distance_words(way_m, distances()); });
}

// Once the rooms are known.
void AppCore::tell_unfit_ways(double now_s) {
    std::vector<std::string> unfit;
    for (const SavedWay& way : ways_)
        if (way.world != side_file_.world_checksum())
            if (const std::string faults = way_faults(found_way(way)); !faults.empty())
                unfit.push_back(phrase("ways.unfit_one", {{"way", way.name}, {"faults", faults}}));
    if (std::string words = unfit_words("ways.unfit", unfit, ways_.size()); !words.empty()) say(std::move(words), SpeechClass::Answer, now_s);
}

void AppCore::save_ways(double now_s) {
    write_ways(side_file_, ways_);
    save_additions(now_s);
}

// A room has another name: the stops in it know it by that one from here on. Empty: it has none that files know it by.
void AppCore::rename_room_in_ways(const std::string& before, const std::string& name) {
    if (before.empty()) return;
    bool changed = false;
    for (SavedWay& way : ways_)
        for (Stop& stop : way.stops)
            if (!stop.room.empty() && lower_ascii(stop.room) == lower_ascii(before)) {
                stop.room = name;
                changed = true;
            }
    if (changed) write_ways(side_file_, ways_);
}

// ---- stops ----

// The room there, as the map or the person calls it; else what it is near to; else `otherwise`.
Stop AppCore::stop_at_place(const Vec3& place_m, const std::string& otherwise) {
    Stop stop;
    stop.place_m = place_m;
    stop.name = otherwise;
    const RoomGraph& graph = rooms_->graph();
    if (const std::uint32_t room = room_at(graph, rooms_->navigation().space(), place_m); room != kNothing) {
        stop.name = sentence_case(graph.rooms[room].name);
        stop.room = known_as(graph.rooms[room]);
    }
    if (!good_name(stop.name)) stop.name = otherwise;
    return stop;
}

Stop AppCore::stop_in_room(std::uint32_t room) { return stop_at_place(rooms_->graph().rooms[room].middle_m, phrase("ways.end")); }

// Where one stands before it, coming from that place.
Stop AppCore::stop_at_goal(const Goal& goal, const Vec3& from_m) {
    const Route route = walk_to_thing(rooms_->navigation(), *body_world_, from_m, goal.box_m, goal.feature);
    const Vec3 nearest = nearest_place(goal.box_m, from_m);
    const Vec3 place = route.reaches ? route.points_m.back() : rooms_->navigation().nearest_place(nearest).value_or(nearest);
    Stop stop = stop_at_place(place, phrase("ways.end"));
    if (good_name(goal.name)) stop.name = goal.name;
    if (const Feature* feature = scene_->find(goal.feature); feature && !feature->name.empty()) {
        stop.thing = feature->name;
        stop.thing_m = glm::length(nearest_place(feature->bounds_m, place) - place);
    }
    return stop;
}

// The person wants to go there: what is planned one after the other, each from where the one before ended, is one way.
void AppCore::note_planned(Stop stop, const Vec3& from_m) {
    const Vec3 here = rooms_->navigation().nearest_place(from_m).value_or(feet_m());
    if (planned_stops_.empty() || !near_stop(planned_stops_.back(), here, kGoesOn_m)) planned_stops_.assign(1, stop_at_place(here, phrase("ways.begin")));
    if (planned_stops_.back().name == stop.name && near_stop(planned_stops_.back(), stop.place_m, kAtStop_m)) return;
    planned_stops_.push_back(std::move(stop));
    if (planned_stops_.size() > kMostStops) planned_stops_.erase(planned_stops_.begin());
}

// ---- keeping ----

void AppCore::open_keep_way(double now_s) {
    if (!have_rooms(now_s)) return;
    ListSpec list;
    list.title = phrase("ways.keep_which");
    std::vector<std::vector<Stop>> offers;
    if (planned_stops_.size() > 1) {
        list.items.push_back({phrase("ways.planned"), names_of(planned_stops_), false});
        offers.push_back(planned_stops_);
    }
    const auto offer = [&](std::string name, std::span<const Vec3> trail) {
        const double way_m = length_of(trail);
        if (way_m < kAtStop_m) return;
        std::vector<Vec3> corners = corners_of(trail, kTrailBend_m);
        for (double bend_m = 2.0 * kTrailBend_m; corners.size() > kMostStops; bend_m *= 2.0) corners = corners_of(trail, bend_m);
        std::vector<Stop> stops{stop_at_place(corners.front(), phrase("ways.begin"))};
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) stops.push_back({.name = {}, .place_m = corners[i], .thing = {}, .room = {}, .kept = {}});
        stops.push_back(stop_at_place(corners.back(), phrase("ways.end")));
        list.items.push_back({std::move(name), distance_words(way_m, distances()), false});
        offers.push_back(std::move(stops));
    };
    const std::vector<Vec3>& crumbs = walking_.crumbs_m;
    if (way_begins_m_) offer(phrase("ways.walked_since_begun"), trail_since(crumbs, *way_begins_m_, kTrailNear_m));
    offer(phrase("ways.walked"), crumbs);
    for (const Mark& mark : guiding_.marks) offer(phrase("ways.walked_since", {{"mark", mark.name}}), trail_since(crumbs, mark.place_m, kTrailNear_m));
    list.items.push_back({phrase("ways.begin_here"), {}, false});
    list.chosen = [this, offers](std::size_t i) {
        if (i < offers.size()) return ask_way_name(offers[i], last_tick_s_);
        way_begins_m_ = feet_m();
        answer(phrase("ways.begun", {{"key", keys_.keys_of(Command::KeepWay)}}), last_tick_s_);
    };
    open_list(std::move(list), now_s);
}

bool AppCore::way_name_taken(const std::string& name, std::size_t except) const {
    for (std::size_t i = 0; i < ways_.size(); ++i)
        if (i != except && lower_ascii(ways_[i].name) == lower_ascii(name)) return true;
    return false;
}

void AppCore::ask_way_name(const std::vector<Stop>& stops, double now_s) {
    const std::string plain = phrase("ways.name", {{"from", stops.front().name}, {"to", stops.back().name}});
    std::string name = good_name(plain).value_or(stops.back().name);
    for (std::size_t number = 2; way_name_taken(name, ways_.size()) && number <= ways_.size() + 1; ++number)
        name = phrase("ways.name_again", {{"to", stops.back().name}, {"number", number}});
    TextSpec question;
    question.question = phrase("ways.ask_name", {{"name", name}});
    question.text = name;
    question.done = [this, stops](const std::string& typed) {
        const auto good = free_way_name(typed, ways_.size(), last_tick_s_);
        if (!good) return;
        ways_.push_back({*good, stops, side_file_.world_checksum(), {}});
        save_ways(last_tick_s_);
        answer(phrase("ways.kept", {{"way", *good}}), last_tick_s_);
    };
    question.left = [this] { answer(phrase("ways.not_kept"), last_tick_s_); };
    ask_text(std::move(question), now_s);
}

// A good name that no other way has; else says why not.
std::optional<std::string> AppCore::free_way_name(const std::string& typed, std::size_t except, double now_s) {
    const auto good = good_name(typed);
    if (!good) {
        answer(good.error().message, now_s);
        return std::nullopt;
    }
    if (!way_name_taken(*good, except)) return *good;
    answer(phrase("ways.taken", {{"name", *good}}), now_s);
    return std::nullopt;
}

// ---- choosing ----

void AppCore::open_ways(double now_s) {
    if (ways_.empty()) return answer(phrase("ways.none", {{"key", keys_.keys_of(Command::KeepWay)}}), now_s);
    if (!have_rooms(now_s)) return;
    ListSpec list;
    list.title = phrase("ways.title");
    for (const SavedWay& way : ways_) {
        const std::string between = names_of(std::span(way.stops).subspan(1, way.stops.size() - 2));
        const std::string value = between.empty() ? std::string() : phrase("ways.by_way_of", {{"stops", between}});
        const bool fits = found_way(way).faults.empty();
        list.items.push_back({way.name, fits ? value : phrase("ways.may_not_fit", {{"stops", value}, {"any", between.empty() ? "no" : "yes"}}), false});
    }
    list.chosen = [this](std::size_t i) { open_way(i, last_tick_s_); };
    open_list(std::move(list), now_s);
}

void AppCore::open_way(std::size_t which, double now_s) {
    if (which >= ways_.size()) return;
    const SavedWay& way = ways_[which];
    const FoundWay found = found_way(way);
    const std::string faults = way_faults(found);
    ListSpec list;
    list.title = faults.empty() ? way.name : phrase("ways.fits_not", {{"way", way.name}, {"faults", faults}});
    std::vector<std::function<void()>> acts;
    const auto add = [&](const char* key, std::function<void()> act) {
        list.items.push_back({phrase(key), {}, false});
        acts.push_back(std::move(act));
    };
    add_ways_to_go(list, acts, way.name, found.stops);
    add("ways.backwards", [this, which] { open_way_backwards(which, last_tick_s_); });
    add("ways.add_stop", [this, which] { open_add_stop(which, last_tick_s_); });
    if (!faults.empty()) add("ways.take_over", [this, which] { take_over_way(which, last_tick_s_); });
    add("ways.rename", [this, which] { ask_new_way_name(which, last_tick_s_); });
    add("ways.delete", [this, which] { delete_way(which, last_tick_s_); });
    list.chosen = [acts](std::size_t i) { acts[i](); };
    open_list(std::move(list), now_s);
}

void AppCore::add_ways_to_go(ListSpec& list, std::vector<std::function<void()>>& acts, const std::string& name, const std::vector<Stop>& stops) {
    list.items.push_back({phrase("ways.hear"), {}, false});
    acts.emplace_back([this, name, stops] { tell_way(name, stops, last_tick_s_); });
    list.items.push_back({phrase("ways.follow"), {}, false});
    acts.emplace_back([this, stops] { begin_way(stops, false, last_tick_s_); });
    list.items.push_back({phrase("ways.lead"), {}, false});
    acts.emplace_back([this, stops] { begin_way(stops, true, last_tick_s_); });
}

void AppCore::open_way_backwards(std::size_t which, double now_s) {
    std::vector<Stop> stops = found_way(ways_[which]).stops;
    std::reverse(stops.begin(), stops.end());
    ListSpec list;
    list.title = phrase("ways.backwards_title", {{"way", ways_[which].name}});
    std::vector<std::function<void()>> acts;
    add_ways_to_go(list, acts, list.title, stops);
    list.chosen = [acts](std::size_t i) { acts[i](); };
    open_list(std::move(list), now_s);
}

// Here, a room, or a thing.
void AppCore::open_add_stop(std::size_t which, double now_s) {
    if (ways_[which].stops.size() >= kMostStops) return answer(phrase("ways.full", {{"most", kMostStops}}), now_s);
    ListSpec list;
    list.title = phrase("ways.which_stop");
    list.items.push_back({phrase("ways.here"), {}, false});
    const RoomGraph& graph = rooms_->graph();
    for (const Room& room : graph.rooms)
        list.items.push_back({sentence_case(room.name), distance_words(glm::length(room.middle_m - feet_m()), distances()), false});
    const std::vector<Goal> things = goals();
    for (const Goal& goal : things) list.items.push_back({goal.name, where_words(goal.box_m), false});
    list.chosen = [this, which, things, rooms = graph.rooms.size()](std::size_t i) {
        if (i == 0) return add_stop(which, stop_at_place(feet_m(), phrase("ways.end")), last_tick_s_);
        if (i <= rooms) return add_stop(which, stop_in_room(static_cast<std::uint32_t>(i - 1)), last_tick_s_);
        add_stop(which, stop_at_goal(things[i - rooms - 1], ways_[which].stops.back().place_m), last_tick_s_);
    };
    open_list(std::move(list), now_s);
}

void AppCore::add_stop(std::size_t which, Stop stop, double now_s) {
    SavedWay& way = ways_[which];
    // Looked up again as it is now, since it gets the checksum of this world with the new stop.
    if (way.world != side_file_.world_checksum() && !found_way(way).faults.empty()) return answer(phrase("ways.take_over_first", {{"way", way.name}}), now_s);
    way.world = side_file_.world_checksum();
    const std::string name = stop.name;
    way.stops.push_back(std::move(stop));
    save_ways(now_s);
    answer(phrase("ways.stop_added", {{"way", way.name}, {"stop", name}}), now_s);
}

// What was found elsewhere is kept there; what is gone is forgotten, its place stays.
void AppCore::take_over_way(std::size_t which, double now_s) {
    SavedWay& way = ways_[which];
    FoundWay found = found_way(way);
    for (const StopFault& fault : found.faults) {
        Stop& stop = found.stops[fault.stop];
        if (fault.kind == StopFault::Kind::ThingGone) stop.thing.clear();
        if (fault.kind == StopFault::Kind::RoomGone) stop.room.clear();
        if (fault.kind == StopFault::Kind::ThingMoved) stop.thing_m = glm::length(nearest_place(goal_of(stop).box_m, stop.place_m) - stop.place_m);
    }
    way.stops = std::move(found.stops);
    way.world = side_file_.world_checksum();
    save_ways(now_s);
    answer(phrase("ways.kept", {{"way", way.name}}), now_s);
}

void AppCore::ask_new_way_name(std::size_t which, double now_s) {
    TextSpec question;
    question.question = phrase("ways.ask_name", {{"name", ways_[which].name}});
    question.text = ways_[which].name;
    question.done = [this, which](const std::string& typed) {
        const auto good = free_way_name(typed, which, last_tick_s_);
        if (!good) return;
        ways_[which].name = *good;
        save_ways(last_tick_s_);
        answer(*good, last_tick_s_);
    };
    ask_text(std::move(question), now_s);
}

void AppCore::delete_way(std::size_t which, double now_s) {
    const std::string name = ways_[which].name;
    ways_.erase(ways_.begin() + static_cast<std::ptrdiff_t>(which));
    save_ways(now_s);
    answer(phrase("ways.deleted", {{"way", name}}), now_s);
}

// ---- hearing and going ----

// All of it in words, from its first stop on, each stop with the way to it.
void AppCore::tell_way(const std::string& name, const std::vector<Stop>& stops, double now_s) {
    WayRun along{stops, 1, false, {}, 0};
    Vec3 from = stops.front().place_m;
    double heading_rad = heading_rad_, all_m = 0.0;
    bool first = !near_stop(stops.front(), feet_m(), kAtStop_m);  // who stands elsewhere does not know what right and left would be
    std::string legs;
    while (along.next < stops.size()) {
        const Route route = plan_through(rooms_->navigation(), from, along.places());
        const std::string& goal = stops[along.goal()].name;
        if (route.points_m.size() >= 2) {
            const double facing = std::exchange(first, false) ? heading_of(route, false) : heading_rad;
            const std::string words = route_words(route, nodes_to(route, goal), facing, distances());
            if (route.reaches) legs += " " + phrase("rooms.way", {{"goal", goal}, {"route", words}});
            heading_rad = heading_of(route, true);
            all_m += route.length_m;
        }
        if (!route.reaches) legs += " " + phrase("rooms.not_reached", {{"goal", goal}, {"short_of", distance_words(route.short_of_m, distances())}});
        from = stops[along.goal()].place_m;
        along.next = along.goal() + 1;
    }
    answer(phrase("ways.whole", {{"way", name}, {"from", stops.front().name}, {"distance", distance_words(all_m, distances())}}) + legs, now_s);
}

// From the first stop on, or to it first; by the hand or by ear.
void AppCore::begin_way(const std::vector<Stop>& stops, bool by_hand, double now_s) {
    end_guidance();
    follower_.stop();
    const Vec3 here = by_hand ? finding_place_m() : feet_m();
    run_ = WayRun{stops, near_stop(stops.front(), here, kAtStop_m) ? 1U : 0U, by_hand, {}, 0};
    go_on_way({}, now_s);
}

Goal AppCore::goal_of(const Stop& stop) const {
    const Vec3 at = stop.place_m + Vec3(0.0, 0.0, kWaist_m);
    Goal goal{stop.name, {at, at}, kNoFeature};
    if (stop.thing.empty()) return goal;
    double near_m = 1e9;
    for (std::uint32_t i = 0; i < scene_->features.size(); ++i) {
        const Feature& feature = scene_->features[i];
        if (feature.name != stop.thing || feature.bounds_m.empty()) continue;
        if (const double away_m = glm::length(nearest_place(feature.bounds_m, stop.place_m) - stop.place_m); away_m < near_m) {
            near_m = away_m;
            goal.box_m = feature.bounds_m;
            goal.feature = FeatureId{i};
        }
    }
    return goal;
}

// To the next stop that has a name. `first` is said before all else.
void AppCore::go_on_way(const std::string& first, double now_s) {
    const Stop& stop = run_->stops[run_->goal()];
    if (run_->by_hand) return lead_to(goal_of(stop), first, now_s);
    Route route = way_on(feet_m());
    follow_route(std::move(route), stop.name, first, now_s);
}

// The rest of the way from there to the stop one is going to.
Route AppCore::way_on(const Vec3& from_m) {
    run_->planned = run_->next;
    return plan_through(rooms_->navigation(), from_m, run_->places(), &run_->at_m);
}

bool AppCore::runs_to(const std::string& goal) const { return run_ && run_->stops[run_->goal()].name == goal; }

// The stops without a name that lie behind one.
void AppCore::pass_stops() {
    if (!run_) return;
    WayRun& run = *run_;
    if (run.by_hand) {
        const Vec3 hand = finding_place_m();
        while (run.next < run.goal() && near_stop(run.stops[run.next], hand, kPassed_m)) ++run.next;
    } else if (follower_.following()) {
        const auto passed = [&] {
            const std::size_t i = run.next - run.planned;
            return run.next < run.goal() && i < run.at_m.size() && run.at_m[i] < follower_.along_m() + kPassedEar_m;
        };
        while (passed()) ++run.next;
    }
}

// A stop is reached: true when the way goes on from it, which has been told then. `words` tell that one is there.
bool AppCore::next_stop(const std::string& words, double now_s) {
    if (!run_) return false;
    run_->next = run_->goal() + 1;
    if (run_->next >= run_->stops.size()) {
        run_.reset();
        return false;
    }
    go_on_way(words, now_s);
    return true;
}

}  // namespace handrail
