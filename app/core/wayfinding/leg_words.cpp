#include "app/core/wayfinding/leg_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "app/core/context/context_words.h"
#include "app/core/wayfinding/leaf_ahead.h"
#include "app/core/wayfinding/leg_clues.h"
#include "app/core/world/questions.h"
#include "app/core/world/walker_meets.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kFarthest_m = 40.0;  // greatest length of a leg that ends at an obstacle
constexpr double kMeets_m = 0.6;      // how far beyond the walker's stop the obstacle is searched for
constexpr double kFine_m = 0.05;      // spacing of the points at which the floor is examined for risers
constexpr double kPathEvery_m = 0.4;  // spacing of the path points at which door leaves are searched for
constexpr double kAhead_m = 0.01;
constexpr double kRiser_m = 0.06;
constexpr double kLeft_part = 0.5;  // share of a step; if less than this remains, the leg is over

std::string notch_words(int notches) {
    constexpr std::array kFromLeft{"route.turn_round",          "leg.turn_7_left",          "route.turn_sharp_left",
                                   "leg.turn_5_left",           "route.turn_left",          "leg.turn_3_left",
                                   "route.turn_half_left",      "route.turn_slightly_left", "leg.straight_on",
                                   "route.turn_slightly_right", "route.turn_half_right",    "leg.turn_3_right",
                                   "route.turn_right",          "leg.turn_5_right",         "route.turn_sharp_right",
                                   "leg.turn_7_right",          "route.turn_round"};
    return capitalised(phrase(kFromLeft[static_cast<std::size_t>(std::clamp(notches, -8, 8) + 8)]));
}

Vec2 level(const Vec3& way) { return {way.x, way.y}; }

double spoken_metres(int steps, const DistanceWords& how) { return std::round(2.0 * steps * how.step_length_m) / 2.0; }

// Returns the distance from `from_m` to `to_m` in the direction of the leg.
double along_m(int notch, const Vec3& from_m, const Vec3& to_m) {
    const Vec3 ahead = forward_of_heading(navigation::notch_heading_rad(notch));
    return glm::dot(level(to_m - from_m), level(ahead));
}

// Returns the counted steps from the present place: the planned number, corrected by how far the person is ahead or
// behind.
double counted_left(const DirectionsFloor& floor, const LegAt& at) {
    const double aside_m = along_m(at.notch, at.planned_from_m, at.from_m);
    return at.leg.steps - aside_m / floor.step_m;
}

struct Walked {
    navigation::Paced paced;
    navigation::BlindWalker body;
    int risers = 0;
    double to_stairs_m = 0.0;
    std::vector<Vec3> path_m;  // points from the present place on, every kPathEvery_m
};
Walked walk(const DirectionsFloor& floor, const LegAt& at, const navigation::DoorsOpen& open,
            double most_m = kFarthest_m) {
    Walked walked;
    walked.body = floor.ground.body_at(at.from_m);
    if (walked.body.span == navigation::kNothing) return walked;
    walked.path_m.push_back(at.from_m);
    double z = floor.ground.feet_m(walked.body).z, way_m = 0.0, kept_m = 0.0;
    walked.paced = floor.ground.walk(
        walked.body, navigation::notch_heading_rad(at.notch), most_m, at.leg.end, open,
        [&](const navigation::BlindWalker& body) {
            way_m += kFine_m;
            const double here = floor.ground.feet_m(body).z;
            if (std::abs(here - z) > kRiser_m) {
                if (walked.risers == 0) walked.to_stairs_m = way_m;
                ++walked.risers;
            }
            z = here;
            if (way_m - kept_m > kPathEvery_m) {
                walked.path_m.push_back(floor.ground.feet_m(body));
                kept_m = way_m;
            }
            return true;
        },
        kFine_m);
    walked.path_m.push_back(floor.ground.feet_m(walked.body));
    // The obstacle that stops the walker is just ahead.
    if (walked.paced.stopped)
        walked.path_m.push_back(walked.path_m.back() +
                                kAhead_m * forward_of_heading(navigation::notch_heading_rad(at.notch)));
    return walked;
}

// Adds the flight of stairs that the leg crosses, if there is one.
void add_flight(SpokenLeg& spoken, const DirectionsFloor& floor, const Walked& walked) {
    if (walked.risers < 2) return;
    spoken.risers = walked.risers;
    spoken.up = walked.paced.rise_m > 0.0;
    spoken.to_stairs = static_cast<int>(std::lround(walked.to_stairs_m / floor.step_m));
}

std::string door_words(const SessionContext& context, const navigation::DirectionsDoor& door, bool shut) {
    const std::string name = passage_name(context, navigation::PassageKind::Door, door.feature, 0.0);
    return shut ? joined(name, phrase("questions.shut")) : name;
}

// Adds the open leaf that blocks the leg, if there is one. The person shuts it before anything else.
void add_leaf(SpokenLeg& spoken, const SessionContext& context, std::span<const Vec3> path_m) {
    const FeatureId door = leaf_ahead(context, path_m);
    if (!door) return;
    spoken.uses = door;
    spoken.leaf = leaf_name(context, door);
}

}  // namespace

std::string leg_words(const SpokenLeg& leg, const DistanceWords& how) {
    std::string text = phrase("route.first", {{"turn", notch_words(leg.turn_notches)}}) + " ";
    const std::string distance = how.in_steps ? phrase("words.steps", {{"steps", leg.steps}})
                                              : phrase("words.metres", {{"metres", spoken_metres(leg.steps, how)}});
    if (leg.end == navigation::PaceEnd::Stairs) {
        const std::string flight = phrase(leg.risers == 0 ? (leg.up ? "leg.ramp_up" : "leg.ramp_down")
                                                          : (leg.up ? "leg.stairs_up" : "leg.stairs_down"),
                                          {{"risers", leg.risers}});
        text += leg.steps == 0 ? phrase("leg.flight_here", {{"flight", flight}})
                               : phrase("leg.flight_in", {{"flight", flight}, {"steps", leg.steps}});
    } else if (leg.end == navigation::PaceEnd::Stopped) {
        text += leg.to.empty() ? phrase("leg.until_stopped", {{"distance", distance}})
                               : phrase("leg.until_met", {{"distance", distance}, {"what", leg.to}});
    } else {
        text += capitalised(
            phrase(leg.to.empty() ? "route.leg" : "route.leg_to", {{"distance", distance}, {"what", leg.to}}));
    }
    if (leg.end != navigation::PaceEnd::Stairs && leg.risers > 0) {
        const std::string flight = phrase(leg.up ? "leg.stairs_up" : "leg.stairs_down", {{"risers", leg.risers}});
        text += " " + phrase("leg.over_flight", {{"flight", flight}, {"steps", leg.to_stairs}});
    }
    // Only one instruction is given at a time. While the leaf is in the way, the person cannot reach the door.
    if (!leg.leaf.empty()) text += " " + capitalised(phrase("leg.leaf_in_way", {{"door", leg.leaf}}));
    else if (leg.open) text += " " + phrase("leg.open_it");
    else if (leg.by_itself) text += " " + phrase("leg.opens_by_itself");
    if (!leg.clue.empty()) text += " " + leg.clue;
    return text;
}

std::string total_words(std::span<const SpokenLeg> legs, const DistanceWords& how) {
    int steps = 0, risers = 0;
    double metres = 0.0;
    for (const SpokenLeg& leg : legs) {
        steps += leg.steps;
        metres += spoken_metres(leg.steps, how);
        if (leg.end == navigation::PaceEnd::Stairs) risers += leg.risers;
    }
    const std::string distance =
        how.in_steps ? phrase("words.steps", {{"steps", steps}}) : phrase("words.metres", {{"metres", metres}});
    return risers == 0 ? distance : phrase("leg.and_stairs", {{"distance", distance}, {"risers", risers}});
}

SpokenLeg spoken_leg(const SessionContext& context, const DirectionsFloor& floor, const LegAt& at,
                     const navigation::DoorsOpen& open) {
    SpokenLeg spoken;
    spoken.end = at.leg.end;
    const int turn = ((at.notch - at.from_notch) % navigation::kNotches + navigation::kNotches) % navigation::kNotches;
    spoken.turn_notches = turn > navigation::kNotches / 2 ? turn - navigation::kNotches : turn;
    spoken.to = at.goal;
    const navigation::DirectionsDoor* door =
        at.leg.door == navigation::kNothing ? nullptr : &floor.ground.doors()[at.leg.door];
    if (door) {
        const bool shut = open[at.leg.door] == navigation::DoorState::Shut;
        if (!at.at_passage) spoken.to = door_words(context, *door, shut);
        // A route that ends in front of a door does not lead through it.
        const bool through = shut && at.goal.empty();
        spoken.open = through && context.world.scene->movers[door->mover].by_hand;
        spoken.by_itself = through && !spoken.open;
        if (through) spoken.uses = door->feature;
    }
    if (at.leg.end == navigation::PaceEnd::Steps) {
        spoken.steps = std::max(1, static_cast<int>(std::lround(counted_left(floor, at))));
        const Walked walked = walk(floor, at, open, spoken.steps * floor.step_m);
        add_leaf(spoken, context, walked.path_m);
        add_flight(spoken, floor, walked);
        spoken.clue = leg_clue(context, floor, at.from_m, at.leg.to_m, at.notch, at.leg.door);
        return spoken;
    }
    const Walked walked = walk(floor, at, open);
    add_leaf(spoken, context, walked.path_m);
    if (at.leg.end == navigation::PaceEnd::Stairs) {
        spoken.up = at.leg.rise_m > 0.0;
        spoken.risers = walked.risers >= 2 ? walked.risers : 0;
        spoken.steps = static_cast<int>(std::lround(walked.to_stairs_m / floor.step_m));
        return spoken;
    }
    spoken.steps = std::max(1, static_cast<int>(std::lround(walked.paced.walked_m / floor.step_m)));
    add_flight(spoken, floor, walked);
    if (at.at_passage) return spoken;
    if (!door && walked.body.span != navigation::kNothing)
        if (const auto met =
                walker_meets(*context.world.solids, floor.ground.feet_m(walked.body), context.avatar.walker->size(),
                             navigation::notch_heading_rad(at.notch), kMeets_m))
            spoken.to = name_of(context, met->feature);
    if (!door && spoken.to == at.goal) spoken.to.clear();
    return spoken;
}

bool leg_is_over(const DirectionsFloor& floor, const LegAt& at, const navigation::DoorsOpen& open) {
    if (at.leg.end == navigation::PaceEnd::Steps) return counted_left(floor, at) < kLeft_part;
    const Walked walked = walk(floor, at, open);
    if (at.leg.end == navigation::PaceEnd::Stairs) return !walked.paced.climbed;
    return walked.paced.walked_m < kLeft_part * floor.step_m;
}

}  // namespace handrail::core
