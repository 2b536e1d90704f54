#include "app/core/places/prepare_lesson.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "app/core/context/telling.h"
#include "app/core/kept/room_names.h"
#include "app/core/wayfinding/stops.h"
#include "worlds/base/language.h"

namespace handrail {
namespace {

std::string names_of(const std::vector<LessonDraft::Place>& places) {
    std::vector<std::string> names;
    for (const LessonDraft::Place& place : places) names.push_back(place.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

void PrepareLesson::base_here() {
    draft_.base_feet_m = context_.body.feet_m();
    draft_.base_heading_rad = context_.body.heading_rad;
    draft_.base_room.clear();
    if (!rooms_.known() || rooms_.here() == kNothing) return;
    draft_.base_room = own_name(rooms_.graph().rooms[rooms_.here()]);
}

void PrepareLesson::open_at(std::size_t at, double now_s) {
    if (!rooms_.have(now_s)) return;
    if (!std::exchange(begun_, true)) base_here();
    ListSpec list;
    list.title = phrase("prepare.title");
    list.at = at;
    const std::string nothing = phrase("prepare.none");
    list.items = {{phrase("prepare.base"), draft_.base_room.empty() ? phrase("prepare.a_place") : draft_.base_room},
                  {phrase("prepare.landmark"), draft_.landmarks.empty() ? nothing : names_of(draft_.landmarks)},
                  {phrase("prepare.route"), draft_.stops.empty() ? nothing : names_of(draft_.stops)},
                  {phrase("prepare.save"), phrase("prepare.three_sessions")}};
    list.chosen = [this](std::size_t chosen) {
        const double then_s = context_.tick_s;
        switch (chosen) {
            case 0:
                base_here();
                return open_at(1, then_s);
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

// Of those of one name the nearest, as a lesson knows things by their names.
void PrepareLesson::open_landmarks(double now_s) {
    ListSpec list;
    list.title = phrase("prepare.which_landmark");
    std::vector<LessonDraft::Place> places;
    for (const Goal& goal : goals(context_)) {
        const auto named = [&](const LessonDraft::Place& place) { return place.name == goal.name; };
        if (std::any_of(places.begin(), places.end(), named) ||
            std::any_of(draft_.landmarks.begin(), draft_.landmarks.end(), named))
            continue;
        LessonDraft::Place place{goal.name, {}, {}, goal.box_m.centre_m()};
        if (goal.feature) place.thing = context_.world.scene->features[goal.feature.value].name;
        list.items.push_back({goal.name, {}, false});
        places.push_back(std::move(place));
    }
    list.chosen = [this, places](std::size_t at) {
        if (draft_.landmarks.size() < kMostLandmarks) draft_.landmarks.push_back(places[at]);
        open_at(draft_.landmarks.size() < 3 ? 1 : 2, context_.tick_s);
    };
    list.left = [this] { open_at(1, context_.tick_s); };
    context_.open_list(std::move(list), now_s);
}

LessonDraft::Place PrepareLesson::place_of(const Stop& stop) const {
    return {stop.name, stop.thing, stop.thing.empty() ? stop.room : std::string(), stop.place_m};
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
        // Begins at the base; what is passed without a word is no stop of a lesson.
        for (std::size_t i = 1; i < offers[at].stops.size(); ++i)
            if (const Stop& stop = offers[at].stops[i]; !stop.name.empty()) draft_.stops.push_back(place_of(stop));
        open_at(3, context_.tick_s);
    };
    list.left = [this] { open_at(2, context_.tick_s); };
    context_.open_list(std::move(list), now_s);
}

void PrepareLesson::save(double now_s) {
    if (draft_.landmarks.empty() || draft_.stops.empty()) {
        context_.answer(phrase("prepare.not_yet"), now_s);
        return;
    }
    TextSpec title;
    title.question = phrase("prepare.ask_title");
    title.text = phrase("prepare.to", {{"name", draft_.stops.back().name}});
    title.done = [this](const std::string& typed) {
        draft_.title = typed;
        context_.requests.lesson_draft = draft_;
    };
    context_.ask_text(std::move(title), now_s);
}

}  // namespace handrail
