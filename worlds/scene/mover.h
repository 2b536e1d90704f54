// Parts of the building that move as the map says: doors, lifts, buttons, sliding bridges, trains and turning parts.
// Also the volumes that start them or teleport the person. Plain values of a Scene that say where each part can be and
// what starts it. app/core/world/mover_play moves them.
#pragma once

#include <cstdint>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/geometry/convex.h"
#include "worlds/geometry/placement.h"

namespace handrail {

// A stop of a train: where the origin of its frame is then, and how long it waits there. A negative wait lasts until
// something starts the train again.
struct TrainStop {
    Vec3 at_m{0.0};
    double wait_s = 0.0;
};

inline constexpr std::uint32_t kNoMover = 0xffffffffU;

// Most movers have two ends, described here; at part 0 they are where the file has them. A train goes from stop to
// stop, and a turning part turns without end.
struct Mover {
    FeatureId feature = kNoFeature;
    Vec3 slide_m{0.0};  // the whole travel, if it slides
    // The whole swing, counter-clockwise from above, about the vertical line through pivot_m; 0 if it does not swing.
    double swing_rad = 0.0;
    Vec3 pivot_m{0.0};      // origin of its own frame, world metres
    double travel_s = 1.0;  // time for the whole travel
    double wait_s = 3.0;    // time at the other end before it goes back automatically; negative: it stays
    // It rests at the other end (a lift that waits below), and goes to its place in the file when something starts it.
    bool rests_far = false;
    // The person can start it by touch or key. If false, only movers and switches with this one in their `sets_going`
    // can.
    bool by_hand = true;
    Aabb approach_m;                        // a person who enters this box starts it; empty: nobody does
    std::uint32_t group = 0;                // all movers with the same group move together
    std::vector<std::uint32_t> sets_going;  // the other movers that it starts, as indices into Scene::movers
    // Movers with the same number here may pass through each other, as the map's author intended. kNoMover: only those
    // of its group may.
    std::uint32_t passes = kNoMover;

    // For a lift: the parts of its travel where it stops, rising; empty: it stops at its two ends.
    std::vector<double> halts;
    // For a door of a lift: that lift; the door is open only while the lift is at `lift_part` of its travel.
    std::uint32_t lift = kNoMover;
    double lift_part = 0.0;
    // For a lift's button: the part of its travel to which the lift goes; negative: to the other end.
    double sends_to = -1.0;

    std::vector<TrainStop> stops;   // for a train: its stops in order; it starts at the first one
    int after_last = -1;            // index of the stop that follows the last one; -1: it stays at the last
    double speed_m_per_s = 0.0;     // for a train
    double turn_rad_per_s = 0.0;    // for a turning part; right-handed about turn_axis through pivot_m
    Vec3 turn_axis{0.0, 0.0, 1.0};  // unit
    // For a train or a turning part: it moves from the beginning; if false, something must start it.
    bool starts_going = true;

    // True if it moves until something stops it, and has no end at which it rests.
    bool endless() const noexcept { return stops.size() > 1 || turn_rad_per_s != 0.0; }
    bool moves() const noexcept { return slide_m != Vec3(0.0) || swing_rad != 0.0 || endless(); }
    // The placement of its own frame, 0 <= part <= 1. For an endless mover, the placement at the start.
    Placement at(double part) const {
        if (!stops.empty()) return {stops.front().at_m, {}, 1.0};
        return {pivot_m + slide_m * part, rotation_about({0.0, 0.0, 1.0}, swing_rad * part), 1.0};
    }
};

// A volume that acts when the person enters it.
struct Switch {
    FeatureId volume = kNoFeature;          // the feature of a trigger or teleporter
    std::vector<std::uint32_t> sets_going;  // the movers that it starts, as indices into Scene::movers
    bool once = false;
    bool leads_elsewhere = false;  // true: moves the person to feet_m, facing heading_rad
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
};

}  // namespace handrail
