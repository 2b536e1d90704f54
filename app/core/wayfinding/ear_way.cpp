#include "app/core/wayfinding/ear_way.h"

#include <cmath>
#include <utility>

#include "app/core/wayfinding/leg.h"
#include "app/core/wayfinding/way_words.h"
#include "worlds/base/language.h"
#include "worlds/navigation/reach.h"

namespace handrail {

void EarWay::follow_to(const Vec3& goal_m, const std::string& name, const std::string& first, double now_s) {
    follow(rooms_.navigation().plan(context_.body.feet_m(), goal_m), name, first, now_s);
}

void EarWay::follow(Route route, const std::string& name, const std::string& first, double now_s) {
    follower_.stop();
    std::string goal = name, words = first.empty() ? first : first + ' ';
    if (route.points_m.empty()) return context_.answer(words + phrase("rooms.no_way_no_floor"), now_s);
    if (!route.reaches) {
        const std::uint32_t end = room_at(rooms_.graph(), rooms_.space(), route.points_m.back());
        const std::string short_of = distance_words(route.short_of_m, distances(context_));
        words += end == kNothing
                     ? phrase("rooms.not_reached", {{"goal", name}, {"short_of", short_of}})
                     : phrase("rooms.not_reached_in",
                              {{"goal", name}, {"room", rooms_.graph().rooms[end].name}, {"short_of", short_of}});
        if (route.points_m.size() < 2) return context_.answer(words, now_s);
        words += ' ';
        goal = phrase("rooms.nearest_place_to", {{"goal", name}});
    }
    std::vector<RouteNode> nodes = nodes_to(context_, route, goal);
    const std::string how = route_words(route, nodes, context_.body.heading_rad, distances(context_));
    context_.answer(words + phrase("rooms.way", {{"goal", goal}, {"route", how}}), now_s);
    context_.events.tell(Led{goal, LedBy::Ear}, now_s);
    name_ = goal;
    to_nearest_ = !route.reaches;
    plans_.know(route.points_m);
    planned_in_ = context_.world.scene;
    follower_.follow(std::move(route), std::move(nodes));
}

void EarWay::renew() {
    if (std::exchange(planned_in_, context_.world.scene) == context_.world.scene ||
        !rooms_.navigation().meets_leaf(follower_.ahead_m()))
        return;
    const Vec3& feet_m = context_.body.feet_m();
    Route route = plans_.runs_to(name_) ? plans_.on(feet_m) : rooms_.navigation().plan(feet_m, follower_.goal_m());
    if (!route.reaches || route.points_m.size() < 2) return;
    std::vector<RouteNode> nodes = nodes_to(context_, route, name_);
    plans_.know(route.points_m);
    follower_.follow(std::move(route), std::move(nodes));
}

void EarWay::tell_on(double now_s) const {
    if (!follower_.following()) return context_.answer(phrase("way.none"), now_s);
    const Vec3& feet_m = context_.body.feet_m();
    const auto leg = next_leg(
        plans_.runs_to(name_) ? plans_.looked_at(feet_m) : rooms_.navigation().plan(feet_m, follower_.goal_m()), feet_m,
        0.5 * context_.settings.walk.step_length_m);
    if (!leg) return context_.answer(phrase("way.no_floor"), now_s);
    const Vec3 off = leg->to_m - feet_m;
    const Route& route = leg->route;
    const std::string where = where_words(context_, std::hypot(off.x, off.y), std::atan2(off.x, off.y)),
                      all = sentence_case(distance_words(route.length_m, distances(context_)));
    for (const RoutePassage& passage : route.passages)
        if (passage.at_m < leg->along_m + 1.0) {
            const std::string what = passage_now(context_, passage.kind, passage.feature, passage.rise_m);
            return context_.answer(
                phrase("way.next_passage", {{"goal", name_}, {"where", where}, {"passage", what}, {"all", all}}),
                now_s);
        }
    context_.answer(phrase("way.next", {{"goal", name_}, {"where", where}, {"all", all}}), now_s);
}

}  // namespace handrail
