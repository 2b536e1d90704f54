#include "app/core/places/prepare_lesson.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/core/context/context_words.h"
#include "app/core/kept/questions.h"
#include "app/core/kept/room_names.h"
#include "app/core/wayfinding/stops.h"
#include "app/core/world/surroundings.h"
#include "worlds/base/language.h"
#include "worlds/navigation/route_place.h"

namespace handrail::core {
namespace {

std::string names_of(const std::vector<LessonDraft::Place>& places) {
    std::vector<std::string> names;
    for (const LessonDraft::Place& place : places) names.push_back(place.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

// Returns true if the person stands on the thing. A learner cannot point to such a thing, or say when it is reached.
bool under_feet(const Aabb& box_m, const Vec3& feet_m) {
    constexpr double kUnderFeet_m = 0.3, kSameStorey_m = 2.5;
    const Vec3 off_m = nearest_place(box_m, feet_m) - feet_m;
    return std::hypot(off_m.x, off_m.y) < kUnderFeet_m && std::abs(off_m.z) < kSameStorey_m;
}

}  // namespace

void PrepareLesson::base_here() {
    draft_.base_feet_m = context_.avatar.feet_m();
    draft_.base_heading_rad = context_.avatar.heading_rad;
    draft_.base_room.clear();
    base_name_.clear();
    if (!rooms_.known() || rooms_.here() == navigation::kNothing) return;
    const navigation::Room& room = rooms_.graph().rooms[rooms_.here()];
    base_name_ = navigation::own_name(room);
    if (!navigation::is_outside(room, rooms_.space(), *rooms_.file_scene())) draft_.base_room = base_name_;
}

void PrepareLesson::open_at(std::size_t at, double now_s) {
    if (!rooms_.have(now_s)) return;
    if (!std::exchange(begun_, true)) base_here();
    ListSpec list;
    list.title = phrase("prepare.title");
    list.at = at;
    const std::string nothing = phrase("prepare.none");
    list.items = {{phrase("prepare.base"), base_name_.empty() ? phrase("prepare.a_place") : base_name_},
                  {phrase("prepare.landmark"), draft_.landmarks.empty() ? nothing : names_of(draft_.landmarks)},
                  {phrase("prepare.route"), draft_.stops.empty() ? nothing : names_of(draft_.stops)},
                  {phrase("prepare.save"), phrase("prepare.three_sessions")}};
    list.stays_open = true;  // The list stays open, even after an announcement that something is missing.
    list.chosen = [this](std::size_t chosen) {
        const double then_s = context_.tick_s;
        switch (chosen) {
            case 0:
                base_here();
                return open_again(1);
            case 1:
                return open_landmarks(then_s);
            case 2:
                return open_routes(then_s);
            default:
                return save(then_s);
        }
    };
    context_.open_list(std::move(list), now_s);
}

void PrepareLesson::open_again(std::size_t at) {
    context_.lists.dialogue.close_all();
    open_at(at, context_.tick_s);
}

// If several things have the same name, only the nearest is listed, because a lesson identifies things by name.
void PrepareLesson::open_landmarks(double now_s) {
    if (draft_.landmarks.size() >= kMostLandmarks)
        return context_.answer(phrase("prepare.enough", {{"count", kMostLandmarks}}), now_s);
    ListSpec list;
    list.title = phrase("prepare.which_landmark");
    std::vector<LessonDraft::Place> places;
    for (const Goal& goal : goals(context_)) {
        const auto named = [&](const LessonDraft::Place& place) { return place.name == goal.name; };
        if (std::any_of(places.begin(), places.end(), named) ||
            std::any_of(draft_.landmarks.begin(), draft_.landmarks.end(), named) ||
            under_feet(goal.box_m, draft_.base_feet_m))
            continue;
        LessonDraft::Place place{goal.name, {}, {}, goal.box_m.centre_m(), goal.box_m};
        if (goal.feature) place.thing = context_.world.scene->features[goal.feature.value].name;
        list.items.push_back({goal.name, {}, false});
        places.push_back(std::move(place));
    }
    list.chosen = [this, places](std::size_t at) {
        draft_.landmarks.push_back(places[at]);
        open_again(draft_.landmarks.size() < 3 ? 1 : 2);
    };
    context_.open_list(std::move(list), now_s);
}

LessonDraft::Place PrepareLesson::place_of(const Stop& stop) const {
    return {stop.name, stop.thing, stop.thing.empty() ? stop.room : std::string(), stop.place_m, {}};
}

void PrepareLesson::open_routes(double now_s) {
    ListSpec list;
    list.title = phrase("prepare.which_route");
    std::vector<Offer> offers = routes ? routes() : std::vector<Offer>{};
    for (const Offer& offer : offers) list.items.push_back({offer.name, offer.stops.back().name, false});
    if (offers.empty()) {
        context_.answer(phrase("prepare.no_route"), now_s);
        return;
    }
    list.chosen = [this, offers](std::size_t at) {
        draft_.stops.clear();
        // The route begins at the base. Stops without a name do not become stops of the lesson.
        for (std::size_t i = 1; i < offers[at].stops.size(); ++i)
            if (const Stop& stop = offers[at].stops[i]; !stop.name.empty()) draft_.stops.push_back(place_of(stop));
        open_again(3);
    };
    context_.open_list(std::move(list), now_s);
}

// A landmark far from the whole route has no place in the order of the route. Two landmarks that the route passes at
// the same spot have no order either.
std::vector<std::string> PrepareLesson::on_route(const std::vector<LessonDraft::Place>& requested) const {
    constexpr double kComesTo_m = 6.0, kSameStorey_m = 2.5, kAtOnce_m = 1.0;
    std::vector<Vec3> places;
    for (const LessonDraft::Place& stop : draft_.stops) places.push_back(stop.place_m);
    const navigation::Route route = plan_through(rooms_.navigation(), draft_.base_feet_m, places);
    std::vector<std::pair<double, std::string>> met;
    for (const LessonDraft::Place& landmark : requested) {
        Vec3 foot = landmark.box_m.centre_m();
        foot.z = landmark.box_m.min_m.z;
        if (route.points_m.empty()) break;
        const navigation::RoutePlace at = navigation::nearest_on_path(route.points_m, foot);
        const Vec3 there = navigation::place_along(route.points_m, at.along_m),
                   near = nearest_place(landmark.box_m, there);
        if (std::hypot(near.x - there.x, near.y - there.y) < kComesTo_m && std::abs(near.z - there.z) < kSameStorey_m)
            met.emplace_back(at.along_m, landmark.name);
    }
    std::stable_sort(met.begin(), met.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> names;
    double last_m = -kAtOnce_m;
    for (const auto& [along_m, name] : met) {
        if (along_m - last_m >= kAtOnce_m) names.push_back(name);
        last_m = along_m;
    }
    return names;
}

void PrepareLesson::save(double now_s) {
    if (draft_.landmarks.empty() || draft_.stops.empty()) {
        context_.answer(phrase("prepare.not_yet"), now_s);
        return;
    }
    // Landmarks at the base are left out here, because the base may have been moved onto a landmark after that landmark
    // was chosen.
    std::vector<LessonDraft::Place> requested;
    for (const LessonDraft::Place& landmark : draft_.landmarks)
        if (!under_feet(landmark.box_m, draft_.base_feet_m)) requested.push_back(landmark);
    if (requested.empty())
        return context_.answer(phrase("prepare.under_feet", {{"names", names_of(draft_.landmarks)}}), now_s);
    draft_.requested.clear();
    for (const LessonDraft::Place& landmark : requested) draft_.requested.push_back(landmark.name);
    draft_.on_route = on_route(requested);
    std::vector<Error> faults;
    draft_.questions.clear();
    for (const PlaceQuestion& question : read_questions(context_.additions, faults))
        draft_.questions.push_back(question.text);
    draft_.world_checksum = context_.additions.world_checksum();
    TextSpec title;
    title.question = phrase("prepare.ask_title");
    title.text = phrase("prepare.to", {{"name", draft_.stops.back().name}});
    title.done = [this](const std::string& typed) {
        context_.lists.dialogue.close_all();
        draft_.title = typed;
        context_.requests.lesson_draft = draft_;
    };
    context_.request_text(std::move(title), now_s);
}

}  // namespace handrail::core
