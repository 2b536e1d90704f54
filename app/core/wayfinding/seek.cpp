#include "app/core/wayfinding/seek.h"

#include <algorithm>
#include <cmath>

#include "app/core/context/context_words.h"
#include "app/core/context/soundscape.h"
#include "app/core/wayfinding/hand_path.h"
#include "app/core/world/body_heights.h"
#include "app/core/world/surroundings.h"
#include "worlds/base/language.h"
#include "worlds/navigation/route_place.h"

namespace handrail::core {
namespace {

constexpr double kLookEvery_s = 0.1;  // interval between two checks for obstacles and shut doors along a route
// Height above the floor, radius and height of the shape for checks ahead. The shape is so high above the floor that it
// passes over stairs.
constexpr double kOverSteps_m = 0.35, kNarrow_m = 0.2, kNarrowHeight_m = 1.2;
constexpr double kBackOnRoute_m = 1.0;  // how far ahead along the route a person who is off the route is led
// A tool guides straight to the thing if the route is at most kHardlyLonger times the straight line plus kAllowance_m.
constexpr double kHardlyLonger = 1.25, kAllowance_m = 1.0;
// Distance along the route within which a shut door is announced, about an arm's length.
constexpr double kDoorAhead_m = 1.0;
// If the hand moves away by more than this share of its movement, the sound for moving away is played.
constexpr double kPast = 0.1;
constexpr double kPitch = 0.5;  // rise of the pitch if the hand approaches straight: half, which is a musical fifth
// World metres of the walker's distance that correspond to one hand metre, as at the scale of a room.
constexpr double kWalker_m_per_hand_m = 60.0;

std::string along_route_words(const SoughtRoute& way, const DistanceWords& how) {
    return phrase("lead.along_way", {{"distance", distance_words(way.left_m(), how)}});
}

}  // namespace

void Seek::enter_world() {
    beacon_ = {};
    warmer_ = {};
    beacon_along_ = warmer_along_ = {};
    turning_first_ = false;
}

void Seek::start_beacon(const Goal& goal) {
    beacon_.set(goal.name, goal.box_m, goal.feature);
    beacon_along_ = {};
    doors_.forget_announced();
}

void Seek::start_warmer(const Goal& goal) {
    warmer_.set(goal.name, goal.box_m, goal.feature);
    warmer_along_ = {};
    doors_.forget_announced();
}

// Plans the route from the present place. A later plan uses the same place next to the thing, so that the place need
// not be searched for again.
void Seek::plan(AlongRoute& along, const Sought& sought, bool hand, double now_s) {
    SoughtRoute& way = along.way;
    along.planned_in = context_.world.scene;
    along.jump = context_.hands.pose.jump;
    const Goal goal{sought.name(), sought.thing_m(), sought.feature()};
    if (hand) {
        const HandRoute lead = plans_.for_hand(goal, servo::GuidancePath::kMostPoints);
        if (!lead.reaches || lead.points_m.size() < 2) return way.no_route(now_s);
        return way.plan(lead.points_m, {}, 0.0, finding_place_m(context_), now_s);
    }
    navigation::Navigation& navigation = rooms_.navigation();
    const Vec3& feet_m = context_.avatar.feet_m();
    navigation::Route route;
    if (way.known()) route = navigation.plan(feet_m, way.points_m().back());
    if (!route.reaches) route = walk_to_thing(navigation, *context_.world.solids, feet_m, goal.box_m, goal.feature);
    if (!route.reaches) return way.no_route(now_s);
    const Vec3 end = route.points_m.back(), up(0.0, 0.0, kWaist_m);
    way.plan(route.points_m, route.passages, glm::length(nearest_place(goal.box_m, end + up) - end - up), feet_m,
             now_s);
}

// Follows the route of a tool, and plans it again if necessary. Returns true if the route is known and the person wants
// to use it.
bool Seek::keep(AlongRoute& along, const Sought& sought, bool hand, double now_s) {
    if (!context_.settings.guidance.along_way) return false;
    SoughtRoute& way = along.way;
    const Vec3 at = hand ? finding_place_m(context_) : context_.avatar.feet_m(), up(0.0, 0.0, hand ? 0.0 : kWaist_m);
    way.follow(at, hand ? 1.0 : navigation::kHeightCountsForWalkers, [&](const Vec3& place) {
        return free_line(*context_.world.solids, at + up, place + up, sought.feature());
    });
    const bool changed = along.planned_in != context_.world.scene || (hand && along.jump != context_.hands.pose.jump);
    if (way.wants_plan(changed, now_s) && rooms_.known()) plan(along, sought, hand, now_s);
    return way.known();
}

// Returns the start of the line of sight.
Vec3 Seek::from_m(bool hand) const {
    return hand ? finding_place_m(context_) : context_.avatar.feet_m() + Vec3(0.0, 0.0, kWaist_m);
}

// Returns true if nothing is between the person and the thing, and the route is hardly longer than the straight line.
// So the result is false for a thing on the storey above that is visible over the banister.
bool Seek::straight_before(const SoughtRoute& way, const Sought& sought, bool hand) const {
    const Vec3 from = from_m(hand), place = place_on(sought.thing_m(), from);
    return way.left_m() <= kHardlyLonger * glm::length(place - from) + kAllowance_m &&
           free_line(*context_.world.solids, from, place, sought.feature()) && (hand || walker_gets_to(sought));
}

// Returns what a narrow shape meets on the straight line from the walker to `soles_m`.
TraceHit Seek::met_on_route(const Vec3& soles_m) const {
    const Vec3 over(0.0, 0.0, kOverSteps_m);
    return context_.world.solids->trace(context_.avatar.feet_m() + over, soles_m + over,
                                        WalkerShape{kNarrow_m, kNarrowHeight_m});
}

// Returns true if a person who walks straight to the middle of the thing reaches it. Returns false if the person would
// hit the side of a doorway through which the thing is visible.
bool Seek::walker_gets_to(const Sought& sought) const {
    const Vec3 middle = sought.thing_m().centre_m();
    const TraceHit met = met_on_route({middle.x, middle.y, context_.avatar.feet_m().z});
    if (!met.hit || met.feature == sought.feature()) return true;
    return glm::length(nearest_place(sought.thing_m(), met.end_m) - met.end_m) <= Beacon::kArrived_m;
}

std::string Seek::words(AlongRoute& along, const Sought& sought, bool hand, double now_s) {
    const SoughtRoute& way = along.way;
    if (keep(along, sought, hand, now_s))
        return straight_before(way, sought, hand) ? std::string() : along_route_words(way, distances(context_));
    const Vec3 from = from_m(hand);
    if (free_line(*context_.world.solids, from, place_on(sought.thing_m(), from), sought.feature())) return {};
    if (!context_.settings.guidance.along_way) return phrase("lead.straight");
    return way.tried() ? phrase("lead.no_way") : plans_.why_none() + " " + phrase("lead.straight");
}

void Seek::announce_route(const AlongRoute& along, double now_s) {
    context_.announce(cues::SpeechTopic::Summary, along_route_words(along.way, distances(context_)), now_s);
}

void Seek::announce_anew(double now_s) {
    const bool hand = context_.hands.known();
    if (beacon_.on() && keep(beacon_along_, beacon_, false, now_s) &&
        !straight_before(beacon_along_.way, beacon_, false))
        announce_route(beacon_along_, now_s);
    if (warmer_.on() && keep(warmer_along_, warmer_, hand, now_s)) announce_route(warmer_along_, now_s);
}

// ---- every tick ----

// Returns the place from which the beacon sounds while the person must go there first. If the beacon sounds from the
// thing, returns no value.
std::optional<Vec3> Seek::beacon_turning(double now_s) {
    AlongRoute& along = beacon_along_;
    const bool tried = along.way.tried();
    if (!keep(along, beacon_, false, now_s)) return std::nullopt;
    if (!tried && !straight_before(along.way, beacon_, false)) announce_route(along, now_s);
    if (now_s - along.looked_s >= kLookEvery_s) {
        along.looked_s = now_s;
        doors_.announce_ahead(along.way.ahead_m(kDoorAhead_m), now_s);
        turning_first_ = along.way.left_m() > Beacon::kArrived_m && !straight_before(along.way, beacon_, false);
        // A person slightly off the route is led back to it, round the obstacle.
        const Vec3 turning = along.way.next_turning_m();
        const TraceHit met = met_on_route(turning);
        const Feature* thing = met.hit ? context_.world.scene->find(met.feature) : nullptr;
        turning_m_ =
            met.hit && !(thing && thing->kind == FeatureKind::Door) ? along.way.ahead_m(kBackOnRoute_m) : turning;
    }
    if (!turning_first_) return std::nullopt;
    return turning_m_ + Vec3(0.0, 0.0, kWaist_m);
}

bool Seek::tick_beacon(double now_s) {
    if (!beacon_.on()) return false;
    const cues::Listener ears{context_.avatar.ears_m(), context_.avatar.heading_rad};
    const auto way_db = [&](const Vec3& place) { return muffling_db(*context_.world.solids, ears.ears_m, place); };
    Beacon::Beat beat = beacon_.tick(context_.avatar.feet_m(), ears, way_db, !context_.hands.tuning.panic, now_s,
                                     beacon_turning(now_s));
    if (beat.sound) context_.cues.cue(std::move(*beat.sound));
    return beat.arrived;
}

bool Seek::tick_warmer(double now_s) {
    if (!warmer_.on()) return false;
    AlongRoute& along = warmer_along_;
    const bool hand = context_.hands.known(), tried = along.way.tried();
    const Vec3 place = finding_place_m(context_), thing = nearest_place(warmer_.thing_m(), place);
    const bool known = keep(along, warmer_, hand, now_s);
    if (known && !tried) announce_route(along, now_s);
    const double straight_m = glm::length(thing - place), per_m = hand ? scale(context_) : kWalker_m_per_hand_m;
    // A person who is near the thing has not found it if a wall is in between.
    bool found = straight_m <= (hand ? Warmer::kFound_hand_m * per_m : Beacon::kArrived_m) &&
                 (!known || (!hand && along.way.left_m() <= Beacon::kArrived_m) ||
                  free_line(*context_.world.solids, place, place_on(warmer_.thing_m(), place), warmer_.feature()));
    const servo::ToolState& tool = context_.hands.tool;
    if (hand && tool.touches() && warmer_.feature()) found = found || tool.touched() == warmer_.feature();
    if (known && hand) doors_.announce_touched(now_s);
    if (known && !hand && now_s - along.looked_s >= kLookEvery_s) {
        along.looked_s = now_s;
        doors_.announce_ahead(along.way.ahead_m(kDoorAhead_m), now_s);
    }
    const double left_m = known ? std::max(straight_m, along.way.announced_m()) : straight_m;
    const Warmer::Beat beat = warmer_.tick(left_m / per_m, place / per_m, found, !context_.hands.tuning.panic, now_s);
    if (beat.sound) {
        cues::CueRequest tick = sound_at(beat.nearer < -kPast ? cues::SoundKind::Colder : cues::SoundKind::Warmer,
                                         context_.avatar.ears_m(), now_s);
        tick.pitch = 1.0 + kPitch * beat.nearer;
        context_.cues.cue(std::move(tick));
    }
    return beat.found;
}

}  // namespace handrail::core
