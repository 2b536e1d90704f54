#include "app/core/places/kept_routes.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/wayfinding/whole_route_words.h"
#include "app/core/world/surroundings.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace {

constexpr double kTrailNear_m = 1.0;

std::string names_of(std::span<const Stop> stops) {
    std::vector<std::string> names;
    for (const Stop& stop : stops)
        if (!stop.name.empty()) names.push_back(stop.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

KeptRoutes::KeptRoutes(const SessionContext& context, Rooms& rooms, const PlannedStops& planned)
    : SessionPart(context), rooms_(rooms), planned_(planned) {}

bool KeptRoutes::act(Command command, double now_s) {
    if (command == Command::KeptRoutes) open_all(now_s);
    else if (command == Command::KeepRoute) open_keep(now_s);
    else return false;
    return true;
}

void KeptRoutes::enter_world(double now_s) {
    begins_m_.reset();
    std::vector<Error> faults;
    ways_ = read_saved_routes(context_.additions, faults);
    if (!faults.empty()) context_.say(unreadable_words("ways.unreadable", faults), cues::SpeechClass::Answer, now_s);
}

void KeptRoutes::take_again() {
    std::vector<Error> faults;  // errors to announce when the world has been entered
    ways_ = read_saved_routes(context_.additions, faults);
}

FoundRoute KeptRoutes::look_at(const SavedRoute& way) const {
    return look_up(way, *context_.world.scene, context_.additions, rooms_.navigation(), rooms_.graph());
}

std::string KeptRoutes::fault_words_of(const FoundRoute& found) const {
    return fault_words(found, [this](double way_m) { return distance_words(way_m, distances(context_)); });
}

void KeptRoutes::announce_unfit(double now_s) {
    std::vector<std::string> unfit;
    for (const SavedRoute& way : ways_)
        if (way.world != context_.additions.world_checksum())
            if (const std::string faults = fault_words_of(look_at(way)); !faults.empty())
                unfit.push_back(phrase("ways.unfit_one", {{"way", way.name}, {"faults", faults}}));
    if (std::string words = unfit_words("ways.unfit", unfit, ways_.size()); !words.empty())
        context_.say(std::move(words), cues::SpeechClass::Answer, now_s);
}

bool KeptRoutes::save(double now_s) {
    write_saved_routes(context_.additions, ways_);
    return context_.session_requests.save_additions(now_s);
}

void KeptRoutes::save_and_answer(const std::string& words, double now_s) {
    write_saved_routes(context_.additions, ways_);
    context_.keep_and_answer(words, now_s);
}

void KeptRoutes::save_and_answer_kept(const std::string& name, double now_s) {
    context_.answer(save(now_s) ? phrase("ways.kept", {{"way", name}}) : phrase("guide.not_saved", {{"words", name}}),
                    now_s);
}

void KeptRoutes::follow_room_name(const std::string& before, const std::string& name) {
    if (before.empty()) return;
    bool changed = false;
    for (SavedRoute& way : ways_)
        for (Stop& stop : way.stops)
            if (!stop.room.empty() && lower_ascii(stop.room) == lower_ascii(before)) {
                stop.room = name;
                changed = true;
            }
    if (changed) write_saved_routes(context_.additions, ways_);
}

// Returns the routes that the person could save: the planned route and the walked routes.
std::vector<KeptRoutes::Offer> KeptRoutes::unannounced_offers() const {
    std::vector<Offer> offers;
    if (planned_.stops().size() > 1)
        offers.push_back({phrase("ways.planned"), names_of(planned_.stops()), planned_.stops()});
    if (planned_.chosen().size() > planned_.stops().size())
        offers.push_back({phrase("ways.chosen"), names_of(planned_.chosen()), planned_.chosen()});
    const auto offer = [&](std::string name, std::span<const Vec3> trail) {
        const double way_m = length_of(trail);
        if (way_m < kAtStop_m) return;
        std::vector<Vec3> corners = corners_of(trail, kTrailBend_m);
        for (double bend_m = 2.0 * kTrailBend_m; corners.size() > kMostStops; bend_m *= 2.0)
            corners = corners_of(trail, bend_m);
        std::vector<Stop> stops{stop_at_place(rooms_, corners.front(), phrase("ways.begin"))};
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
            stops.push_back({.name = {}, .place_m = corners[i], .thing = {}, .room = {}, .kept = {}});
        stops.push_back(stop_at_place(rooms_, corners.back(), phrase("ways.end")));
        offers.push_back({std::move(name), distance_words(way_m, distances(context_)), std::move(stops)});
    };
    const std::vector<Vec3>& crumbs = context_.avatar.crumbs_m;
    if (begins_m_) offer(phrase("ways.walked_since_begun"), trail_since(crumbs, *begins_m_, kTrailNear_m));
    offer(phrase("ways.walked"), crumbs);
    for (const Mark& mark : context_.world.marks)
        offer(phrase("ways.walked_since", {{"mark", mark.name}}), trail_since(crumbs, mark.place_m, kTrailNear_m));
    return offers;
}

std::vector<KeptRoutes::Offer> KeptRoutes::offers() const {
    std::vector<Offer> all = unannounced_offers();
    if (planned_.chosen().size() > planned_.stops().size()) std::swap(all[0], all[1]);
    for (auto way = ways_.rbegin(); way != ways_.rend(); ++way)
        all.push_back({way->name, names_of(way->stops), way->stops});
    return all;
}

void KeptRoutes::open_keep(double now_s) {
    if (!rooms_.have(now_s)) return;
    ListSpec list;
    list.title = phrase("ways.keep_which");
    const std::vector<Offer> offers = unannounced_offers();
    for (const Offer& offer : offers) list.items.push_back({offer.name, offer.value, false});
    list.items.push_back({phrase("ways.begin_here"), {}, false});
    list.chosen = [this, offers](std::size_t i) {
        if (i < offers.size()) return request_name(offers[i].stops, context_.tick_s);
        begins_m_ = context_.avatar.feet_m();
        context_.answer(phrase("ways.begun", {{"key", context_.keys.keys_of(Command::KeepRoute)}}), context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

bool KeptRoutes::name_taken(const std::string& name, std::size_t except) const {
    for (std::size_t i = 0; i < ways_.size(); ++i)
        if (i != except && lower_ascii(ways_[i].name) == lower_ascii(name)) return true;
    return false;
}

void KeptRoutes::request_name(const std::vector<Stop>& stops, double now_s) {
    const std::string plain = phrase("ways.name", {{"from", stops.front().name}, {"to", stops.back().name}});
    std::string name = good_name(plain).value_or(stops.back().name);
    for (std::size_t number = 2; name_taken(name, ways_.size()) && number <= ways_.size() + 1; ++number)
        name = phrase("ways.name_again", {{"to", stops.back().name}, {"number", number}});
    TextSpec question;
    question.question = phrase("ways.ask_name", {{"name", name}});
    question.text = name;
    question.done = [this, stops](const std::string& typed) {
        const auto good = free_name(typed, ways_.size(), context_.tick_s);
        if (!good) return;
        ways_.push_back({*good, stops, context_.additions.world_checksum(), {}});
        save_and_answer_kept(*good, context_.tick_s);
    };
    question.left = [this] { context_.answer(phrase("ways.not_kept"), context_.tick_s); };
    context_.request_text(std::move(question), now_s);
}

// Returns the name if it is valid and no other route has it. Otherwise announces the reason for the refusal and returns
// no value.
std::optional<std::string> KeptRoutes::free_name(const std::string& typed, std::size_t except, double now_s) const {
    const auto good = good_name(typed);
    if (!good) {
        context_.answer(good.error().message, now_s);
        return std::nullopt;
    }
    if (!name_taken(*good, except)) return *good;
    context_.answer(phrase("ways.taken", {{"name", *good}}), now_s);
    return std::nullopt;
}

void KeptRoutes::open_all(double now_s) {
    if (ways_.empty())
        return context_.answer(phrase("ways.none", {{"key", context_.keys.keys_of(Command::KeepRoute)}}), now_s);
    if (!rooms_.have(now_s)) return;
    ListSpec list;
    list.title = phrase("ways.title");
    for (const SavedRoute& way : ways_) {
        const std::string between = names_of(std::span(way.stops).subspan(1, way.stops.size() - 2));
        const std::string value = between.empty() ? std::string() : phrase("ways.by_way_of", {{"stops", between}});
        const bool fits = look_at(way).faults.empty();
        list.items.push_back(
            {way.name,
             fits ? value : phrase("ways.may_not_fit", {{"stops", value}, {"any", between.empty() ? "no" : "yes"}}),
             false});
    }
    list.chosen = [this](std::size_t i) { open(i, context_.tick_s); };
    context_.open_list(std::move(list), now_s);
}

void KeptRoutes::open(std::size_t which, double now_s) {
    if (which >= ways_.size()) return;
    const SavedRoute& way = ways_[which];
    const FoundRoute found = look_at(way);
    const std::string faults = fault_words_of(found);
    ListSpec list;
    list.title = faults.empty() ? way.name : phrase("ways.fits_not", {{"way", way.name}, {"faults", faults}});
    std::vector<std::function<void()>> acts;
    const auto add = [&](const char* key, std::function<void()> act) {
        list.items.push_back({phrase(key), {}, false});
        acts.push_back(std::move(act));
    };
    add_routes_to_go(list, acts, way.name, found.stops);
    add("ways.backwards", [this, which] { open_backwards(which, context_.tick_s); });
    add("ways.add_stop", [this, which] { open_add_stop(which, context_.tick_s); });
    if (!faults.empty()) add("ways.take_over", [this, which] { take_over(which, context_.tick_s); });
    add("ways.rename", [this, which] { request_new_name(which, context_.tick_s); });
    add("ways.delete", [this, which] { remove(which, context_.tick_s); });
    list.chosen = [acts](std::size_t i) { acts[i](); };
    context_.open_list(std::move(list), now_s);
}

void KeptRoutes::add_routes_to_go(ListSpec& list, std::vector<std::function<void()>>& acts, const std::string& name,
                                  const std::vector<Stop>& stops) {
    list.items.push_back({phrase("ways.hear"), {}, false});
    acts.emplace_back(
        [this, name, stops] { context_.answer(whole_route_words(context_, rooms_, name, stops), context_.tick_s); });
    list.items.push_back({phrase("ways.follow"), {}, false});
    acts.emplace_back([this, stops] { on_go(stops, false, context_.tick_s); });
    list.items.push_back({phrase("ways.lead"), {}, false});
    acts.emplace_back([this, stops] { on_go(stops, true, context_.tick_s); });
}

void KeptRoutes::open_backwards(std::size_t which, double now_s) {
    std::vector<Stop> stops = look_at(ways_[which]).stops;
    std::reverse(stops.begin(), stops.end());
    ListSpec list;
    list.title = phrase("ways.backwards_title", {{"way", ways_[which].name}});
    std::vector<std::function<void()>> acts;
    add_routes_to_go(list, acts, list.title, stops);
    list.chosen = [acts](std::size_t i) { acts[i](); };
    context_.open_list(std::move(list), now_s);
}

// Opens a list of what can become a stop: the present place, a room, or a thing.
void KeptRoutes::open_add_stop(std::size_t which, double now_s) {
    if (ways_[which].stops.size() >= kMostStops)
        return context_.answer(phrase("ways.full", {{"most", kMostStops}}), now_s);
    ListSpec list;
    list.title = phrase("ways.which_stop");
    list.items.push_back({phrase("ways.here"), {}, false});
    const navigation::RoomGraph& graph = rooms_.graph();
    for (const navigation::Room& room : graph.rooms)
        list.items.push_back(
            {sentence_case(room.name),
             distance_words(glm::length(room.middle_m - context_.avatar.feet_m()), distances(context_)), false});
    const std::vector<Goal> things = goals(context_);
    for (const Goal& goal : things) list.items.push_back({goal.name, where_words(context_, goal.box_m), false});
    list.chosen = [this, which, things, rooms = graph.rooms.size()](std::size_t i) {
        if (i == 0)
            return add_stop(which, stop_at_place(rooms_, context_.avatar.feet_m(), phrase("ways.end")),
                            context_.tick_s);
        if (i <= rooms)
            return add_stop(which, stop_in_room(rooms_, static_cast<std::uint32_t>(i - 1)), context_.tick_s);
        add_stop(which, stop_at_goal(context_, rooms_, things[i - rooms - 1], ways_[which].stops.back().place_m),
                 context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

void KeptRoutes::add_stop(std::size_t which, Stop stop, double now_s) {
    SavedRoute& way = ways_[which];
    // After the change, the route gets the checksum of the present world. All its stops must fit this world first,
    // because they are not checked again afterwards.
    if (way.world != context_.additions.world_checksum() && !look_at(way).faults.empty())
        return context_.answer(phrase("ways.take_over_first", {{"way", way.name}}), now_s);
    way.world = context_.additions.world_checksum();
    const std::string name = stop.name, way_name = way.name;
    way.stops.push_back(std::move(stop));
    // Saving may replace `ways_`, so the code above has copied the names.
    save_and_answer(phrase("ways.stop_added", {{"way", way_name}, {"stop", name}}), now_s);
}

// Stores the new places of stops that were found elsewhere. If a thing or room no longer exists, removes its name from
// the stop but keeps the stop's place.
void KeptRoutes::take_over(std::size_t which, double now_s) {
    SavedRoute& way = ways_[which];
    FoundRoute found = look_at(way);
    for (const StopFault& fault : found.faults) {
        Stop& stop = found.stops[fault.stop];
        if (fault.kind == StopFault::Kind::ThingMissing) stop.thing.clear();
        if (fault.kind == StopFault::Kind::RoomMissing) stop.room.clear();
        if (fault.kind == StopFault::Kind::ThingMoved)
            stop.thing_m = glm::length(nearest_place(goal_of(context_, stop).box_m, stop.place_m) - stop.place_m);
    }
    way.stops = std::move(found.stops);
    way.world = context_.additions.world_checksum();
    const std::string name = way.name;
    save_and_answer_kept(name, now_s);  // the name was copied, because saving may replace `ways_`
}

void KeptRoutes::request_new_name(std::size_t which, double now_s) {
    TextSpec question;
    question.question = phrase("ways.ask_name", {{"name", ways_[which].name}});
    question.text = ways_[which].name;
    question.done = [this, which](const std::string& typed) {
        const auto good = free_name(typed, which, context_.tick_s);
        if (!good) return;
        ways_[which].name = *good;
        save_and_answer(*good, context_.tick_s);
    };
    context_.request_text(std::move(question), now_s);
}

void KeptRoutes::remove(std::size_t which, double now_s) {
    const std::string name = ways_[which].name;
    ways_.erase(ways_.begin() + static_cast<std::ptrdiff_t>(which));
    save_and_answer(phrase("ways.deleted", {{"way", name}}), now_s);
}

}  // namespace handrail::core
