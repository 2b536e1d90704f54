#include "app/core/wayfinding/route_directions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/wayfinding/route_words.h"
#include "app/core/world/leaf_reach.h"
#include "app/core/world/questions.h"
#include "worlds/base/language.h"
#include "worlds/navigation/stated_rooms.h"

namespace handrail::core {
namespace {

// A walker that is farther from the legs than this has left the route. The distance is twice the deviation that a plan
// permits.
constexpr double kLeft_m = 3.5;
constexpr double kLooked_m = 0.05;
constexpr double kAtMiddle_m = 0.2;  // nearer than this to the middle of a room, the walker is in the room
// Trial walks with errors decide whether a route is still valid from the present place. The share of those that arrive
// must be at least the share when the route was planned, minus kFewer.
constexpr int kTried = 24;
constexpr double kFewer = 0.25, kUnmoved_m = 0.1;
// The planner examines this many places before its first legs are announced. In a house, all legs of a route need fewer
// places.
constexpr int kPlacesForFirst = 150;

// Returns the spans where a route to `end` is over.
navigation::DirectionsGoal goal_of(const DirectionsEnd& end, const DirectionsFloor& floor, const Scene& scene) {
    const navigation::WalkSpace& space = floor.ground.space();
    if (end.room == navigation::kNothing) return navigation::goal_at_place(space, end.place_m, kThere_m);
    return navigation::goal_in_room(space, floor.room_of_span, end.room,
                                    navigation::stated_room_at(scene, end.place_m));
}

double distance_to_stretch(const Vec3& at, const Vec3& a, const Vec3& b) {
    const Vec3 way = b - a;
    const double length2 = glm::dot(way, way);
    const double part = length2 > 0.0 ? std::clamp(glm::dot(at - a, way) / length2, 0.0, 1.0) : 0.0;
    return glm::length(at - (a + way * part));
}

}  // namespace

RouteDirections::RouteDirections(const SessionContext& context, Rooms& rooms, DirectionsGround& ground)
    : SessionPart(context), rooms_(rooms), ground_(ground) {}

void RouteDirections::begin(const DirectionsEnd& end, std::string goal) {
    stop();
    end_ = end;
    goal_ = std::move(goal);
    state_ = State::Planned;
    plan();
}

void RouteDirections::stop() {
    planning_.give_up();
    state_ = State::None;
    wanted_ = false;
    awaited_ = Awaited::Nothing;
    way_ = {};
    at_ = 0;
    end_ = {};
    stopped_.reset();
    uses_ = kNoFeature;
}

void RouteDirections::plan(bool in_parts) {
    awaited_ = Awaited::Nothing;
    const std::shared_ptr<const DirectionsFloor> floor = ground_.floor();
    wanted_ = !floor && ground_.awaited();
    state_ = floor || wanted_ ? State::Planned : State::NoRoute;
    if (!floor) return;
    Planned planned;
    planned.floor = floor;
    planned.goal = way_.floor == floor ? way_.goal : nullptr;
    planned.from_m = context_.avatar.feet_m();
    planned.notch = navigation::nearest_notch(context_.avatar.heading_goal_rad);
    planned.open = ground_.open_now(*floor);
    planning_.begin(
        [planned = std::move(planned), in_parts, end = end_, scene = rooms_.file_scene()](const std::stop_token& stop) {
            Planned made = planned;
            if (!made.goal)
                made.goal = std::make_shared<const navigation::DirectionsGoal>(goal_of(end, *made.floor, *scene));
            made.route =
                made.floor->planner.plan(made.from_m, navigation::notch_heading_rad(made.notch), *made.goal, made.open,
                                         {}, stop, {.begun = {}, .places = in_parts ? kPlacesForFirst : 0});
            return made;
        });
}

// Begins to plan the remaining legs while the person walks the first ones.
void RouteDirections::plan_rest() {
    planning_.begin([planned = way_](const std::stop_token& stop) {
        Planned made = planned;
        made.route = made.floor->planner.plan(made.from_m, navigation::notch_heading_rad(made.notch), *made.goal,
                                              made.open, {}, stop, {.begun = planned.route->legs, .places = 0});
        return made;
    });
}

void RouteDirections::take(Planned planned) {
    way_ = std::move(planned);
    at_ = 0;
    looked_m_ = context_.avatar.feet_m() + Vec3(2.0 * kLooked_m, 0.0, 0.0);
    state_ = way_.route && !way_.route->legs.empty() ? State::Known : State::NoRoute;
    if (state_ == State::Known && !way_.route->whole) plan_rest();
}

// Stores the remaining legs. Returns true if the person has requested them. If the first legs have no continuation,
// plans the route again from the walker's place.
bool RouteDirections::take_rest(Planned planned) {
    if (!planned.route || planned.route->legs.size() <= way_.route->legs.size()) {
        plan(false);
        return false;
    }
    way_.route = std::move(planned.route);
    const Awaited awaited = std::exchange(awaited_, Awaited::Nothing);
    if (awaited == Awaited::NextLeg) ++at_;
    return awaited != Awaited::Nothing;
}

RouteDirections::News RouteDirections::tick() {
    News news;
    if (state_ == State::Planned) {
        if (wanted_) plan();
        if (auto planned = planning_.take()) take(std::move(*planned));
        news.planned = state_ != State::Planned;
    } else if (!whole()) {
        if (auto planned = planning_.take()) news.planned = take_rest(std::move(*planned));
    }
    if (state_ != State::Known) return news;
    const Vec3& feet_m = context_.avatar.feet_m();
    if (glm::length(feet_m - looked_m_) < kLooked_m || !context_.avatar.walker->state().on_ground) return news;
    looked_m_ = feet_m;
    const navigation::BlindWalker body = way_.floor->ground.body_at(feet_m);
    // In a room too narrow to stand inside, such as the end of a footway at stairs, its middle is the goal.
    const bool at_middle = end_.room != navigation::kNothing && glm::length(feet_m - end_.place_m) < kAtMiddle_m;
    news.arrived =
        at_middle || (body.span != navigation::kNothing && (*way_.goal)[body.span] != 0 && in_outline(feet_m));
    if (news.arrived) return news;
    double off_m = kLeft_m + 1.0;
    Vec3 from_m = way_.from_m;
    for (const navigation::DirectionsLeg& leg : way_.route->legs) {
        off_m = std::min(off_m, distance_to_stretch(feet_m, from_m, leg.to_m));
        from_m = leg.to_m;
    }
    news.left = off_m > kLeft_m;
    return news;
}

// Returns true if the walker is inside the stated outline of the room that is the end. A cell of the goal may be as
// wide as a step, so that half of the cell is outside the room.
bool RouteDirections::in_outline(const Vec3& feet_m) const {
    if (end_.room == navigation::kNothing) return true;
    const StatedRoom* const outline = navigation::stated_room_at(*rooms_.file_scene(), end_.place_m);
    return !outline || handrail::holds(*outline, feet_m);
}

LegAt RouteDirections::leg_at(std::size_t which) const {
    const std::vector<navigation::DirectionsLeg>& legs = way_.route->legs;
    int notch = way_.notch;
    for (std::size_t i = 0; i <= which; ++i) notch += legs[i].turn_notches;
    LegAt at{legs[which], 0, {}, {}, {}, 0};
    at.notch = ((notch % navigation::kNotches) + navigation::kNotches) % navigation::kNotches;
    at.planned_from_m = which == 0 ? way_.from_m : legs[which - 1].to_m;
    if (way_.route->whole && which + 1 == legs.size()) {
        at.goal = goal_;
        at.at_passage = end_.at_passage;
    }
    at.from_m = context_.avatar.feet_m();
    at.from_notch = navigation::nearest_notch(context_.avatar.heading_goal_rad);
    return at;
}

// Returns true if the remaining legs still lead to the goal from here, even in trial walks with errors. If only the
// first legs are planned, that is unknown and the result is true.
bool RouteDirections::holds() const {
    if (!way_.route->whole) return true;
    const LegAt first = leg_at(at_);
    // At the place where the route was planned, it is always valid, even if the person has already walked its first
    // leg. A new plan from this place would give the same route again and again.
    if (glm::length(first.from_m - way_.from_m) < kUnmoved_m && way_.open == open_now()) return true;
    navigation::DirectionsRoute left;
    left.shuts_leaves = way_.route->shuts_leaves;
    left.legs.assign(way_.route->legs.begin() + static_cast<std::ptrdiff_t>(at_), way_.route->legs.end());
    left.legs.front().turn_notches = first.notch - first.from_notch;
    const navigation::DoorsOpen open = open_now();
    if (first.leg.end == navigation::PaceEnd::Steps && left.legs.front().steps > 0)
        left.legs.front().steps = spoken_leg(context_, *way_.floor, first, open).steps;
    const double heading_rad = navigation::notch_heading_rad(first.from_notch);
    const navigation::DirectionsPlanner& planner = way_.floor->planner;
    navigation::DirectionsErrors errors;
    errors.start_m = 0.0;
    const double wanted = static_cast<double>(way_.route->came) / navigation::kWordTrials - kFewer;
    return planner.try_out(left, first.from_m, heading_rad, *way_.goal, open, errors, kTried, 1) >= wanted * kTried;
}

std::string RouteDirections::directions() {
    uses_ = kNoFeature;
    if (state_ != State::Known) return {};
    const LegAt leg = leg_at(at_);
    SpokenLeg spoken = spoken_leg(context_, *way_.floor, leg, open_now());
    // The grid for planning is coarser than the walker. In a plan, the walker may slide past an obstacle that stops the
    // real walker. To prevent the same leg from being announced again and again, the spoken directions end here.
    if (stopped_on(leg) && spoken.leaf.empty() && !begin_with_door(spoken)) {
        stop();
        state_ = State::NoRoute;
        return {};
    }
    uses_ = spoken.by_itself && spoken.leaf.empty() ? kNoFeature : spoken.uses;
    shuts_ = !spoken.leaf.empty();
    return leg_words(spoken, distances(context_));
}

FeatureId RouteDirections::door_to_use() const {
    // A person who faces another way may mean another door.
    constexpr double kFaces_rad = 0.8;
    const auto leg_rad = uses_ ? heading_rad() : std::nullopt;
    if (!leg_rad || std::abs(wrap_angle(*leg_rad - context_.avatar.heading_rad)) > kFaces_rad) return kNoFeature;
    const int mover = mover_of(context_.world, uses_);
    if (mover < 0 || shut(context_.world, static_cast<std::uint32_t>(mover)) == shuts_) return kNoFeature;
    return uses_;
}

void RouteDirections::note_stop(FeatureId by) {
    if (state_ != State::Known) return;
    const Feature* const met = context_.world.scene->find(by);
    Stop stop{context_.avatar.feet_m(), context_.avatar.heading_rad};
    if (met && met->kind == FeatureKind::Door) stop.door = by;
    if (stopped_ && stop.door && stopped_->door == stop.door) stop.times = stopped_->times + 1;
    stopped_ = stop;
}

// Changes the leg so that it begins with the door that stopped the walker: the person opens a shut door, or shuts an
// open one whose leaf is in the way. Returns false if no door that opens by hand stopped the walker, or if the same
// door has stopped it too often. A door that the leg names already counts only within reach: if a wall stopped the
// walker before the door, the same leg would stop it there again.
bool RouteDirections::begin_with_door(SpokenLeg& leg) const {
    constexpr int kMostTimes = 4;
    // The leg already says that this door must be opened or opens automatically.
    if (leg.open || leg.by_itself)
        if (const int named = mover_of(context_.world, leg.uses);
            named >= 0 && leaf_in_reach(context_.world, static_cast<std::uint32_t>(named), context_.avatar.feet_m()))
            return true;
    const int mover = stopped_->door ? mover_of(context_.world, stopped_->door) : -1;
    if (mover < 0 || stopped_->times > kMostTimes ||
        !context_.world.scene->movers[static_cast<std::size_t>(mover)].by_hand)
        return false;
    const std::string door = passage_name(context_, navigation::PassageKind::Door, stopped_->door, 0.0);
    if (shut(context_.world, static_cast<std::uint32_t>(mover)))
        leg = {.turn_notches = leg.turn_notches,
               .steps = 1,
               .end = navigation::PaceEnd::Stopped,
               .to = joined(door, phrase("questions.shut")),
               .open = true};
    else leg.leaf = door;
    leg.uses = stopped_->door;
    return true;
}

bool RouteDirections::stopped_on(const LegAt& leg) const {
    constexpr double kHere_m = 0.25, kSameWay_rad = 0.15;
    return stopped_ && glm::length(leg.from_m - stopped_->at_m) < kHere_m &&
           std::abs(wrap_angle(navigation::notch_heading_rad(leg.notch) - stopped_->heading_rad)) < kSameWay_rad;
}

std::string RouteDirections::leg() {
    if (state_ != State::Known) return {};
    awaited_ = Awaited::Nothing;
    const std::size_t last = way_.route->legs.size() - 1;
    const navigation::DoorsOpen open = navigation::doors_on(*way_.route, open_now());
    const auto waits_for_door = [&](std::size_t which) {
        const std::uint32_t door = way_.route->legs[which].door;
        return door != navigation::kNothing && open[door] == navigation::DoorState::Shut;
    };
    const auto is_over = [&](const LegAt& leg) {
        return leg_is_over(*way_.floor, leg, open) ||
               (leg.leg.end == navigation::PaceEnd::Stopped && stopped_on(leg) && !stopped_->door);
    };
    while (at_ < last && !waits_for_door(at_) && is_over(leg_at(at_))) ++at_;
    if (!way_.route->whole && !waits_for_door(at_) && is_over(leg_at(at_))) return await(Awaited::NextLeg);
    if (!holds()) plan();
    return directions();
}

std::string RouteDirections::await(Awaited what) {
    awaited_ = what;
    return {};
}

std::string RouteDirections::next_leg() {
    if (state_ != State::Known) return {};
    const std::uint32_t door = way_.route->legs[at_].door;
    const bool shut = door != navigation::kNothing && open_now()[door] == navigation::DoorState::Shut;
    awaited_ = Awaited::Nothing;
    if (!shut && !way_.route->whole && at_ + 1 == way_.route->legs.size()) return await(Awaited::NextLeg);
    if (!shut) ++at_;
    if (at_ >= way_.route->legs.size() || !holds()) plan();
    return directions();
}

std::vector<std::string> RouteDirections::rest() {
    if (state_ == State::Known && !holds()) plan();
    if (state_ != State::Known) return {};
    if (!way_.route->whole) {
        awaited_ = Awaited::Rest;
        return {};
    }
    std::vector<std::string> legs;
    for (const SpokenLeg& leg : spoken_rest()) legs.push_back(leg_words(leg, distances(context_)));
    return legs;
}

std::optional<std::string> RouteDirections::total_words() const {
    if (state_ != State::Known || !way_.route->whole) return std::nullopt;
    return core::total_words(spoken_rest(), distances(context_));
}

std::optional<RouteDirections::Counts> RouteDirections::counts() const {
    if (state_ != State::Known || !way_.route->whole) return std::nullopt;
    Counts counts;
    const std::vector<SpokenLeg> legs = spoken_rest();
    for (std::size_t i = 0; i < legs.size(); ++i) {
        if (legs[i].turn_notches != 0) ++counts.turns;
        if (way_.route->legs[at_ + i].door != navigation::kNothing) ++counts.doors;
    }
    return counts;
}

std::optional<RouteDirections::LegEnd> RouteDirections::move_on() {
    constexpr double kAtEnd_m = 0.3;
    if (state_ != State::Known) return std::nullopt;
    const std::vector<navigation::DirectionsLeg>& legs = way_.route->legs;
    std::size_t to = at_;
    while (to + 1 < legs.size() && glm::length(legs[to].to_m - context_.avatar.feet_m()) < kAtEnd_m) ++to;
    const bool last = way_.route->whole && to + 1 == legs.size();
    const LegEnd end{legs[to].to_m, navigation::notch_heading_rad(leg_at(to).notch), last};
    at_ = std::min(to + 1, legs.size() - 1);
    return end;
}

std::vector<SpokenLeg> RouteDirections::spoken_rest() const {
    std::vector<SpokenLeg> legs;
    navigation::DoorsOpen open = open_now();
    int notch_before = 0;
    for (std::size_t i = at_; i < way_.route->legs.size(); ++i) {
        LegAt at = leg_at(i);
        if (i > at_) {
            at.from_m = at.planned_from_m;
            at.from_notch = notch_before;
        }
        legs.push_back(spoken_leg(context_, *way_.floor, at, open));
        if (at.leg.door != navigation::kNothing) open[at.leg.door] = navigation::DoorState::Open;
        notch_before = at.notch;
    }
    return legs;
}

std::optional<double> RouteDirections::heading_rad() const {
    if (state_ != State::Known) return std::nullopt;
    return navigation::notch_heading_rad(leg_at(at_).notch);
}

}  // namespace handrail::core
