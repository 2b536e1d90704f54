// Defines parts of the building that move as the map says: doors, lifts, buttons, sliding bridges, trains and turning
// parts. It also defines the volumes that start movers or teleport the person. Plain values of a Scene; they state
// where each part can be and what starts it. app/core/world/mover_play moves the parts.
#pragma once

#include <cstdint>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/geometry/convex.h"
#include "worlds/geometry/placement.h"

namespace handrail {

// A stop of a train: the position of the origin of the train's frame at the stop, and the time for which the train
// waits. After a negative wait, the train waits until something starts it again.
struct TrainStop {
    Vec3 at_m{0.0};
    double wait_s = 0.0;
};

inline constexpr std::uint32_t kNoMover = 0xffffffffU;

// Most movers move between two ends. At part 0 of the travel they are where the file has them. A train goes from stop
// to stop instead, and a turning part turns without end.
struct Mover {
    FeatureId feature = kNoFeature;
    Vec3 slide_m{0.0};  // the whole travel of a sliding mover
    // The whole swing, counter-clockwise seen from above, about the vertical line through pivot_m. 0 if the mover does
    // not swing.
    double swing_rad = 0.0;
    Vec3 pivot_m{0.0};      // origin of the mover's own frame, in world metres
    double travel_s = 1.0;  // time for the whole travel from one end to the other
    // Time that the mover waits at the other end before it returns automatically; negative: it stays there.
    double wait_s = 3.0;
    // The mover rests at the other end (like a lift that waits below) and goes to its place in the file when something
    // starts it.
    bool rests_far = false;
    // The person can start the mover by touch or key. If false, only movers and switches that list it in `sets_going`
    // can start it.
    bool by_hand = true;
    Aabb approach_m;          // if a person enters this box, the mover starts; empty: there is no such box
    std::uint32_t group = 0;  // movers with the same group move together
    std::vector<std::uint32_t> sets_going;  // other movers that this one starts, as indices into Scene::movers
    // Movers with the same value of `passes` may pass through each other, as the map's author intended. If the value is
    // kNoMover, only movers of the same group may do so.
    std::uint32_t passes = kNoMover;

    // For a lift: the parts of its travel at which it stops, in rising order. If empty, it stops at its two ends.
    std::vector<double> halts;
    // For the door of a lift: `lift` is the lift of the door. The door is open only while that lift is at `lift_part`
    // of its travel.
    std::uint32_t lift = kNoMover;
    double lift_part = 0.0;
    // For a lift's button: the part of the travel to which the button sends the lift. Negative: the button sends it to
    // the other end.
    double sends_to = -1.0;

    std::vector<TrainStop> stops;   // for a train: its stops in order; the train starts at the first one
    int after_last = -1;            // index of the stop that follows the last one; -1: the train ends at the last stop
    double speed_m_per_s = 0.0;     // speed of a train
    double turn_rad_per_s = 0.0;    // angular speed of a turning part, right-handed about turn_axis through pivot_m
    Vec3 turn_axis{0.0, 0.0, 1.0};  // axis of a turning part, unit length
    // For a train or a turning part: true if it moves from the beginning. If false, a switch or another mover must
    // start it.
    bool starts_going = true;

    // True if the mover moves until something stops it and has no end at which it rests.
    bool endless() const noexcept { return stops.size() > 1 || turn_rad_per_s != 0.0; }
    bool moves() const noexcept { return slide_m != Vec3(0.0) || swing_rad != 0.0 || endless(); }
    // Returns the placement of the mover's own frame at `part` of its travel, 0 <= part <= 1. For an endless mover,
    // returns the placement at the start.
    Placement at(double part) const {
        if (!stops.empty()) return {stops.front().at_m, {}, 1.0};
        return {pivot_m + slide_m * part, rotation_about({0.0, 0.0, 1.0}, swing_rad * part), 1.0};
    }
};

// A volume that has an effect when the person enters it.
struct Switch {
    FeatureId volume = kNoFeature;          // the feature of the trigger or teleporter
    std::vector<std::uint32_t> sets_going;  // the movers that the switch starts, as indices into Scene::movers
    bool once = false;
    bool leads_elsewhere = false;  // true: the switch moves the person to feet_m, facing heading_rad
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
};

}  // namespace handrail
